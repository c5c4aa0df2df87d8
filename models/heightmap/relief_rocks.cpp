#include <algorithm>
#include <array>
#include <cmath>

#include "models/heightmap/noise.h"
#include "models/heightmap/reliefs.h"

namespace cuesta {
namespace {

Torus torus_of(int width, int height, int cells) {
  int64_t side = std::min(width, height);
  return {std::max<int64_t>(1, (static_cast<int64_t>(cells) * width + side / 2) / side),
          std::max<int64_t>(1, (static_cast<int64_t>(cells) * height + side / 2) / side)};
}

/// One layer of stones, a share of the cells of a jittered grid: a plateau cut by the cell's borders and by
/// two planes through the stone, tilted at random.
double stones(const Torus& torus, double x, double y, double share, uint64_t seed) {
  Cell cell = nearest_cell(torus, x, y, 0.85, seed);
  if (share_of(cell.id, 0) >= share) return 0;
  double tilt_x = share_of(cell.id, 1) - 0.5, tilt_y = share_of(cell.id, 2) - 0.5;
  double height = 0.65 + 0.35 * share_of(cell.id, 3);
  double flank = cell.edge * 4.5 - 0.12;
  double roof = height + tilt_x * cell.dx + tilt_y * cell.dy;
  double facet = height + 0.10 - 1.3 * (tilt_y * cell.dx - tilt_x * cell.dy);
  double stone = std::min({flank, roof, facet});
  return stone > 0 ? stone : 0;
}

}  // namespace

ReliefRows make_rocks(int width, int height, uint64_t seed) {
  double side = std::min(width, height);
  std::array layers = {torus_of(width, height, 6), torus_of(width, height, 13), torus_of(width, height, 29)};
  std::array shares = {0.6, 0.7, 0.8}, heights = {1.0, 0.55, 0.28};
  return relief_of(width, height, [=](double x, double y) {
    double u = x * side / width, v = y * side / height;  // 0 to 1 over the map, whatever its shape
    double rough = fractal_noise(layers[2], u * static_cast<double>(layers[2].columns),
                                 v * static_cast<double>(layers[2].rows), 0.2, seed + 9);
    double bend = 0.012 * rough;
    double top = 0.05;
    for (size_t k = 0; k < 3; ++k) {
      double stone = stones(layers[k], (u + bend) * static_cast<double>(layers[k].columns),
                            (v - bend) * static_cast<double>(layers[k].rows), shares[k], seed + k);
      top = std::max(top, heights[k] * stone);
    }
    return top + 0.035 * rough;
  });
}

ReliefRows make_rockbump(int width, int height, uint64_t seed) {
  double side = std::min(width, height);
  Torus torus = torus_of(width, height, 7);
  return relief_of(width, height, [=](double x, double y) {
    double u = x * side / width * static_cast<double>(torus.columns);
    double v = y * side / height * static_cast<double>(torus.rows);
    double wave = gradient_noise({torus.columns * 2, torus.rows * 2}, 2 * u, 2 * v, seed + 1).value;
    double wave2 = gradient_noise({torus.columns * 2, torus.rows * 2}, 2 * u, 2 * v, seed + 2).value;
    Cell cell = nearest_cell(torus, u + 0.10 * wave, v + 0.10 * wave2, 0.8, seed);
    double lean = (share_of(cell.id, 1) - 0.5) * cell.dx + (share_of(cell.id, 2) - 0.5) * cell.dy;
    double inward = clamp_unit(cell.rounded / 0.42);
    double dome = std::sqrt(1 - (1 - inward) * (1 - inward));
    double stone =
        dome * smooth_step(cell.rounded / 0.22) * (0.68 + 0.28 * share_of(cell.id, 0) + 0.25 * lean);
    double grain = fractal_noise({torus.columns * 4, torus.rows * 4}, 4 * u, 4 * v, 0.2, seed + 3);
    return stone + 0.05 * grain * dome;
  });
}

}  // namespace cuesta
