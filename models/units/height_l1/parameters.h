#pragma once

#include <cstdint>

#include "models/units/parameter_table.h"

namespace cuesta {

struct HeightL1Parameters {
  int size_bytes = 16384;
  int line_bytes = 64;
  int ways = 4;
  int mshrs = 8;
};

namespace parameter {

inline constexpr ParameterRow<HeightL1Parameters> kHeightL1Parameters[] = {
    power<&HeightL1Parameters::size_bytes>("height_l1.size_bytes", 16, 1 << 24, "bytes",
                                           "Data bytes of each pipeline's private cache of pyramid texels.",
                                           kOurs),
    power<&HeightL1Parameters::line_bytes>("height_l1.line_bytes", 16, 1024, "bytes",
                                           "Bytes of a line: what one miss fetches.", kOurs),
    number<&HeightL1Parameters::ways>("height_l1.ways", 1, 64, kTime, "",
                                      "Lines of a set; the least recently used one is replaced.", kOurs),
    number<&HeightL1Parameters::mshrs>(
        "height_l1.mshrs", 1, 64, kTime, "",
        "Misses to different lines on their way at once; misses to one line merge.", kOurs),
};

}  // namespace parameter

}  // namespace cuesta
