#include "models/work/bilinear_run.h"

#include <algorithm>

#include "models/traversal/bilinear.h"
#include "models/traversal/fetch.h"
#include "models/work/walk_source.h"

namespace cuesta {

namespace {

constexpr size_t kRaysPerReport = 1 << 14;

/// Counts what one ray reads.
class FetchReader {
 public:
  FetchReader(const Pyramid& pyramid, FetchRule rule) : pyramid_(pyramid), quads_(rule == FetchRule::kQuad) {}

  void node(int level, int i, int j) {
    if (!quads_) return counts_.add({1, 1});
    if (!kept_.fetches(level, i, j)) return;
    const Quad quad = Quad::of(pyramid_, level, i, j);
    counts_.add({1, int64_t{quad.width} * quad.height});
  }
  void patch(const PatchCorners& corners) {
    counts_.add({1, corners.samples()});
    kept_ = {};
  }
  const FetchCounts& counts() const { return counts_; }

 private:
  const Pyramid& pyramid_;
  bool quads_;
  KeptQuad kept_;
  FetchCounts counts_;
};

/// The same, and the lines in which it lies.
class LineReader {
 public:
  LineReader(const Pyramid& pyramid, const TexelLayout& layout, int line_shift, FetchRule rule,
             std::vector<uint32_t>& lines)
      : counted_(pyramid, rule),
        pyramid_(pyramid),
        layout_(layout),
        line_shift_(line_shift),
        quads_(rule == FetchRule::kQuad),
        lines_(lines) {}

  void node(int level, int i, int j) {
    const int64_t before = counted_.counts().fetches;
    counted_.node(level, i, j);
    if (counted_.counts().fetches == before) {
      lines_.push_back(kKeptStep);
    } else if (quads_) {
      append_lines(layout_, line_shift_, Quad::of(pyramid_, level, i, j), lines_);
    } else {
      lines_.push_back(line_of(level, i, j));
    }
  }

  /// The different lines of the samples, in the map's own order; all but the last carry kMoreLines.
  void patch(const PatchCorners& corners) {
    counted_.patch(corners);
    const size_t first = lines_.size();
    for (const int j : in_order(corners.j)) {
      for (const int i : in_order(corners.i)) {
        const uint32_t line = line_of(0, i, j);
        if (std::find(lines_.begin() + static_cast<ptrdiff_t>(first), lines_.end(), line) == lines_.end()) {
          lines_.push_back(line);
        }
      }
    }
    for (size_t k = first; k + 1 < lines_.size(); ++k) lines_[k] |= kMoreLines;
  }
  const FetchCounts& counts() const { return counted_.counts(); }

 private:
  static std::array<int, 2> in_order(const std::array<int, 2>& pair) {
    return {std::min(pair[0], pair[1]), std::max(pair[0], pair[1])};
  }
  uint32_t line_of(int level, int i, int j) const {
    return static_cast<uint32_t>(layout_.offset(level, i, j) >> line_shift_);
  }

  FetchReader counted_;
  const Pyramid& pyramid_;
  const TexelLayout& layout_;
  int line_shift_;
  bool quads_;
  std::vector<uint32_t>& lines_;
};

template <class A, class G>
class BilinearSource final : public WalkSource<A, G> {
 public:
  using WalkSource<A, G>::WalkSource;

 private:
  using Batch = StepSource::Batch;
  using WalkSource<A, G>::layout_;
  using WalkSource<A, G>::line_shift_;
  using WalkSource<A, G>::walk_;
  using WalkSource<A, G>::work_;

  void produce(Batch& batch) override {
    batch.fetches.resize(batch.spans.size());
    for (size_t k = 0; k < batch.spans.size(); ++k) {
      const uint64_t first = batch.lines.size();
      LineReader reader(*work_.pyramid, layout_, line_shift_, work_.schedule.fetch, batch.lines);
      batch.hits[k] = traverse_bilinear_ray(walk_, *work_.pyramid, this->ray_at(batch, k), reader);
      batch.spans[k] = {first, batch.lines.size() - first};
      batch.fetches[k] = reader.counts();
    }
  }
};

}  // namespace

uint64_t trace_bilinear(const Workload& work, Arithmetic arithmetic, const NumberFormat& format,
                        const Progress& progress, std::vector<HitRecord>& hits, FetchCounts& fetches) {
  return with_bilinear_types(arithmetic, work.map, [&]<class A, class G>() -> uint64_t {
    const Walk<A, G> walk(work.map, format, work.schedule, work.pyramid->highest());
    for (size_t k = 0; k < work.rays.size(); ++k) {
      if (k % kRaysPerReport == 0 && progress && !progress(k, work.rays.size())) return k;
      FetchReader reader(*work.pyramid, work.schedule.fetch);
      hits[k] = traverse_bilinear_ray(walk, *work.pyramid, work.rays[k], reader);
      fetches.add(reader.counts());
    }
    if (progress) progress(work.rays.size(), work.rays.size());
    return work.rays.size();
  });
}

std::unique_ptr<StepSource> make_bilinear_source(const Workload& work, const Architecture& architecture,
                                                 const TexelLayout& layout,
                                                 const std::vector<uint32_t>& order) {
  return with_bilinear_types(
      architecture.traverse.arithmetic, work.map, [&]<class A, class G>() -> std::unique_ptr<StepSource> {
        return std::make_unique<BilinearSource<A, G>>(work, architecture, layout, order);
      });
}

}  // namespace cuesta
