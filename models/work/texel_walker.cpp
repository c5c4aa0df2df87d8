#include <array>
#include <type_traits>

#include "models/traversal/lanes.h"
#include "models/traversal/traversal.h"
#include "models/work/walker.h"

namespace cuesta {
namespace {

/// Walks over texels that are flat: boxes of their heights.
template <class A, class G>
class TexelWalker final : public Walker {
 public:
  explicit TexelWalker(const Workload& work)
      : pyramid_(*work.pyramid),
        quads_(work.schedule.fetch == FetchRule::kQuad),
        walk_(work.map, work.format, work.schedule, work.pyramid->highest()) {
    for (int level = 0; level <= pyramid_.root_level(); ++level) {
      levels_[static_cast<size_t>(level)] = {pyramid_.level(level), pyramid_.width(level)};
    }
  }

  bool counts_fetches() const override { return quads_; }

  void walk(const RayBatch& batch, std::span<HitRecord> hits, std::span<FetchCounts> fetches,
            const LineRecorder* recorder) const override {
    if constexpr (std::is_same_v<Walk<A, G>, Walk<FixedArithmetic, PlainAxis>>) {
      if (lanes_can(walk_) && (recorder == nullptr || recorder->layout->kind() != TexelLayoutKind::kMorton)) {
        traverse_lanes(walk_, pyramid_, batch.rays, batch.order, hits, recorder);
        return;
      }
    }
    if (quads_) return walk_quads(batch, hits, fetches, recorder);
    if (recorder == nullptr) {
      for (size_t k = 0; k < batch.size(); ++k) {
        hits[k] = traverse_ray(walk_, batch[k],
                               [&](int level, int64_t i, int64_t j) { return height(level, i, j); });
      }
      return;
    }
    for_each_ray(batch.size(), recorder, [&](size_t k) {
      hits[k] = traverse_ray(walk_, batch[k], [&](int level, int64_t i, int64_t j) {
        recorder->lines->push_back(recorder->line_of(level, static_cast<int>(i), static_cast<int>(j)));
        return height(level, i, j);
      });
    });
  }

 private:
  struct LevelView {
    const uint16_t* texels;
    int64_t width;
  };

  int64_t height(int level, int64_t i, int64_t j) const {
    const LevelView& view = levels_[static_cast<size_t>(level)];
    return view.texels[j * view.width + i];
  }

  void walk_quads(const RayBatch& batch, std::span<HitRecord> hits, std::span<FetchCounts> fetches,
                  const LineRecorder* recorder) const {
    for_each_ray(batch.size(), recorder, [&](size_t k) {
      KeptQuad kept;
      FetchCounts& counts = fetches[k];
      hits[k] = traverse_ray(walk_, batch[k], [&](int level, int64_t i, int64_t j) {
        if (kept.fetches(level, i, j)) {
          const Quad quad = Quad::of(pyramid_, level, static_cast<int>(i), static_cast<int>(j));
          if (recorder != nullptr) append_lines(*recorder, quad);
          counts.add({1, int64_t{quad.width} * quad.height});
        } else if (recorder != nullptr) {
          recorder->lines->push_back(kKeptStep);
        }
        return height(level, i, j);
      });
    });
  }

  const Pyramid& pyramid_;
  bool quads_;
  Walk<A, G> walk_;
  std::array<LevelView, 32> levels_{};
};

}  // namespace

std::unique_ptr<Walker> make_texel_walker(const Workload& work) {
  return with_traversal_types(work.arithmetic, work.map, [&]<class A, class G>() -> std::unique_ptr<Walker> {
    return std::make_unique<TexelWalker<A, G>>(work);
  });
}

}  // namespace cuesta
