#include "models/work/step_source.h"

#include <algorithm>

namespace cuesta {

void StepSource::make_batch() {
  constexpr uint64_t kLinesPerBatch = 1 << 19;
  constexpr uint64_t kLargestBatch = 1024;
  Batch& batch = batches_.emplace_back();
  const uint32_t count = std::min(batch_rays_, rays_ - made_);
  batch.first_ray = made_;
  batch.unfinished = count;
  batch.spans.resize(count);
  batch.hits.resize(count);
  produce(batch);
  made_ += count;
  const uint64_t lines_per_ray = batch.lines.size() / count + 1;
  batch_rays_ = static_cast<uint32_t>(std::clamp<uint64_t>(kLinesPerBatch / lines_per_ray, 8, kLargestBatch));
}

void StepSource::drop_finished() {
  while (!batches_.empty() && batches_.front().unfinished == 0) batches_.pop_front();
}

}  // namespace cuesta
