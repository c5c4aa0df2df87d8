#pragma once

#include <cstdint>
#include <span>

#include "models/units/hmt/hmt_site.h"
#include "models/units/memory/memory_port.h"
#include "models/work/outcome.h"

namespace cuesta {

/// Adds what only time knows: histogram of latencies; planes of issue slots, misses, memory traffic and latency.
/// `timing` and `memory` in the order of the trace; `traverse_cycles`: over all pipelines; `dram_inside`: the bus
/// and the rows of dram are known, too.
void add_ray_measurements(const Workload& work, std::span<const HitRecord> hits,
                          std::span<const RayTiming> timing, std::span<const MemoryCost> memory,
                          int64_t traverse_cycles, bool dram_inside, Measurements& measurements);

}  // namespace cuesta
