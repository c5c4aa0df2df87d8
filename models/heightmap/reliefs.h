#pragma once

#include <cstdint>

#include "models/heightmap/generator.h"

namespace cuesta {

// The makers behind the table of generator.cpp; sizes are checked there.
ReliefRows make_fractal(int width, int height, uint64_t seed);
ReliefRows make_hawaii(int width, int height, uint64_t seed);
ReliefRows make_rocks(int width, int height, uint64_t seed);
ReliefRows make_rockbump(int width, int height, uint64_t seed);
ReliefRows make_text(int width, int height, uint64_t seed);
ReliefRows make_text512(int width, int height, uint64_t seed);
ReliefRows make_logo(int width, int height, uint64_t seed);
ReliefRows make_flat(int width, int height, uint64_t seed);
ReliefRows make_spikes(int width, int height, uint64_t seed);
ReliefRows make_bricks(int width, int height, uint64_t seed);
ReliefRows make_noise(int width, int height, uint64_t seed);
ReliefRows make_steps(int width, int height, uint64_t seed);
ReliefRows make_checker(int width, int height, uint64_t seed);
ReliefRows make_hole(int width, int height, uint64_t seed);
ReliefRows make_cliffs(int width, int height, uint64_t seed);
ReliefRows make_terraces(int width, int height, uint64_t seed);

/// Rows of at(x, y) at the centre of every texel. x and y are in units of the map's shorter side: a square map spans 0
/// to 1 on both axes.
template <typename At>
ReliefRows relief_of(int width, int height, At at) {
  double side = width < height ? width : height;
  return [=](int j, double* row) {
    for (int i = 0; i < width; ++i) row[i] = at((i + 0.5) / side, (j + 0.5) / side);
  };
}

}  // namespace cuesta
