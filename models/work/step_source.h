#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "models/heightmap/texel_layout.h"
#include "models/rays/hit.h"
#include "models/traversal/step_lines.h"
#include "models/work/walker.h"
#include "models/work/workload.h"

namespace cuesta {

/// Where the units in time get the value from: what each ray visits and where it ends. No step depends on time, so the
/// value is computed apart, a batch of rays ahead, by the same walker as in the functional run; the units only ask
/// which line comes next.
///
/// Rays are numbered in the machine's order and asked for in about that order; a batch is dropped when all its rays are
/// done.
class StepSource {
 public:
  /// `order`: of the machine, each a position in the trace. The rays that it names are there; it may grow. All
  /// references must outlive the source.
  StepSource(const Workload& work, const TexelLayout& layout, int line_bytes,
             const std::vector<uint32_t>& order);
  StepSource(const StepSource&) = delete;
  StepSource& operator=(const StepSource&) = delete;

  /// Returns the steps of a ray that is there; valid until `finish(ray)`.
  RaySteps steps(uint32_t ray) {
    while (ray >= made_) make_batch();
    const Batch& batch = batch_of(ray);
    const LineSpan& span = batch.spans[ray - batch.first_ray];
    return {batch.lines.data() + span.first, batch.lines.data() + span.first + span.count};
  }
  /// Says where the ray ends; returns what it has read over all its steps, which are dropped.
  FetchCounts finish(uint32_t ray, HitRecord& hit) {
    Batch& batch = batch_of(ray);
    hit = batch.hits[ray - batch.first_ray];
    const FetchCounts fetches =
        batch.fetches.empty() ? FetchCounts{hit.steps, hit.steps} : batch.fetches[ray - batch.first_ray];
    if (--batch.unfinished == 0) drop_finished();
    return fetches;
  }

 private:
  struct Batch {
    uint32_t first_ray = 0;
    uint32_t unfinished = 0;
    std::vector<uint32_t> lines;       ///< of all its rays, one after the other
    std::vector<LineSpan> spans;       ///< per ray, in `lines`
    std::vector<HitRecord> hits;       ///< per ray
    std::vector<FetchCounts> fetches;  ///< per ray; empty: each step fetches one texel
  };

  Batch& batch_of(uint32_t ray) {
    for (Batch& batch : batches_) {
      if (ray - batch.first_ray < batch.spans.size()) return batch;
    }
    return batches_.back();  // not reached: rays are asked for before they are done
  }
  void make_batch();
  void drop_finished();

  const Workload& work_;
  const TexelLayout& layout_;
  int line_shift_;
  const std::vector<uint32_t>& order_;
  std::unique_ptr<Walker> walker_;
  uint32_t made_ = 0;
  uint32_t batch_rays_ = 256;  ///< of the next batch, so that its lines stay within a few megabytes
  std::deque<Batch> batches_;
};

}  // namespace cuesta
