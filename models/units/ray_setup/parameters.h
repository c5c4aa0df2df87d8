#pragma once

#include <cstdint>

#include "models/units/parameter_table.h"

namespace cuesta {

struct RaySetupParameters {
  int latency_cycles = 24;  ///< clip, three reciprocals, start level
  int interval_cycles = 4;  ///< cycles between two rays entering: set by the number of reciprocal units
  int queue_depth = 8;      ///< rays in set-up or waiting for a context
};

namespace parameter {

inline constexpr ParameterRow<RaySetupParameters> kRaySetupParameters[] = {
    number<&RaySetupParameters::latency_cycles>(
        "ray_setup.latency_cycles", 1, 1000, kTime, "cycles",
        "From a ray's entry to its readiness for traverse: clip, three reciprocals, start level.", kOurs),
    number<&RaySetupParameters::interval_cycles>(
        "ray_setup.interval_cycles", 1, 1000, kTime, "cycles",
        "Between two rays that enter: set by the number of reciprocal units.", kOurs),
    number<&RaySetupParameters::queue_depth>("ray_setup.queue_depth", 1, 1024, kTime, "rays",
                                             "Rays in set-up or waiting for a context of traverse.", kOurs),
};

}  // namespace parameter

}  // namespace cuesta
