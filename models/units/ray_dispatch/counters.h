#pragma once

#include <cstdint>

#include "models/common/counter_table.h"

namespace cuesta {

/// What ray_dispatch has counted.
struct RayDispatchCounts {
  int64_t rays = 0;
};

inline constexpr CounterRow<RayDispatchCounts> kRayDispatchCounters[] = {
    {"ray_dispatch.rays", "rays", "Rays sent to the pipelines.", &RayDispatchCounts::rays},
};

}  // namespace cuesta
