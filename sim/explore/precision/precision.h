#pragma once

#include <span>
#include <string>

#include "models/oracle/oracle.h"
#include "models/oracle/traced_ray.h"
#include "sim/explore/study/study.h"

namespace cuesta {

/// Asks how far from the truth each format of numbers puts a hit, and how narrow one may be.
Study precision_study();

// Its page, for the plan's file and for tests.
std::string precision_page(const StudyData& data);
std::string precision_headline(const StudyData& data);

/// What plan and page have in common.
namespace precision {

inline constexpr int kParts = 65536;  ///< of a height LSB and of a texel: errors are counted in them
inline constexpr int kTileBits = 4;   ///< of every fixed-point format
inline constexpr int kFractionBits[] = {4, 6, 8, 10, 12};
inline constexpr int kMantissaBits[] = {0, 2, 4, 6, 8};  ///< beyond the bits of a height
inline constexpr int kDirectionBits[] = {16, 20, 24, 28, 32};

/// Names a fixed-point format on the axis `format`: "f8/M+4/D32". The others there are "double" and "float".
std::string fixed_format(int fraction, int mantissa, int direction);
/// Names the format of the machine's default widths.
std::string default_format();
/// Ends the name of a format with heights in half precision.
inline constexpr const char* kHalf = "/half";

}  // namespace precision

/// Finds what a descending ray hits on a repeating square map whose side is a power of two, exactly: as oracle_leaf_walk,
/// but nodes that the ray provably passes above are skipped. `levels`: views of the max pyramid, leaves first.
OracleHit<BigInt> exact_skipping_walk(const ExactRay<BigInt>& ray, std::span<const OracleMap> levels);

/// Rounds `height` to the nearest value of ten bits after the leading one (IEEE half precision), ties to even; where that
/// lies above `full_scale`, to the largest below it. Heights as fractions of 2^B: the scale takes no part.
int64_t in_half_precision(int64_t height, int64_t full_scale);

}  // namespace cuesta
