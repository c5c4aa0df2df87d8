#pragma once

#include <cstdint>

#include "models/units/parameter_table.h"

namespace cuesta {

struct ResultWriterParameters {
  int burst_bytes = 64;
  int outstanding = 4;  ///< write bursts on their way
};

namespace parameter {

inline constexpr ParameterRow<ResultWriterParameters> kResultWriterParameters[] = {
    power<&ResultWriterParameters::burst_bytes>(
        "result_writer.burst_bytes", 32, 1024, "bytes",
        "Hit records (32 bytes each) are gathered into write bursts of so many bytes.", kOurs),
    number<&ResultWriterParameters::outstanding>("result_writer.outstanding", 1, 256, kTime, "bursts",
                                                 "Write bursts on their way to dram at once.", kOurs),
};

}  // namespace parameter

}  // namespace cuesta
