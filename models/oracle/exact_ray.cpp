#include "models/oracle/exact_ray.h"

#include <bit>

namespace cuesta {
namespace {

int bit_length(int64_t value) { return static_cast<int>(std::bit_width(static_cast<uint64_t>(value))); }

ExactAxis<Int128> make_axis(int64_t origin, int64_t d, const NumberFormat& format, OracleInput input) {
  ExactAxis<Int128> axis;
  axis.sign = d < 0 ? -1 : d > 0 ? 1 : 0;
  axis.origin = origin;
  axis.unit = Int128{1} << format.fraction_bits;
  if (d == 0) return axis;
  const int64_t speed = d < 0 ? -d : d;
  if (input == OracleInput::kSetup) {
    const OracleReciprocal inverse = oracle_reciprocal(speed, format);
    axis.num = Int128{inverse.mantissa} << inverse.exponent;
  } else {
    axis.den = speed;
  }
  return axis;
}

}  // namespace

OracleReciprocal oracle_reciprocal(int64_t d, const NumberFormat& format) {
  const int b = bit_length(d);
  const Int128 twice = Int128{1} << (b + format.mantissa_bits);  // 2 * 2^(b-1+M)
  return {static_cast<int64_t>((twice + d) / (2 * Int128{d})), format.direction_bits - b};
}

ExactRay<Int128> exact_ray(const MachineRay& ray, const MapShape& map, const NumberFormat& format,
                           OracleInput input) {
  const int f = format.fraction_bits;
  const int64_t x0 = ray.dx < 0 ? (int64_t{map.width} << f) - ray.x0 : ray.x0;
  const int64_t y0 = ray.dy < 0 ? (int64_t{map.height} << f) - ray.y0 : ray.y0;
  ExactRay<Int128> exact;
  exact.x = make_axis(x0, ray.dx, format, input);
  exact.y = make_axis(y0, ray.dy, format, input);
  exact.z = make_axis(ray.z0, ray.dz, format, input);
  // A grid step takes 2^(D-1+M) / d machine units; asked about d itself, time is counted in that power of two.
  if (input == OracleInput::kMachineInput) {
    exact.machine_units = Int128{1} << (format.direction_bits - 1 + format.mantissa_bits);
  }
  exact.t_max = {ray.t_max, exact.machine_units};
  exact.dead = ray.dead;
  return exact;
}

}  // namespace cuesta
