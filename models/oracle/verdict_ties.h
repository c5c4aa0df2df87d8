#pragma once

// The bodies of verdict.h's template: what "tie" means.

#include "models/oracle/verdict.h"

namespace cuesta {

/// The leaf walk with the cells of the chosen axes closed above instead of below, which only a ray that runs
/// along a plane can tell: it then belongs to the cell on the plane's other side. Moving such a ray back by the
/// smallest step there is says the same.
template <class Int>
ExactAxis<Int> closed_above(ExactAxis<Int> axis) {
  if (axis.sign != 0) return axis;
  axis.origin = Int(axis.origin * 2 - 1);
  axis.unit = Int(axis.unit * 2);
  return axis;
}

/// When the ray first touches the closed cell's solid, from any side; nothing when it never does.
template <class Int>
std::optional<ExactTime<Int>> first_touch(const ExactRay<Int>& ray, const OracleMap& map, const OracleSpan& u,
                                          const OracleSpan& v) {
  ExactTime<Int> t_in{Int(0), Int(1)};
  ExactTime<Int> t_out = ray.t_max;
  const auto enter = [&t_in](const ExactTime<Int>& t) { t_in = later(t_in, t); };
  const auto leave = [&t_out](const ExactTime<Int>& t) { t_out = earlier(t_out, t); };
  enter(ray.x.plane(u.lower));
  enter(ray.y.plane(v.lower));
  leave(closed_above(ray.x).plane(u.upper));
  leave(closed_above(ray.y).plane(v.upper));
  const ExactTime<Int> surface =
      ray.z.reaches(map.values[static_cast<size_t>(v.stored) * map.width + u.stored]);
  if (ray.z.sign < 0) {
    enter(ray.z.reaches(map.shape.full_scale()));
    if (map.shape.address_mode == AddressMode::kBorder) {
      const ExactTime<Int> bottom = ray.z.reaches(0);
      if (ray.x.plane(0) > bottom || ray.y.plane(0) > bottom) return std::nullopt;
    }
    enter(surface);
  } else if (ray.z.sign > 0) {
    leave(surface);
  } else {
    const Int above = Int(Int(map.values[static_cast<size_t>(v.stored) * map.width + u.stored]) * ray.z.unit);
    if (above < ray.z.origin) return std::nullopt;
  }
  if (t_in > t_out) return std::nullopt;
  return t_in;
}

/// Is `answer` the first hit when touching counts or edges are closed on the other side? An answer may pass an
/// earlier touch, as the oracle's own convention does. `truth`: the leaf walk's.
template <class Int>
bool is_tie(const ExactRay<Int>& ray, const OracleMap& map, const OracleHit<Int>& truth,
            const JudgedAnswer& answer) {
  std::optional<ExactTime<Int>> touch;
  if (answer.hit) {
    const MapShape& shape = map.shape;
    const bool outside = shape.address_mode == AddressMode::kBorder &&
                         (answer.i < 0 || answer.j < 0 || answer.i >= map.width || answer.j >= map.height);
    if (outside) return false;
    touch = first_touch(
        ray, map, oracle_span_of_node(answer.i, ray.x.sign < 0, shape.width, map.level, shape.address_mode),
        oracle_span_of_node(answer.j, ray.y.sign < 0, shape.height, map.level, shape.address_mode));
  }
  for (int sides = 0; sides < 4; ++sides) {
    // Only a ray that does not move along an axis can tell on which side its edges are closed.
    if (((sides & 1) != 0 && ray.x.sign != 0) || ((sides & 2) != 0 && ray.y.sign != 0)) continue;
    ExactRay<Int> other = ray;
    if (sides & 1) other.x = closed_above(ray.x);
    if (sides & 2) other.y = closed_above(ray.y);
    const OracleHit<Int> found = sides == 0 ? truth : oracle_leaf_walk(other, map);
    if (found.hit == answer.hit && (!found.hit || (found.i == answer.i && found.j == answer.j))) return true;
    if (touch && (!found.hit || *touch <= found.t)) return true;
  }
  return false;
}

template <class Int>
Verdict judge(const ExactRay<Int>& ray, const OracleMap& map, const OracleHit<Int>& truth,
              const JudgedAnswer& answer) {
  if (truth.hit == answer.hit && (!truth.hit || (truth.i == answer.i && truth.j == answer.j))) {
    return Verdict::kExact;
  }
  if (!ray.dead && is_tie(ray, map, truth, answer)) return Verdict::kTie;
  if (!answer.hit) return Verdict::kMissed;
  if (truth.hit && answer.t > ray.in_machine_units(truth.t)) return Verdict::kBehind;
  return Verdict::kWrongCell;
}

}  // namespace cuesta
