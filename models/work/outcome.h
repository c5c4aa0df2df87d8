#pragma once

#include <span>
#include <vector>

#include "models/common/digest.h"
#include "models/units/memory/memory_port.h"
#include "models/units/traverse/traverse_unit.h"
#include "models/work/hit_judge.h"
#include "models/work/workload.h"

namespace cuesta {

/// Counters over all rays (machine.rays, hits, misses, unfinished_rays, steps), the histogram of steps and the
/// plane of steps; what the rays fetched (machine.fetches, fetched_texels, texel_bytes).
void add_hit_measurements(const Workload& work, std::span<const HitRecord> hits, const FetchCounts& fetches,
                          Measurements& measurements);

/// What only time knows: histogram of latencies; planes of issue slots, misses, memory traffic and latency.
/// `timing` and `memory` in the order of the trace; `traverse_cycles`: over all pipelines; `dram_inside`: the bus
/// and the rows of dram are known, too.
void add_ray_measurements(const Workload& work, std::span<const HitRecord> hits,
                          std::span<const RayTiming> timing, std::span<const MemoryCost> memory,
                          int64_t traverse_cycles, bool dram_inside, Measurements& measurements);

/// How right the hits of a search are: counters error.*, histograms of how far they lie from the true ones, the plane
/// of wrong rays; and what its map cost to make (preprocessing.*).
void add_error_measurements(const Workload& work, const Judgement& judgement, Measurements& measurements);

/// A hit record but its steps: what every exact schedule must agree on.
void add_answer(Digest& digest, const HitRecord& hit);

/// Sets the digests; `finished` false: partial, no `digest`.
void seal(const Workload& work, bool finished, Outcome& outcome);

}  // namespace cuesta
