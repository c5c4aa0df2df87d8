#pragma once

#include <cstdint>

namespace cuesta {

/// Rounds `height` to the nearest value of ten bits after the leading one (IEEE half precision), ties to
/// even; where that lies above `full_scale`, to the largest below it. Heights as fractions of 2^B: the scale
/// takes no part.
int64_t in_half_precision(int64_t height, int64_t full_scale);

}  // namespace cuesta
