#include "models/oracle/bilinear_oracle.h"

#include <algorithm>
#include <cmath>

#include "models/oracle/oracle.h"

namespace cuesta {
namespace {

constexpr int kMostHalvings = 400;

ExactAxis<BigInt> make_axis(int64_t origin, int64_t d, int fraction_bits) {
  ExactAxis<BigInt> axis;
  axis.sign = d < 0 ? -1 : d > 0 ? 1 : 0;
  axis.origin = origin;
  axis.unit = BigInt(1) << fraction_bits;
  if (d != 0) axis.den = d < 0 ? -d : d;
  return axis;
}

/// Speed along the axis in grid steps, never negative.
BigInt speed(const ExactAxis<BigInt>& axis) { return axis.sign == 0 ? BigInt(0) : axis.den; }

/// c0 d^2 + c1 n d + c2 n^2 of t = n / d: its sign is the quadratic's.
BigInt value_at(const BigInt& c0, const BigInt& c1, const BigInt& c2, const BigInt& n, const BigInt& d) {
  return BigInt(c0 * d * d + c1 * n * d + c2 * n * n);
}

}  // namespace

BilinearOracle::BilinearOracle(const MachineRay& ray, const HeightGrid& grid, const MapShape& shape,
                               const NumberFormat& format)
    : grid_(grid), shape_(shape) {
  const int f = format.fraction_bits;
  ray_.x = make_axis(ray.dx < 0 ? (int64_t{shape.width} << f) - ray.x0 : ray.x0, ray.dx, f);
  ray_.y = make_axis(ray.dy < 0 ? (int64_t{shape.height} << f) - ray.y0 : ray.y0, ray.dy, f);
  ray_.z = make_axis(ray.z0, ray.dz, f);
  ray_.t_max = {BigInt(ray.t_max), BigInt(BigInt(1) << (format.direction_bits - 1 + format.mantissa_bits))};
  ray_.dead = ray.dead;
  highest_ = *std::max_element(grid.texels.begin(), grid.texels.end());
}

BilinearOracle::Axis BilinearOracle::axis_of(int64_t mirrored_leaf, const ExactAxis<BigInt>& axis,
                                             int size) const {
  const bool mirrored = axis.sign < 0;
  const int64_t leaf = mirrored ? size - 1 - mirrored_leaf : mirrored_leaf;
  const auto stored = [&](int64_t sample) {
    if (shape_.address_mode == AddressMode::kWrap)
      return static_cast<int>(sample - floor_divide<int64_t>(sample, size) * size);
    return static_cast<int>(std::clamp<int64_t>(sample, 0, size - 1));
  };
  return {BigInt(axis.origin - BigInt(mirrored_leaf) * axis.unit), stored(mirrored ? leaf + 1 : leaf),
          stored(mirrored ? leaf : leaf + 1), leaf};
}

BilinearOracle::Quadratic BilinearOracle::quadratic(const Axis& x, const Axis& y) const {
  const int64_t h00 = grid_.at(x.first, y.first), h10 = grid_.at(x.second, y.first);
  const int64_t h01 = grid_.at(x.first, y.second), h11 = grid_.at(x.second, y.second);
  // Of the interpolated height times unit^2: a constant, along x, along y, and the twist.
  const BigInt unit = ray_.x.unit;
  const BigInt along_x = (h10 - h00) * unit, along_y = (h01 - h00) * unit, twist = h11 - h10 - h01 + h00;
  const BigInt sx = speed(ray_.x), sy = speed(ray_.y);
  const BigInt sz = ray_.z.sign < 0 ? BigInt(-speed(ray_.z)) : speed(ray_.z);
  Quadratic q;
  q.c0 = ray_.z.origin * unit - h00 * unit * unit - along_x * x.lower - along_y * y.lower -
         twist * x.lower * y.lower;
  q.c1 = sz * unit - along_x * sx - along_y * sy - twist * (x.lower * sy + y.lower * sx);
  q.c2 = -twist * sx * sy;
  return q;
}

bool BilinearOracle::below(const Quadratic& q, const ExactTime<BigInt>& t, bool touching) {
  const BigInt value = value_at(q.c0, q.c1, q.c2, t.num, t.den);
  return touching ? value <= 0 : value < 0;
}

bool BilinearOracle::first_below(const Quadratic& q, const ExactTime<BigInt>& t0, const ExactTime<BigInt>& t1,
                                 int precision, BilinearReading reading, BilinearHit& hit) {
  if (!(t0 < t1)) return false;
  hit.t_low = hit.t_high = t0;
  if (below(q, t0, reading.touching)) return true;
  // On the surface at t0 and below from there on.
  const BigInt slope = q.c1 * t0.den + 2 * q.c2 * t0.num;
  const bool on_surface = value_at(q.c0, q.c1, q.c2, t0.num, t0.den) == 0;
  if (on_surface && (slope < 0 || (slope == 0 && q.c2 < 0))) return true;
  // Some time at which it is below, between which and t0 it goes below once.
  ExactTime<BigInt> then = t1;
  const bool ends_below = below(q, t1, reading.touching && reading.edges_above);
  if (!ends_below) {
    if (q.c2 <= 0) return false;
    then = {BigInt(-q.c1), BigInt(2 * q.c2)};
    const BigInt discriminant = q.c1 * q.c1 - 4 * q.c0 * q.c2;
    if (reading.touching ? discriminant < 0 : discriminant <= 0) return false;
    if (!(t0 < then) || !(then < t1)) return false;
  }
  // t = (first + width * s) / den, s from 0 to 1, and the quadratic in s.
  const BigInt den = t0.den * then.den;
  const BigInt first = t0.num * then.den, width = BigInt(then.num * t0.den) - first;
  const BigInt e0 = value_at(q.c0, q.c1, q.c2, first, den);
  const BigInt e1 = BigInt(2 * q.c2 * first + q.c1 * den) * width, e2 = q.c2 * width * width;
  BigInt low = 0, high = 1;
  int halvings = 0;
  for (; halvings < kMostHalvings; ++halvings) {
    const BigInt least = (first << halvings) + width * low;
    if (least > 0 && BigInt(width << precision) <= least) break;
    low <<= 1;
    high <<= 1;
    const BigInt middle = low + 1;
    const BigInt value = value_at(e0, e1, e2, middle, BigInt(BigInt(1) << (halvings + 1)));
    (value < 0 || (reading.touching && value == 0) ? high : low) = middle;
  }
  hit.t_low = {BigInt((first << halvings) + width * low), BigInt(den << halvings)};
  hit.t_high = {BigInt((first << halvings) + width * high), BigInt(den << halvings)};
  return true;
}

BilinearHit BilinearOracle::walk(int precision, BilinearReading reading) const {
  BilinearHit answer;
  const auto start = oracle_start(ray_, shape_);
  if (!start) return answer;
  const bool border = shape_.address_mode == AddressMode::kBorder;
  ExactTime<BigInt> end = ray_.t_max;
  if (ray_.z.sign > 0) end = earlier(end, ray_.z.reaches(highest_ + (reading.touching ? 1 : 0)));
  ExactTime<BigInt> now = *start;
  int64_t k = ray_.x.cell_at(now), l = ray_.y.cell_at(now);
  while (now < end && !(border && (k >= shape_.width || l >= shape_.height))) {
    const Axis x = axis_of(k, ray_.x, shape_.width), y = axis_of(l, ray_.y, shape_.height);
    const ExactTime<BigInt> t_x = ray_.x.plane(k + 1), t_y = ray_.y.plane(l + 1);
    const ExactTime<BigInt> out = earlier(t_x, t_y);
    if (first_below(quadratic(x, y), now, earlier(out, ray_.t_max), precision, reading, answer)) {
      answer.hit = true;
      answer.i = x.index;
      answer.j = y.index;
      return answer;
    }
    now = out;
    if (t_x == now) ++k;
    if (t_y == now) ++l;
  }
  return answer;
}

bool BilinearOracle::is_tie(bool hit, int64_t i, int64_t j) const {
  for (const bool edges_above : {false, true}) {
    const BilinearHit other = walk(1, {true, edges_above});
    if (other.hit == hit && (!hit || (other.i == i && other.j == j))) return true;
  }
  return false;
}

long double BilinearOracle::height_above(long double t, int64_t i, int64_t j) const {
  const auto mirrored_leaf = [](int64_t index, const ExactAxis<BigInt>& axis, int size) {
    return axis.sign < 0 ? size - 1 - index : index;
  };
  const Quadratic q = quadratic(axis_of(mirrored_leaf(i, ray_.x, shape_.width), ray_.x, shape_.width),
                                axis_of(mirrored_leaf(j, ray_.y, shape_.height), ray_.y, shape_.height));
  int exponent = 0;
  const long double mantissa = std::frexp(t, &exponent);
  BigInt n = static_cast<int64_t>(std::ldexp(mantissa, 62)), d = 1;
  exponent -= 62;
  (exponent < 0 ? d : n) <<= exponent < 0 ? -exponent : exponent;
  return static_cast<long double>(value_at(q.c0, q.c1, q.c2, n, d)) /
         static_cast<long double>(BigInt(d * d * ray_.x.unit * ray_.x.unit));
}

}  // namespace cuesta
