#include "sim/explore/precision/exact_skipping_walk.h"

#include <algorithm>

namespace cuesta {

OracleHit<BigInt> exact_skipping_walk(const ExactRay<BigInt>& ray, std::span<const OracleMap> levels) {
  const MapShape& shape = levels[0].shape;
  const auto start = oracle_start(ray, shape);
  if (!start) return {};
  ExactTime<BigInt> now = *start;
  int64_t k = ray.x.cell_at(now), l = ray.y.cell_at(now);
  const int root = static_cast<int>(levels.size()) - 1;
  for (int level = root; now < ray.t_max;) {
    const OracleMap& map = levels[static_cast<size_t>(level)];
    const OracleSpan u = oracle_span(k, ray.x.sign < 0, shape.width, level, shape.address_mode);
    const OracleSpan v = oracle_span(l, ray.y.sign < 0, shape.height, level, shape.address_mode);
    const ExactTime<BigInt> out = earlier(ray.x.plane(u.upper), ray.y.plane(v.upper));
    if (level == 0) {
      OracleHit<BigInt> answer = oracle_ask_cell(ray, map, *start, u, v);
      if (answer.hit) return answer;
    } else if (ray.z.reaches(map.values[static_cast<size_t>(v.stored) * map.width + u.stored]) < out) {
      --level;  // somewhere in the node the ray may be below its highest texel
      continue;
    }
    if (!out.is_finite()) return {};
    now = out;
    k = ray.x.cell_at(now);
    l = ray.y.cell_at(now);
    level = std::min(level + 1, root);
  }
  return {};
}

}  // namespace cuesta
