#include <algorithm>
#include <cmath>

#include "models/common/random.h"
#include "models/heightmap/noise.h"
#include "models/heightmap/reliefs.h"

namespace cuesta {
namespace {

/// A torus with about `cells` cells along the shorter side and whole cells along both, and the factors that
/// lead from units of the shorter side to cells: what makes a map of any shape tile.
struct Lattice {
  Lattice(int width, int height, int cells) {
    int64_t side = std::min(width, height);
    torus.columns = std::max<int64_t>(1, (static_cast<int64_t>(cells) * width + side / 2) / side);
    torus.rows = std::max<int64_t>(1, (static_cast<int64_t>(cells) * height + side / 2) / side);
    per_x = static_cast<double>(torus.columns * side) / width;
    per_y = static_cast<double>(torus.rows * side) / height;
    texels = static_cast<double>(side) / cells;
  }
  Torus torus;
  double per_x, per_y;
  double texels;  ///< of a cell
};

/// A sum of octaves in which steep ground takes less of the next: flanks keep their shape, flats and crests
/// get the detail, as where water has carried it off.
double eroded_noise(const Lattice& lattice, double x, double y, uint64_t seed) {
  double sum = 0, height = 1, dx = 0, dy = 0;
  double cell_texels = lattice.texels;
  for (int k = 0; k < 14 && cell_texels >= 1.5; ++k, cell_texels /= 2, height *= 0.5) {
    double scale = static_cast<double>(int64_t{1} << k);
    uint64_t shift = Random::mix(seed + static_cast<uint64_t>(k));
    Torus torus{lattice.torus.columns << k, lattice.torus.rows << k};
    Slope n = gradient_noise(torus, x * scale + share_of(shift, 0), y * scale + share_of(shift, 1), shift);
    dx += n.dx * 0.9;
    dy += n.dy * 0.9;
    sum += height * n.value / (1 + dx * dx + dy * dy);
  }
  return sum;
}

}  // namespace

ReliefRows make_fractal(int width, int height, uint64_t seed) {
  Lattice broad(width, height, 3), fine(width, height, 5);
  return relief_of(width, height, [=](double x, double y) {
    double u = x * broad.per_x, v = y * broad.per_y;
    double warp_u = 0.35 * fractal_noise(broad.torus, u, v, 0.2, seed + 101);
    double warp_v = 0.35 * fractal_noise(broad.torus, u, v, 0.2, seed + 202);
    double land = eroded_noise(broad, u + warp_u, v + warp_v, seed);
    double range = smooth_step(0.5 + 1.4 * gradient_noise(broad.torus, u, v, seed + 303).value);
    double crests = ridged_noise(fine.torus, x * fine.per_x + warp_u, y * fine.per_y + warp_v,
                                 2 / fine.texels, seed + 404);
    return 0.8 * land + crests * range;
  });
}

namespace {

/// A shield volcano: a ridge from (x0, y0) to (x1, y1) in shares of the map (the rift zone), highest at its
/// first end.
struct Volcano {
  double x0, y0, x1, y1;
  double peak;    ///< kilometres
  double rift;    ///< share of the peak that the far end still has
  double radius;  ///< of its foot, in shares of the map
};

/// Five volcanoes placed as on the island: Kohala, Mauna Kea, Hualalai, Mauna Loa, Kilauea.
constexpr Volcano kVolcanoes[] = {
    {0.36, 0.19, 0.26, 0.10, 1.7, 0.55, 0.20}, {0.54, 0.36, 0.60, 0.30, 4.2, 0.75, 0.40},
    {0.26, 0.42, 0.20, 0.36, 2.5, 0.50, 0.25}, {0.46, 0.58, 0.38, 0.92, 4.1, 0.12, 0.38},
    {0.64, 0.64, 0.92, 0.52, 1.3, 0.30, 0.25},
};

constexpr double kSea = 1.14;  ///< the map's side in units of the table above: leaves sea on all sides

double shield(const Volcano& v, double x, double y) {
  double ax = v.x1 - v.x0, ay = v.y1 - v.y0;
  double along = clamp_unit(((x - v.x0) * ax + (y - v.y0) * ay) / (ax * ax + ay * ay));
  double dx = x - v.x0 - along * ax, dy = y - v.y0 - along * ay;
  double reach = 1 - std::sqrt(dx * dx + dy * dy) / (v.radius * (1 - 0.45 * along));
  double top = v.peak * (1 - (1 - v.rift) * along);
  return reach > 0 ? top * reach * std::sqrt(reach) : top * reach;
}

}  // namespace

ReliefRows make_hawaii(int width, int height, uint64_t seed) {
  Lattice coast(width, height, 7), gullies(width, height, 11);
  double side = std::min(width, height);
  double left = (width / side - 1) / 2, top = (height / side - 1) / 2;
  return relief_of(width, height, [=](double x, double y) {
    double finest = 2 / coast.texels;
    double warp_x = 0.03 * fractal_noise(coast.torus, x * coast.per_x, y * coast.per_y, finest, seed + 11);
    double warp_y = 0.03 * fractal_noise(coast.torus, x * coast.per_x, y * coast.per_y, finest, seed + 22);
    double land = -9, island_x = kSea * (x - left - 0.5) + 0.5, island_y = kSea * (y - top - 0.5) + 0.52;
    for (const Volcano& volcano : kVolcanoes) {
      land = smooth_max(land, shield(volcano, island_x + warp_x, island_y + warp_y), 0.35);
    }
    double valleys =
        ridged_noise(gullies.torus, x * gullies.per_x, y * gullies.per_y, 2 / gullies.texels, seed + 33);
    land += 0.30 * (valleys - 0.5) * smooth_step(land / 1.2) - 0.10;
    return land > 0 ? land : 0;
  });
}

}  // namespace cuesta
