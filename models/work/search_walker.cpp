#include <algorithm>
#include <array>

#include "models/search/search_walk.h"
#include "models/work/walker.h"

namespace cuesta {
namespace {

/// Counts the steps that read, and what they read.
class CountSink {
 public:
  explicit CountSink(FetchCounts& counts) : counts_(counts) {}
  void read(uint64_t) { ++texels_; }
  void compute() {}
  void end_step() {
    counts_.add({texels_ > 0, texels_});
    texels_ = 0;
  }

 private:
  FetchCounts& counts_;
  int64_t texels_ = 0;
};

/// Writes down the slots of each step as step_lines.h marks them: arithmetic first, then the different lines. The
/// counts are CountSink's.
class LineSink {
 public:
  LineSink(const LineRecorder& recorder, FetchCounts& counts)
      : line_shift_(recorder.line_shift), lines_(*recorder.lines), counts_(counts) {}
  void read(uint64_t offset) {
    counts_.read(offset);
    const auto line = static_cast<uint32_t>(offset >> line_shift_);
    if (std::find(step_.begin(), step_.begin() + step_lines_, line) == step_.begin() + step_lines_)
      step_[step_lines_++] = line;
  }
  void compute() { ++compute_; }
  void end_step() {
    counts_.end_step();
    // Without a line the last slot of arithmetic ends the step.
    const int slots = step_lines_ == 0 ? compute_ - 1 : compute_;
    for (int k = 0; k < slots; ++k) lines_.push_back(kComputeSlot);
    for (int k = 0; k < step_lines_; ++k) lines_.push_back(step_[k] | kMoreLines);
    if (step_lines_ == 0)
      lines_.push_back(kKeptStep);
    else
      lines_.back() &= ~kMoreLines;
    step_lines_ = compute_ = 0;
  }

 private:
  static constexpr int kMostTexels = 8;
  int line_shift_;
  std::vector<uint32_t>& lines_;
  CountSink counts_;
  std::array<uint32_t, kMostTexels> step_{};
  int step_lines_ = 0, compute_ = 0;
};

/// Searches approximately, in Real.
template <class Real>
class SearchWalker final : public Walker {
 public:
  explicit SearchWalker(const Workload& work)
      : arithmetic_(work.arithmetic),
        searcher_(*work.search, *work.search_map, work.map, work.format, work.depth) {}

  bool counts_fetches() const override { return true; }

  void walk(const RayBatch& batch, std::span<HitRecord> hits, std::span<FetchCounts> fetches,
            const LineRecorder* recorder) const override {
    for_each_ray(batch.size(), recorder, [&](size_t k) {
      if (recorder != nullptr) {
        LineSink sink(*recorder, fetches[k]);
        hits[k] = searcher_.trace(batch[k], arithmetic_, sink);
      } else {
        CountSink sink(fetches[k]);
        hits[k] = searcher_.trace(batch[k], arithmetic_, sink);
      }
    });
  }

 private:
  Arithmetic arithmetic_;
  Searcher<Real> searcher_;
};

}  // namespace

std::unique_ptr<Walker> make_search_walker(const Workload& work) {
  // Searches compute in double where the machine does, else in float.
  if (work.arithmetic == Arithmetic::kDouble) return std::make_unique<SearchWalker<double>>(work);
  return std::make_unique<SearchWalker<float>>(work);
}

}  // namespace cuesta
