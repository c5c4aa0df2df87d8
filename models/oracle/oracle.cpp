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

OracleSpan oracle_span(int64_t mirrored_leaf, bool mirrored, int size, int level, AddressMode mode) {
  const int64_t leaf = mirrored ? size - 1 - mirrored_leaf : mirrored_leaf;
  const int64_t nodes_per_tile = (size + (int64_t{1} << level) - 1) >> level;
  OracleSpan span;
  int64_t first = 0, last = 0;  // texel planes of the map's own frame
  if (mode == AddressMode::kClamp) {
    span.index = floor_divide<int64_t>(leaf, int64_t{1} << level);
    span.stored = static_cast<int>(std::clamp<int64_t>(span.index, 0, nodes_per_tile - 1));
    first = span.index * (int64_t{1} << level);
    last = first + (int64_t{1} << level);
  } else {
    const int64_t tile = floor_divide<int64_t>(leaf, size);
    const int64_t begin = tile * size, end = begin + size;
    const bool turned = mode == AddressMode::kMirror && tile % 2 != 0;
    const int64_t texel = turned ? end - 1 - leaf : leaf - begin;
    const int64_t node = texel >> level;
    const int64_t low = node << level, high = std::min<int64_t>((node + 1) << level, size);
    first = turned ? end - high : begin + low;
    last = turned ? end - low : begin + high;
    span.index = tile * nodes_per_tile + (turned ? nodes_per_tile - 1 - node : node);
    span.stored = static_cast<int>(node);
  }
  span.lower = mirrored ? size - last : first;
  span.upper = mirrored ? size - first : last;
  return span;
}

OracleSpan oracle_span_of_node(int64_t index, bool mirrored, int size, int level, AddressMode mode) {
  int64_t leaf = index * (int64_t{1} << level);
  if (mode != AddressMode::kClamp) {
    const int64_t nodes_per_tile = (size + (int64_t{1} << level) - 1) >> level;
    const int64_t tile = floor_divide<int64_t>(index, nodes_per_tile);
    const int64_t place = index - tile * nodes_per_tile;
    const bool turned = mode == AddressMode::kMirror && tile % 2 != 0;
    // A turned tile begins with its last node, which may be narrower.
    leaf = turned ? (tile + 1) * size - 1 - ((nodes_per_tile - 1 - place) << level)
                  : tile * size + (place << level);
  }
  return oracle_span(mirrored ? size - 1 - leaf : leaf, mirrored, size, level, mode);
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
