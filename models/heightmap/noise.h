#pragma once

#include <cstdint>

namespace cuesta {

/// Smooth noise and scattered points over a torus, so that a map made from them tiles without a seam. Only +
/// - * / and sqrt on float64: the same bits from every compiler without fused multiply-add.

/// Largest integer <= x, |x| < 2^62.
inline int64_t floor_integer(double x) {
  int64_t k = static_cast<int64_t>(x);
  return x < static_cast<double>(k) ? k - 1 : k;
}
inline double clamp_unit(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }
/// 0 below 0, 1 above 1, 3 x^2 - 2 x^3 between.
inline double smooth_step(double x) {
  x = clamp_unit(x);
  return x * x * (3 - 2 * x);
}
inline double mix(double a, double b, double share) { return a + (b - a) * share; }
/// max(a, b) with a rounded edge of the given width.
double smooth_max(double a, double b, double width);

/// A torus of `columns` x `rows` lattice cells; coordinates are in cells and wrap.
struct Torus {
  int64_t columns;
  int64_t rows;
};

struct Slope {
  double value;  ///< about -0.8 to 0.8
  double dx;
  double dy;
};

/// Gradient noise (Perlin 2002: quintic fade) with 16 directions, and its derivatives.
Slope gradient_noise(const Torus& torus, double x, double y, uint64_t seed);

/// Octaves of gradient noise, each of twice the frequency and half the height of the one before, while their
/// cells are at least `finest` units of the first's.
double fractal_noise(const Torus& torus, double x, double y, double finest, uint64_t seed);

/// The same, of folded noise 1 - |n|: sharp crests.
double ridged_noise(const Torus& torus, double x, double y, double finest, uint64_t seed);

/// The jittered cell of a torus around a point (Worley 1996).
struct Cell {
  uint64_t id;  ///< a hash of the nearest point, for whatever the cell needs
  double dx;    ///< from the nearest point to here, in cells
  double dy;
  double edge;     ///< distance to the nearest border to another cell, 0 on it
  double rounded;  ///< at most `edge`, less near corners: its contour lines have no corners
};

/// `jitter` 0 (a square grid) to 1.
Cell nearest_cell(const Torus& torus, double x, double y, double jitter, uint64_t seed);

/// Number k (0 to 3) of a hash: 16 of its bits as [0, 1).
inline double share_of(uint64_t hash, int k) {
  return static_cast<double>((hash >> (16 * k)) & 0xFFFF) / 65536.0;
}

}  // namespace cuesta
