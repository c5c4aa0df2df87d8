#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "models/oracle/exact_ray.h"

namespace cuesta {

using BigInt = boost::multiprecision::cpp_int;

/// v * 2^shift, which must be whole.
inline BigInt scaled_whole(double v, int shift) {
  int exponent = 0;
  const double mantissa = std::frexp(v, &exponent);
  const BigInt whole(static_cast<int64_t>(std::ldexp(mantissa, 53)));
  const int left = exponent - 53 + shift;
  if (left >= 0) return BigInt(whole << left);
  return BigInt(whole / (BigInt(1) << -left));
}

/// The ray as traced, before anything is rounded; for rays with t_min = 0 that start inside the slab. Times are
/// the traced ray's t; t_max is taken from the machine's ray, whose limits hold for both.
inline ExactRay<BigInt> exact_traced_ray(const TracedRay& traced, const MachineRay& machine,
                                         const MapShape& map, const NumberFormat& format) {
  constexpr int kShift = 1200;  // all that a double can hold below 1, and room
  const BigInt one = BigInt(1) << kShift;
  const int64_t size[3] = {map.width, map.height, map.full_scale()};
  ExactRay<BigInt> ray;
  ExactAxis<BigInt>* const axes[3] = {&ray.x, &ray.y, &ray.z};
  for (int a = 0; a < 3; ++a) {
    ExactAxis<BigInt>& axis = *axes[a];
    const double d = traced.direction[a];
    axis.sign = d < 0 ? -1 : d > 0 ? 1 : 0;
    axis.unit = one;
    axis.origin = scaled_whole(traced.origin[a], kShift) * size[a];
    if (a < 2 && d < 0) axis.origin = BigInt(size[a]) * one - axis.origin;
    if (d != 0) axis.den = scaled_whole(std::abs(d), kShift) * size[a];
  }
  // One machine time unit is 2^-(f + D - 1 + M + q) of the traced ray's t.
  const int unit = format.fraction_bits + format.direction_bits - 1 + format.mantissa_bits + machine.exponent;
  ray.machine_units = unit >= 0 ? BigInt(BigInt(1) << unit) : BigInt(1);
  ray.t_max = {unit >= 0 ? BigInt(machine.t_max) : BigInt(BigInt(machine.t_max) << -unit), ray.machine_units};
  ray.dead = machine.dead;
  return ray;
}

}  // namespace cuesta
