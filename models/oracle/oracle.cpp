#include "models/oracle/oracle.h"

#include <algorithm>

namespace cuesta {

OracleMap oracle_map(const HeightGrid& grid, const MapShape& shape) {
  return oracle_map(grid.texels.data(), grid.width, grid.height, 0, shape);
}

OracleMap oracle_map(const uint16_t* values, int width, int height, int level, const MapShape& shape) {
  const size_t count = static_cast<size_t>(width) * static_cast<size_t>(height);
  return {values, width, height, level, *std::max_element(values, values + count), shape};
}

OracleSpan oracle_span(int64_t mirrored_leaf, bool mirrored, int size, int level) {
  const int64_t leaf = mirrored ? size - 1 - mirrored_leaf : mirrored_leaf;
  const int64_t tile = floor_divide<int64_t>(leaf, size);
  const int64_t node = (leaf - tile * size) >> level;
  const int64_t nodes_per_tile = (size + (int64_t{1} << level) - 1) >> level;
  const int64_t first = tile * size + (node << level);
  const int64_t last = tile * size + std::min<int64_t>((node + 1) << level, size);
  OracleSpan span;
  span.lower = mirrored ? size - last : first;
  span.upper = mirrored ? size - first : last;
  span.index = tile * nodes_per_tile + node;
  span.stored = static_cast<int>(node);
  return span;
}

HitRecord to_record(const OracleHit<Int128>& hit, uint64_t ray_id, int stop_level) {
  HitRecord record;
  record.ray_id = ray_id;
  record.steps = static_cast<uint32_t>(hit.visits);
  if (!hit.hit) return record;
  record.status = HitStatus::kHit;
  record.face = hit.face;
  record.stop_level = static_cast<uint8_t>(stop_level);
  record.i = static_cast<int32_t>(hit.i);
  record.j = static_cast<int32_t>(hit.j);
  record.t = static_cast<int64_t>(hit.t.num);
  return record;
}

}  // namespace cuesta
