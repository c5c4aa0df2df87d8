#include "models/work/step_source.h"

#include <algorithm>
#include <bit>

namespace cuesta {

StepSource::StepSource(const Workload& work, const TexelLayout& layout, int line_bytes,
                       const std::vector<uint32_t>& order)
    : work_(work),
      layout_(layout),
      line_shift_(std::countr_zero(static_cast<unsigned>(line_bytes))),
      order_(order),
      walker_(make_walker(work)) {}

void StepSource::make_batch() {
  constexpr uint64_t kLinesPerBatch = 1 << 19;
  constexpr uint64_t kLargestBatch = 1024;
  Batch& batch = batches_.emplace_back();
  const uint32_t count = std::min(batch_rays_, static_cast<uint32_t>(order_.size()) - made_);
  batch.first_ray = made_;
  batch.unfinished = count;
  batch.spans.resize(count);
  batch.hits.resize(count);
  if (walker_->counts_fetches()) batch.fetches.resize(count);
  const LineRecorder recorder{&layout_, line_shift_, &batch.lines, batch.spans.data()};
  walker_->walk({work_.rays, std::span(order_).subspan(made_, count)}, batch.hits, batch.fetches, &recorder);
  made_ += count;
  const uint64_t lines_per_ray = batch.lines.size() / count + 1;
  batch_rays_ = static_cast<uint32_t>(std::clamp<uint64_t>(kLinesPerBatch / lines_per_ray, 8, kLargestBatch));
}

void StepSource::drop_finished() {
  while (!batches_.empty() && batches_.front().unfinished == 0) batches_.pop_front();
}

}  // namespace cuesta
