#pragma once

#include <bit>
#include <cstdint>

#include "models/rays/machine_ray.h"

namespace cuesta {

/// 1/d ~ mantissa * 2^exponent / 2^(D - 1 + M), mantissa in [2^(M-1), 2^M], exponent in 0 .. D-1.
struct Reciprocal {
  int64_t mantissa;
  int exponent;
};

/// `d` in 1 .. 2^D - 1. Rounded to nearest, halves up; the error is below 2^-M of the value.
inline Reciprocal reciprocal(int64_t d, const NumberFormat& format) {
  const int bits = std::bit_width(static_cast<uint64_t>(d));
  const uint64_t scaled = uint64_t{1} << (bits + format.mantissa_bits);  // twice 2^(bits - 1 + M)
  return {static_cast<int64_t>((scaled / static_cast<uint64_t>(d) + 1) >> 1), format.direction_bits - bits};
}

}  // namespace cuesta
