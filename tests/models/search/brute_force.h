#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "models/heightmap/height_grid.h"
#include "models/rays/machine_ray.h"

// Cones, edges and distances by asking every cell of the map and of what the address mode repeats beside it, from the
// definitions alone, in long double.

namespace cuesta {

/// The height of any cell of the unwrapped plane; -1: nothing is there.
inline int plane_height(const HeightGrid& grid, AddressMode mode, int64_t i, int64_t j) {
  const auto place = [mode](int64_t k, int64_t size) -> int64_t {
    if (mode == AddressMode::kBorder) return k >= 0 && k < size ? k : -1;
    if (mode == AddressMode::kClamp) return std::clamp<int64_t>(k, 0, size - 1);
    const int64_t in_two = ((k % (2 * size)) + 2 * size) % (2 * size);
    if (in_two < size) return in_two;
    return mode == AddressMode::kWrap ? in_two - size : 2 * size - 1 - in_two;
  };
  const int64_t x = place(i, grid.width), y = place(j, grid.height);
  return x < 0 || y < 0 ? -1 : grid.at(static_cast<int>(x), static_cast<int>(y));
}

/// Calls `ask(di, dj, height)` for every cell beside texel (i, j) as far as anything new can come.
template <class Ask>
void for_plane_around(const HeightGrid& grid, AddressMode mode, int i, int j, Ask&& ask) {
  const auto beyond = [mode](int size) {
    if (mode == AddressMode::kBorder) return 0;
    return mode == AddressMode::kClamp ? 2 : mode == AddressMode::kWrap ? size : 2 * size;
  };
  const int x = beyond(grid.width), y = beyond(grid.height);
  for (int b = -y; b < grid.height + y; ++b) {
    for (int a = -x; a < grid.width + x; ++a) ask(a - i, b - j, plane_height(grid, mode, a, b));
  }
}

inline long double brute_gap(int64_t d) {
  return d == 0 ? 0.0L : static_cast<long double>(d < 0 ? -d : d) - 0.5L;
}

/// Smallest distance / rise, in longer sides per full scale; infinity: no higher texel.
inline long double brute_cone(const HeightGrid& grid, AddressMode mode, int i, int j) {
  const int base = grid.at(i, j);
  long double least = std::numeric_limits<long double>::infinity();
  for_plane_around(grid, mode, i, j, [&](int64_t di, int64_t dj, int height) {
    if (height <= base) return;
    const long double x = brute_gap(di), y = brute_gap(dj);
    least = std::min(least, (x * x + y * y) / (static_cast<long double>(height - base) * (height - base)));
  });
  return std::sqrt(least) * static_cast<long double>(grid.full_scale()) / std::max(grid.width, grid.height);
}

/// Smallest distance from the centre of (i, j) to a place where the plane steps down going outward, over `rise(height)`
/// of the texel that ends there; a rise of 0: it does not count. Texels; the texel itself is left out.
template <class Rise>
long double brute_edges(const HeightGrid& grid, AddressMode mode, int i, int j, Rise&& rise) {
  long double least = std::numeric_limits<long double>::infinity();
  for_plane_around(grid, mode, i, j, [&](int64_t di, int64_t dj, int height) {
    if (di == 0 && dj == 0) return;
    const long double over = rise(height);
    if (over <= 0) return;
    for (int sy = -1; sy <= 1; ++sy) {
      for (int sx = -1; sx <= 1; ++sx) {
        if (plane_height(grid, mode, i + di + sx, j + dj + sy) >= height) continue;
        // The side's (or corner's) plane must lie ahead of the centre.
        const long double plane_x = static_cast<long double>(di) + 0.5L * sx;
        const long double plane_y = static_cast<long double>(dj) + 0.5L * sy;
        if ((sx != 0 && plane_x * sx <= 0) || (sy != 0 && plane_y * sy <= 0)) continue;
        const long double x = sx != 0 ? plane_x : brute_gap(di), y = sy != 0 ? plane_y : brute_gap(dj);
        least = std::min(least, std::sqrt(x * x + y * y) / over);
      }
    }
  });
  return least;
}

inline long double brute_relaxed_cone(const HeightGrid& grid, AddressMode mode, int i, int j) {
  const int base = grid.at(i, j);
  return brute_edges(grid, mode, i, j,
                     [base](int height) { return static_cast<long double>(height - base); }) *
         static_cast<long double>(grid.full_scale()) / std::max(grid.width, grid.height);
}

inline long double brute_radius(const HeightGrid& grid, AddressMode mode, int i, int j) {
  return brute_edges(grid, mode, i, j, [](int height) { return height < 0 ? 0.0L : 1.0L; }) /
         std::max(grid.width, grid.height);
}

/// `byte` is the largest one with (byte / 255)^2 <= ratio, rounding of `ratio` apart.
inline bool is_rounded_down(int byte, long double ratio) {
  const auto square = [](int b) { return static_cast<long double>(b) * b / (255.0L * 255.0L); };
  return square(byte) <= ratio * (1 + 1e-15L) && (byte == 255 || square(byte + 1) > ratio * (1 - 1e-15L));
}

/// Distance of the texel's centre at the middle of `layer` of 16 from the columns of the plane, each on its texel's
/// centre; texels, full scale an eighth of the longer side.
inline long double brute_distance(const HeightGrid& grid, AddressMode mode, int i, int j, int layer) {
  const long double full = static_cast<long double>(grid.full_scale());
  const long double scale = std::max(grid.width, grid.height) / 8.0L / full, z = (layer + 0.5L) / 16 * full;
  long double least = std::numeric_limits<long double>::infinity();
  for_plane_around(grid, mode, i, j, [&](int64_t di, int64_t dj, int height) {
    if (height < 0) return;
    const long double up = std::max(0.0L, z - height) * scale;
    least = std::min(least, static_cast<long double>(di * di + dj * dj) + up * up);
  });
  return std::sqrt(least);
}

}  // namespace cuesta
