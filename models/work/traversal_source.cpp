#include "models/work/traversal_source.h"

#include <type_traits>

#include "models/traversal/lanes.h"
#include "models/traversal/traversal.h"
#include "models/work/bilinear_run.h"
#include "models/work/search_source.h"
#include "models/work/walk_source.h"

namespace cuesta {

namespace {

template <class A, class G>
class TraversalSource final : public WalkSource<A, G> {
 public:
  using WalkSource<A, G>::WalkSource;

 private:
  using Batch = StepSource::Batch;
  using WalkSource<A, G>::layout_;
  using WalkSource<A, G>::line_shift_;
  using WalkSource<A, G>::order_;
  using WalkSource<A, G>::walk_;
  using WalkSource<A, G>::work_;

  void produce(Batch& batch) override {
    if constexpr (std::is_same_v<Walk<A, G>, Walk<FixedArithmetic, PlainAxis>>) {
      if (lanes_can(walk_) && layout_.kind() != TexelLayoutKind::kMorton) {
        const LineRecorder recorder{&layout_, line_shift_, &batch.lines, batch.spans.data()};
        traverse_lanes(walk_, *work_.pyramid, work_.rays,
                       std::span(order_).subspan(batch.first_ray, batch.spans.size()), batch.hits, &recorder);
        return;
      }
    }
    if (work_.schedule.fetch == FetchRule::kQuad) return produce_quads(batch);
    for (size_t k = 0; k < batch.spans.size(); ++k) {
      const uint64_t first = batch.lines.size();
      batch.hits[k] = traverse_ray(walk_, this->ray_at(batch, k), [&](int level, int64_t i, int64_t j) {
        const int x = static_cast<int>(i), y = static_cast<int>(j);
        batch.lines.push_back(static_cast<uint32_t>(layout_.offset(level, x, y) >> line_shift_));
        return static_cast<int64_t>(work_.pyramid->at(level, x, y));
      });
      batch.spans[k] = {first, batch.lines.size() - first};
    }
  }

  void produce_quads(Batch& batch) {
    const Pyramid& pyramid = *work_.pyramid;
    batch.fetches.resize(batch.spans.size());
    for (size_t k = 0; k < batch.spans.size(); ++k) {
      const uint64_t first = batch.lines.size();
      KeptQuad kept;
      FetchCounts& counts = batch.fetches[k];
      batch.hits[k] = traverse_ray(walk_, this->ray_at(batch, k), [&](int level, int64_t i, int64_t j) {
        const int x = static_cast<int>(i), y = static_cast<int>(j);
        if (kept.fetches(level, i, j)) {
          const Quad quad = Quad::of(pyramid, level, x, y);
          append_lines(layout_, line_shift_, quad, batch.lines);
          counts.add({1, int64_t{quad.width} * quad.height});
        } else {
          batch.lines.push_back(kKeptStep);
        }
        return static_cast<int64_t>(pyramid.at(level, x, y));
      });
      batch.spans[k] = {first, batch.lines.size() - first};
    }
  }
};

}  // namespace

std::unique_ptr<StepSource> make_traversal_source(const Workload& work, const Architecture& architecture,
                                                  const TexelLayout& layout,
                                                  const std::vector<uint32_t>& order) {
  if (work.search) return make_search_source(work, architecture, order);
  if (work.map.surface == Surface::kBilinear) return make_bilinear_source(work, architecture, layout, order);
  return with_traversal_types(
      architecture.traverse.arithmetic, work.map, [&]<class A, class G>() -> std::unique_ptr<StepSource> {
        return std::make_unique<TraversalSource<A, G>>(work, architecture, layout, order);
      });
}

}  // namespace cuesta
