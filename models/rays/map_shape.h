#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "models/rays/machine_ray.h"

namespace cuesta {

/// n: the smallest with 2^n >= max(width, height); both at least 1.
inline int root_level_of(int width, int height) {
  return static_cast<int>(std::bit_width(static_cast<uint32_t>(std::max(width, height)) - 1));
}

/// A map of this size as traversal sees it, without its pyramid.
inline MapShape map_shape(int width, int height, int bits, AddressMode mode,
                          Surface surface = Surface::kTexel) {
  return {width, height, root_level_of(width, height), bits, mode, surface};
}

/// More steps than any walk over the map takes: every second one at least is a crossing, but for descents, of which
/// each level above the leaves is repaid by an ascent; crossings are as many as there are planes in 2^w2 tiles.
inline int64_t most_steps(const MapShape& map, const NumberFormat& format) {
  const int64_t planes = int64_t{map.width} + map.height;
  return 4 * (planes << format.tile_bits) + 4 * map.root_level + 64;
}

}  // namespace cuesta
