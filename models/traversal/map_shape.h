#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "models/traversal/machine_ray.h"

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

}  // namespace cuesta
