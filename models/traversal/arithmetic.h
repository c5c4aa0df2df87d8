#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "models/rays/machine_ray.h"
#include "models/traversal/reciprocal.h"

// The three arithmetics in which a ray can be traversed. Each gives a type of time and a `PlaneTime`: a monotone
// function of an integer (a plane's index, a height) into time. That they never decrease (or never increase)
// is all that the traversal asks of them.

namespace cuesta {

/// Times are integers; a plane time is p = k * slope - offset, shifted left by the reciprocal's exponent and
/// saturated at t_end. Negative times are stored as -1 << shift: only their sign is used.
struct FixedArithmetic {
  using Time = int64_t;

  struct Format {
    NumberFormat number;
    int64_t t_end;
  };

  struct PlaneTime {
    int64_t slope;
    int64_t offset;
    int64_t limit;  ///< largest p that does not saturate
    int64_t t_end;
    int32_t shift;
  };

  static Format format(const MapShape& map, const NumberFormat& number) {
    return {number, (int64_t{1} << time_bits(map, number)) - 1};
  }

  /// When the ray, at `origin` (f fraction bits) and moving by d >= 0, crosses plane K.
  static PlaneTime plane_time(int64_t origin, int64_t d, const Format& format) {
    const int f = format.number.fraction_bits;
    // d = 0: p < 0 for every plane at or before the origin, p >= 0 > limit for every other.
    if (d == 0) return {int64_t{1} << f, origin + 1, -1, format.t_end, 0};
    const Reciprocal r = reciprocal(d, format.number);
    return {r.mantissa << f, origin * r.mantissa, format.t_end >> r.exponent, format.t_end, r.exponent};
  }

  /// When the ray reaches height h.
  static PlaneTime height_time(int64_t z0, int64_t dz, const Format& format) {
    const int f = format.number.fraction_bits;
    if (dz == 0) return {-(int64_t{1} << f), -z0, -1, format.t_end, 0};
    const Reciprocal r = reciprocal(dz < 0 ? -dz : dz, format.number);
    const int64_t sign = dz < 0 ? -1 : 1;
    return {sign * (r.mantissa << f), sign * z0 * r.mantissa, format.t_end >> r.exponent, format.t_end,
            r.exponent};
  }

  static Time at(const PlaneTime& plane, int64_t k) {
    const int64_t p = k * plane.slope - plane.offset;
    return p > plane.limit ? plane.t_end : std::max<int64_t>(p, -1) << plane.shift;
  }

  /// The largest K with at(plane, K) <= t, for 0 <= t < t_end.
  static int64_t cell_at(const PlaneTime& plane, int64_t origin, int64_t d, Time t, const Format& format) {
    const int f = format.number.fraction_bits;
    if (d == 0 || t == 0) return origin >> f;
    const int64_t mantissa = plane.slope >> f;
    return (origin + (t >> plane.shift) / mantissa) >> f;
  }

  static Time limit(const MachineRay& ray, const Format&) { return ray.t_max; }
  static bool is_infinite(Time t, const Format& format) { return t >= format.t_end; }
  static int64_t bits(Time t) { return t; }
};

/// IEEE float or double: T(K) = (K - x0) * (1 / dx), each operation rounded once; origins rounded once.
template <class Real>
struct RealArithmetic {
  using Time = Real;

  struct Format {
    NumberFormat number;
    double unit_of_position;  ///< 2^-f
    double unit_of_time;      ///< 2^-(f + D - 1 + M): machine time units into 1 / (d of the machine's ray)
    int64_t t_end;
  };

  struct PlaneTime {
    Real origin;
    Real inverse;  ///< infinite: the ray does not move along this axis
  };

  static double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<uint64_t>(1023 + exponent) << 52);
  }

  static Format format(const MapShape& map, const NumberFormat& number) {
    const int f = number.fraction_bits;
    return {number, power_of_two(-f), power_of_two(-(f + number.direction_bits - 1 + number.mantissa_bits)),
            (int64_t{1} << time_bits(map, number)) - 1};
  }

  static PlaneTime along_axis(int64_t origin, int64_t d, Real sign, const Format& format) {
    return {static_cast<Real>(static_cast<double>(origin) * format.unit_of_position),
            d == 0 ? sign * std::numeric_limits<Real>::infinity()
                   : sign * (Real{1} / static_cast<Real>(d < 0 ? -d : d))};
  }
  static PlaneTime plane_time(int64_t origin, int64_t d, const Format& format) {
    return along_axis(origin, d, 1, format);
  }
  static PlaneTime height_time(int64_t z0, int64_t dz, const Format& format) {
    return along_axis(z0, dz, dz > 0 ? Real{1} : Real{-1}, format);
  }

  static Time at(const PlaneTime& plane, int64_t k) {
    const Real position = static_cast<Real>(k);
    if (std::abs(plane.inverse) == std::numeric_limits<Real>::infinity()) {
      return position > plane.origin ? plane.inverse : -plane.inverse;
    }
    return (position - plane.origin) * plane.inverse;
  }

  static int64_t cell_at(const PlaneTime& plane, int64_t origin, int64_t d, Time t, const Format& format) {
    int64_t cell = origin >> format.number.fraction_bits;
    if (d != 0 && t > 0) cell = static_cast<int64_t>(plane.origin + t / plane.inverse);
    while (at(plane, cell) > t) --cell;
    while (at(plane, cell + 1) <= t) ++cell;
    return cell;
  }

  static Time limit(const MachineRay& ray, const Format& format) {
    // Finite even at t_end, or a horizontal ray over a wrapped map would never end.
    return static_cast<Real>(static_cast<double>(ray.t_max) * format.unit_of_time);
  }
  static bool is_infinite(Time t, const Format&) { return t == std::numeric_limits<Real>::infinity(); }
  static int64_t bits(Time t) {
    if constexpr (sizeof(Real) == 4)
      return std::bit_cast<uint32_t>(t);
    else
      return std::bit_cast<int64_t>(t);
  }
};

using FloatArithmetic = RealArithmetic<float>;
using DoubleArithmetic = RealArithmetic<double>;

}  // namespace cuesta
