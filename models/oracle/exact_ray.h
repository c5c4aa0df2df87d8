#pragma once

#include <cstdint>

#include "models/oracle/exact_time.h"
#include "models/rays/machine_ray.h"

namespace cuesta {

/// One axis of a ray in the mirrored frame, where nothing decreases: `origin` counts grid steps, `unit` of them
/// make a texel (or a height LSB), and the ray takes num / den of time for one grid step.
template <class Int>
struct ExactAxis {
  int sign = 0;  ///< of the direction as given: x, y: -1 was mirrored; z: -1 descends; 0: the ray never moves
  Int origin{0};
  Int unit{1};
  Int num{1};
  Int den{1};

  /// x, y: when the ray crosses texel plane `k`.
  ExactTime<Int> plane(int64_t k) const {
    const Int steps = Int(Int(k) * unit - origin);
    if (sign == 0) return steps <= 0 ? ExactTime<Int>::minus_infinity() : ExactTime<Int>::infinity();
    return {Int(steps * num), den};
  }

  /// z: when the ray reaches height `h`; a horizontal ray is below every height above it since ever.
  ExactTime<Int> reaches(int64_t h) const {
    const Int steps = Int(Int(h) * unit - origin);
    if (sign == 0) return steps > 0 ? ExactTime<Int>::minus_infinity() : ExactTime<Int>::infinity();
    return {Int(sign < 0 ? Int(-steps * num) : Int(steps * num)), den};
  }

  /// x, y: the largest K with plane(K) <= t, t finite: by division, never by search.
  int64_t cell_at(const ExactTime<Int>& t) const {
    const Int moved = sign == 0 ? Int(0) : floor_divide(Int(t.num * den), Int(t.den * num));
    return static_cast<int64_t>(floor_divide(Int(origin + moved), unit));
  }
};

template <class Int>
struct ExactRay {
  ExactAxis<Int> x, y, z;
  ExactTime<Int> t_max;
  Int machine_units{1};  ///< machine time units in one unit of this ray's time
  bool dead = false;

  /// Time in machine units, rounded to long double: for reports and for comparing with rounded times.
  long double in_machine_units(const ExactTime<Int>& t) const {
    return static_cast<long double>(t.num) * static_cast<long double>(machine_units) /
           static_cast<long double>(t.den);
  }
};

/// Which of the two questions is asked.
enum class OracleInput {
  kSetup,         ///< inverse speeds as set-up rounds them, m * 2^e: what fixed point must equal bit for bit
  kMachineInput,  ///< the components of the machine's input themselves, not rounded again
};

/// 1/d rounded half up to m * 2^e / 2^(D - 1 + M), b = bit length of d: m = round(2^(b-1+M) / d) in
/// [2^(M-1), 2^M], e = D - b.
struct OracleReciprocal {
  int64_t mantissa = 0;
  int exponent = 0;
};
OracleReciprocal oracle_reciprocal(int64_t d, const NumberFormat& format);

/// Mirrors x and y so that no component is negative (x0' = (width << f) - x0), without any rounding.
/// Products stay below 2^120 for every format that `NumberFormat` allows.
ExactRay<Int128> exact_ray(const MachineRay& ray, const MapShape& map, const NumberFormat& format,
                           OracleInput input);

}  // namespace cuesta
