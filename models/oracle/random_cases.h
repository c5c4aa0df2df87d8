#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "models/common/random.h"
#include "models/heightmap/height_grid.h"
#include "models/rays/machine_ray.h"

namespace cuesta {

/// A small map with everything that a traversal needs to know of it.
struct RandomMap {
  uint64_t seed = 0;
  std::string_view kind;
  HeightGrid grid;
  MapShape shape;
  NumberFormat format;
};

/// The map of a seed: 1 x 1, 1 x N, powers of two, 2^n + 1, any size up to `max_side`; 1 to 16 bits; flat, noise,
/// checker-like, spikes, steps and fractal; every address mode; the machine's default number format for its bits, or
/// a random one.
RandomMap random_map(uint64_t seed, int max_side);

/// A ray that is likely to meet trouble: origins on planes, corners, heights and far outside, directions along
/// axes and diagonals and of small whole ratios, grazing, horizontal and rising, finite t_max at whole steps;
/// and plain random ones. Made from texels and height LSBs, so that what is whole stays whole in `quantise`.
TracedRay random_ray(Random& random, const RandomMap& map, uint64_t id);

/// One line: seed, kind, size, bits, mode and number format.
std::string describe(const RandomMap& map);
/// One line: origin, direction and range with all digits, kind and fixed coordinate.
std::string describe(const TracedRay& ray);
std::string describe(const MachineRay& ray);

}  // namespace cuesta
