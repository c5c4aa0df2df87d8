#include "models/heightmap/noise.h"

#include <cmath>

#include "models/common/random.h"

namespace cuesta {
namespace {

uint64_t lattice_hash(const Torus& torus, int64_t column, int64_t row, uint64_t seed) {
  column %= torus.columns;
  row %= torus.rows;
  if (column < 0) column += torus.columns;
  if (row < 0) row += torus.rows;
  uint64_t place = (static_cast<uint64_t>(column) << 32) | static_cast<uint64_t>(row);
  return Random::mix(place + Random::mix(seed + 0x9E3779B97F4A7C15ull));
}

/// Sixteen directions, 22.5 degrees apart, from 11.25: none lies along an axis, where noise shows its
/// lattice.
constexpr double kCosine[16] = {
    0.98078528040323043,  0.83146961230254524,  0.55557023301960218,  0.19509032201612825,
    -0.19509032201612825, -0.55557023301960218, -0.83146961230254524, -0.98078528040323043,
    -0.98078528040323043, -0.83146961230254524, -0.55557023301960218, -0.19509032201612825,
    0.19509032201612825,  0.55557023301960218,  0.83146961230254524,  0.98078528040323043};

struct Corner {
  double gx, gy, value;
};

Corner corner(const Torus& torus, int64_t column, int64_t row, double x, double y, uint64_t seed) {
  uint64_t direction = lattice_hash(torus, column, row, seed) >> 60;
  double gx = kCosine[direction], gy = kCosine[(direction + 12) % 16];
  return {gx, gy, gx * x + gy * y};
}

/// The octaves' lattices are shifted against each other: else their zeros would lie on one another.
struct Octave {
  Torus torus;
  double x, y;
};

Octave octave(const Torus& torus, double x, double y, int k, uint64_t seed) {
  double scale = static_cast<double>(int64_t{1} << k);
  uint64_t shift = Random::mix(seed + static_cast<uint64_t>(k));
  return {
      {torus.columns << k, torus.rows << k}, x * scale + share_of(shift, 0), y * scale + share_of(shift, 1)};
}

}  // namespace

double smooth_max(double a, double b, double width) {
  double gap = a > b ? a - b : b - a;
  double overlap = gap < width ? width - gap : 0;
  return (a > b ? a : b) + overlap * overlap / (4 * width);
}

Slope gradient_noise(const Torus& torus, double x, double y, uint64_t seed) {
  int64_t column = floor_integer(x), row = floor_integer(y);
  double fx = x - static_cast<double>(column), fy = y - static_cast<double>(row);
  Corner a = corner(torus, column, row, fx, fy, seed);
  Corner b = corner(torus, column + 1, row, fx - 1, fy, seed);
  Corner c = corner(torus, column, row + 1, fx, fy - 1, seed);
  Corner d = corner(torus, column + 1, row + 1, fx - 1, fy - 1, seed);
  double u = fx * fx * fx * (fx * (fx * 6 - 15) + 10), v = fy * fy * fy * (fy * (fy * 6 - 15) + 10);
  double du = 30 * fx * fx * (fx * (fx - 2) + 1), dv = 30 * fy * fy * (fy * (fy - 2) + 1);
  double both = a.value - b.value - c.value + d.value;
  Slope slope;
  slope.value = a.value + u * (b.value - a.value) + v * (c.value - a.value) + u * v * both;
  slope.dx = a.gx + u * (b.gx - a.gx) + v * (c.gx - a.gx) + u * v * (a.gx - b.gx - c.gx + d.gx) +
             du * (b.value - a.value + v * both);
  slope.dy = a.gy + u * (b.gy - a.gy) + v * (c.gy - a.gy) + u * v * (a.gy - b.gy - c.gy + d.gy) +
             dv * (c.value - a.value + u * both);
  return slope;
}

double fractal_noise(const Torus& torus, double x, double y, double finest, uint64_t seed) {
  double sum = 0, height = 1;
  for (int k = 0; k < 16 && height >= finest; ++k, height /= 2) {
    Octave here = octave(torus, x, y, k, seed);
    sum += height * gradient_noise(here.torus, here.x, here.y, seed + static_cast<uint64_t>(k)).value;
  }
  return sum;
}

double ridged_noise(const Torus& torus, double x, double y, double finest, uint64_t seed) {
  double sum = 0, height = 1, weight = 1;
  for (int k = 0; k < 16 && height >= finest; ++k, height /= 2) {
    Octave here = octave(torus, x, y, k, seed);
    double n = gradient_noise(here.torus, here.x, here.y, seed + static_cast<uint64_t>(k)).value;
    double crest = clamp_unit(1 - (n < 0 ? -n : n) * 1.6);
    crest *= crest * weight;
    sum += height * crest;
    weight = clamp_unit(crest * 1.8);  // detail gathers on the crests, valleys stay smooth (Musgrave 1994)
  }
  return sum / 2;
}

Cell nearest_cell(const Torus& torus, double x, double y, double jitter, uint64_t seed) {
  int64_t column = floor_integer(x), row = floor_integer(y);
  double best_x = 0, best_y = 0, best = 1e30;
  Cell cell{0, 0, 0, 1e30, 0};
  double crowding = 0;
  auto point = [&](int dc, int dr, double& px, double& py) {
    uint64_t hash = lattice_hash(torus, column + dc, row + dr, seed);
    px = static_cast<double>(column + dc) + 0.5 + (share_of(hash, 0) - 0.5) * jitter;
    py = static_cast<double>(row + dr) + 0.5 + (share_of(hash, 1) - 0.5) * jitter;
    return hash;
  };
  for (int dr = -2; dr <= 2; ++dr) {
    for (int dc = -2; dc <= 2; ++dc) {
      double px, py;
      uint64_t hash = point(dc, dr, px, py);
      double distance = (x - px) * (x - px) + (y - py) * (y - py);
      if (distance >= best) continue;
      best = distance;
      best_x = px;
      best_y = py;
      cell.id = Random::mix(hash);
    }
  }
  cell.dx = x - best_x;
  cell.dy = y - best_y;
  for (int dr = -2; dr <= 2; ++dr) {
    for (int dc = -2; dc <= 2; ++dc) {
      double px, py;
      point(dc, dr, px, py);
      double ax = px - best_x, ay = py - best_y, length = std::sqrt(ax * ax + ay * ay);
      if (length == 0) continue;
      double edge = (((px + best_x) / 2 - x) * ax + ((py + best_y) / 2 - y) * ay) / length;
      edge = edge > 1e-6 ? edge : 1e-6;
      if (edge < cell.edge) cell.edge = edge;
      crowding += 1 / (edge * edge * edge * edge);
    }
  }
  cell.rounded = 1 / std::sqrt(std::sqrt(crowding));
  return cell;
}

}  // namespace cuesta
