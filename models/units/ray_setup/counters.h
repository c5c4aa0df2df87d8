#pragma once

#include <cstdint>

#include "models/common/counter_table.h"

namespace cuesta {

/// What one ray_setup has counted.
struct RaySetupCounts {
  int64_t rays = 0;
};

inline constexpr CounterRow<RaySetupCounts> kRaySetupCounters[] = {
    {"ray_setup.rays", "rays", "Rays that entered set-up.", &RaySetupCounts::rays, 0},
};

}  // namespace cuesta
