#pragma once

#include <string>

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

}  // namespace cuesta
