#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "models/rays/hit.h"
#include "models/traversal/fetch.h"

namespace cuesta {

/// The steps of one ray: the lines of memory that its node visits read, in order, marked as fetch.h says: one a step
/// with FetchRule::kTexel. Empty: dead at set-up.
struct RaySteps {
  const uint32_t* next;
  const uint32_t* end;
};

/// Where the steps of a ray lie in a list of lines.
struct LineSpan {
  uint64_t first;
  uint64_t count;
};

/// Where the cycle model gets the value from: what each ray visits and where it ends. No step depends on time, so
/// the value is computed apart, a batch of rays ahead, by the same code as in the functional run; the units in
/// time only ask which line comes next.
///
/// Rays are numbered in the machine's order and asked for in about that order; a batch is dropped when all its
/// rays are done.
class StepSource {
 public:
  /// `rays`: those that there are; `set_rays` when more have come.
  explicit StepSource(uint32_t rays) : rays_(rays) {}
  virtual ~StepSource() = default;
  StepSource(const StepSource&) = delete;
  StepSource& operator=(const StepSource&) = delete;

  void set_rays(uint32_t rays) { rays_ = rays; }

  /// Of a ray that is there; valid until `finish(ray)`.
  RaySteps steps(uint32_t ray) {
    while (ray >= made_) make_batch();
    const Batch& batch = batch_of(ray);
    const LineSpan& span = batch.spans[ray - batch.first_ray];
    return {batch.lines.data() + span.first, batch.lines.data() + span.first + span.count};
  }
  /// Where the ray ends; returns what it has read over all its steps, which are dropped.
  FetchCounts finish(uint32_t ray, HitRecord& hit) {
    Batch& batch = batch_of(ray);
    hit = batch.hits[ray - batch.first_ray];
    const FetchCounts fetches =
        batch.fetches.empty() ? FetchCounts{hit.steps, hit.steps} : batch.fetches[ray - batch.first_ray];
    if (--batch.unfinished == 0) drop_finished();
    return fetches;
  }

 protected:
  struct Batch {
    uint32_t first_ray = 0;
    uint32_t unfinished = 0;
    std::vector<uint32_t> lines;       ///< of all its rays, one after the other
    std::vector<LineSpan> spans;       ///< per ray, in `lines`
    std::vector<HitRecord> hits;       ///< per ray
    std::vector<FetchCounts> fetches;  ///< per ray; empty: each step fetches one texel
  };

  /// Fills lines, spans and hits of the rays first_ray .. first_ray + spans.size() - 1.
  virtual void produce(Batch& batch) = 0;

 private:
  Batch& batch_of(uint32_t ray) {
    for (Batch& batch : batches_) {
      if (ray - batch.first_ray < batch.spans.size()) return batch;
    }
    return batches_.back();  // not reached: rays are asked for before they are done
  }
  void make_batch();
  void drop_finished();

  uint32_t rays_;
  uint32_t made_ = 0;
  uint32_t batch_rays_ = 256;  ///< of the next batch, so that its lines stay within a few megabytes
  std::deque<Batch> batches_;
};

}  // namespace cuesta
