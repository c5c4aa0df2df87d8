#pragma once

#include <cstdint>

#include "models/heightmap/generator.h"

namespace cuesta {

// The makers behind the table of generator.cpp; sizes are checked there.
Relief make_fractal(int width, int height, uint64_t seed);
Relief make_hawaii(int width, int height, uint64_t seed);
Relief make_rocks(int width, int height, uint64_t seed);
Relief make_rockbump(int width, int height, uint64_t seed);
Relief make_text(int width, int height, uint64_t seed);
Relief make_text512(int width, int height, uint64_t seed);
Relief make_logo(int width, int height, uint64_t seed);

/// Calls at(x, y) for the centre of every texel and keeps what it returns. x and y are in units of the map's
/// shorter side: a square map spans 0 to 1 on both axes.
template <typename At>
Relief relief_of(int width, int height, At at) {
  Relief relief(static_cast<size_t>(width) * height);
  double side = width < height ? width : height;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i)
      relief[static_cast<size_t>(j) * width + i] = at((i + 0.5) / side, (j + 0.5) / side);
  }
  return relief;
}

}  // namespace cuesta
