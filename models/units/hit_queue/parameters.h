#pragma once

#include <cstdint>

#include "models/units/parameter_table.h"

namespace cuesta {

struct HitQueueParameters {
  int depth = 8;
};

namespace parameter {

inline constexpr ParameterRow<HitQueueParameters> kHitQueueParameters[] = {
    number<&HitQueueParameters::depth>("hit_queue.depth", 1, 4096, kTime, "records",
                                       "Hit records that wait between a traverse and result_writer.", kOurs),
};

}  // namespace parameter

}  // namespace cuesta
