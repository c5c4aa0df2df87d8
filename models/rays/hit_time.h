#pragma once

#include <bit>

#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"

namespace cuesta {

/// The time behind the bits of a hit record: in float and double the number that they are, exactly; in fixed point
/// machine time units, rounded to nearest beyond 2^53.
inline double recorded_time(const HitRecord& hit, Arithmetic arithmetic) {
  if (arithmetic == Arithmetic::kFloat) return std::bit_cast<float>(static_cast<uint32_t>(hit.t));
  if (arithmetic == Arithmetic::kDouble) return std::bit_cast<double>(hit.t);
  return static_cast<double>(hit.t);
}

}  // namespace cuesta
