#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "models/common/digest.h"
#include "models/common/statistics.h"
#include "models/rays/hit.h"
#include "models/traversal/fetch.h"
#include "models/work/hit_judge.h"
#include "models/work/workload.h"

namespace cuesta {

/// What a run finds: a record for every ray, what was counted, and digests that tell two runs apart.
struct Outcome {
  std::vector<HitRecord>
      hits;  ///< in the order of the trace; when partial, unfinished rays are kDidNotFinish
  Measurements measurements;
  uint64_t finished_rays = 0;  ///< < rays: partial
  std::string hits_digest;     ///< over rays and hit records
  std::string digest;          ///< and counters and planes; empty when partial
};

/// Makes a plane of one value per ray, summed over each pixel's rays.
template <class Value>
Plane plane_of(const Workload& work, const char* name, Value&& value) {
  Plane plane;
  plane.name = name;
  plane.values.assign(static_cast<size_t>(work.width) * static_cast<size_t>(work.height), 0);
  for (size_t k = 0; k < work.rays.size(); ++k)
    plane.values[work.pixel_of_ray[k]] += static_cast<uint32_t>(value(k));
  return plane;
}

/// Adds counters over all rays (machine.rays, hits, misses, unfinished_rays, steps), the histogram of steps and the
/// plane of steps; what the rays fetched (machine.fetches, fetched_texels, texel_bytes).
void add_hit_measurements(const Workload& work, std::span<const HitRecord> hits, const FetchCounts& fetches,
                          Measurements& measurements);

/// Adds how right the hits of a search are: counters error.*, histograms of how far they lie from the true ones, the
/// plane of wrong rays; and what its map cost to make (preprocessing.*).
void add_error_measurements(const Workload& work, const Judgement& judgement, Measurements& measurements);

/// Feeds a hit record but its steps: what every exact schedule must agree on.
void add_answer(Digest& digest, const HitRecord& hit);

/// Sets the outcome's digests; `finished` false: partial, no `digest`.
void seal(const Workload& work, bool finished, Outcome& outcome);

}  // namespace cuesta
