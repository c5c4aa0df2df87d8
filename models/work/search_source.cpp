#include "models/work/search_source.h"

#include <algorithm>
#include <bit>

#include "models/search/search_walk.h"
#include "models/traversal/fetch.h"

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

/// Writes down the slots of each step as fetch.h marks them: arithmetic first, then the different lines. The counts
/// are CountSink's.
class LineSink {
 public:
  LineSink(int line_shift, std::vector<uint32_t>& lines, FetchCounts& counts)
      : line_shift_(line_shift), lines_(lines), counts_(counts) {}
  void read(uint64_t offset) {
    counts_.read(offset);
    const auto line = static_cast<uint32_t>(offset >> line_shift_);
    if (std::find(step_.begin(), step_.begin() + step_lines_, line) == step_.begin() + step_lines_)
      step_[step_lines_++] = line;
  }
  void compute() { ++compute_; }
  void end_step() {
    counts_.end_step();
    const int slots =
        step_lines_ == 0 ? compute_ - 1 : compute_;  // without a line the last slot ends the step
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

template <class Real>
class SearchSource final : public StepSource {
 public:
  SearchSource(const Workload& work, const Architecture& architecture, const std::vector<uint32_t>& order)
      : StepSource(static_cast<uint32_t>(order.size())),
        work_(work),
        order_(order),
        arithmetic_(architecture.traverse.arithmetic),
        line_shift_(std::countr_zero(static_cast<unsigned>(architecture.height_l1.line_bytes))),
        searcher_(*work.search, *work.search_map, work.map, number_format(architecture.traverse, work.map),
                  work.depth) {}

 private:
  void produce(Batch& batch) override {
    batch.fetches.resize(batch.spans.size());
    for (size_t k = 0; k < batch.spans.size(); ++k) {
      const uint64_t first = batch.lines.size();
      LineSink sink(line_shift_, batch.lines, batch.fetches[k]);
      batch.hits[k] = searcher_.trace(work_.rays[order_[batch.first_ray + k]], arithmetic_, sink);
      batch.spans[k] = {first, batch.lines.size() - first};
    }
  }

  const Workload& work_;
  const std::vector<uint32_t>& order_;
  Arithmetic arithmetic_;
  int line_shift_;
  Searcher<Real> searcher_;
};

/// Searches compute in double where the machine does, else in float.
template <class Body>
decltype(auto) with_search_real(Arithmetic arithmetic, Body&& body) {
  return arithmetic == Arithmetic::kDouble ? body.template operator()<double>()
                                           : body.template operator()<float>();
}

constexpr size_t kRaysPerReport = 1 << 14;

}  // namespace

std::unique_ptr<StepSource> make_search_source(const Workload& work, const Architecture& architecture,
                                               const std::vector<uint32_t>& order) {
  return with_search_real(architecture.traverse.arithmetic, [&]<class Real>() -> std::unique_ptr<StepSource> {
    return std::make_unique<SearchSource<Real>>(work, architecture, order);
  });
}

uint64_t search_all(const Workload& work, const Architecture& architecture, const Progress& progress,
                    std::vector<HitRecord>& hits, FetchCounts& fetches) {
  const Arithmetic arithmetic = architecture.traverse.arithmetic;
  const NumberFormat format = number_format(architecture.traverse, work.map);
  return with_search_real(arithmetic, [&]<class Real>() -> uint64_t {
    const Searcher<Real> searcher(*work.search, *work.search_map, work.map, format, work.depth);
    CountSink sink(fetches);
    for (size_t k = 0; k < work.rays.size(); ++k) {
      if (k % kRaysPerReport == 0 && progress && !progress(k, work.rays.size())) return k;
      hits[k] = searcher.trace(work.rays[k], arithmetic, sink);
    }
    if (progress) progress(work.rays.size(), work.rays.size());
    return work.rays.size();
  });
}

}  // namespace cuesta
