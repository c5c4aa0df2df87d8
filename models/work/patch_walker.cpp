#include <algorithm>
#include <array>

#include "models/traversal/bilinear.h"
#include "models/work/walker.h"

namespace cuesta {
namespace {

/// What one ray reads on a bilinear surface: counted, and written down where lines are asked for.
class PatchReader {
 public:
  PatchReader(const Pyramid& pyramid, FetchRule rule, FetchCounts& counts, const LineRecorder* recorder)
      : pyramid_(pyramid), quads_(rule == FetchRule::kQuad), counts_(counts), recorder_(recorder) {}

  void node(int level, int i, int j) {
    if (!quads_) {
      counts_.add({1, 1});
      if (recorder_ != nullptr) recorder_->lines->push_back(recorder_->line_of(level, i, j));
    } else if (kept_.fetches(level, i, j)) {
      const Quad quad = Quad::of(pyramid_, level, i, j);
      counts_.add({1, int64_t{quad.width} * quad.height});
      if (recorder_ != nullptr) append_lines(*recorder_, quad);
    } else if (recorder_ != nullptr) {
      recorder_->lines->push_back(kKeptStep);
    }
  }

  /// The samples at the corners of a patch, in the map's own order.
  void patch(const PatchCorners& corners) {
    counts_.add({1, corners.samples()});
    kept_ = {};
    if (recorder_ == nullptr) return;
    StepLines step(*recorder_->lines);
    for (const int j : in_order(corners.j)) {
      for (const int i : in_order(corners.i)) step.add(recorder_->line_of(0, i, j));
    }
    step.end_step();
  }

 private:
  static std::array<int, 2> in_order(const std::array<int, 2>& pair) {
    return {std::min(pair[0], pair[1]), std::max(pair[0], pair[1])};
  }

  const Pyramid& pyramid_;
  bool quads_;
  KeptQuad kept_;
  FetchCounts& counts_;
  const LineRecorder* recorder_;
};

/// Walks over bilinear patches between the texels' middles.
template <class A, class G>
class PatchWalker final : public Walker {
 public:
  explicit PatchWalker(const Workload& work)
      : pyramid_(*work.pyramid),
        fetch_(work.schedule.fetch),
        walk_(work.map, work.format, work.schedule, work.pyramid->highest()) {}

  bool counts_fetches() const override { return true; }

  void walk(const RayBatch& batch, std::span<HitRecord> hits, std::span<FetchCounts> fetches,
            const LineRecorder* recorder) const override {
    for_each_ray(batch.size(), recorder, [&](size_t k) {
      PatchReader reader(pyramid_, fetch_, fetches[k], recorder);
      hits[k] = traverse_bilinear_ray(walk_, pyramid_, batch[k], reader);
    });
  }

 private:
  const Pyramid& pyramid_;
  FetchRule fetch_;
  Walk<A, G> walk_;
};

}  // namespace

std::unique_ptr<Walker> make_patch_walker(const Workload& work) {
  return with_bilinear_types(work.arithmetic, work.map, [&]<class A, class G>() -> std::unique_ptr<Walker> {
    return std::make_unique<PatchWalker<A, G>>(work);
  });
}

}  // namespace cuesta
