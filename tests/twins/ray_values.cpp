#include "tests/twins/ray_values.h"

#include <map>
#include <utility>
#include <vector>

#include "models/search/search_walk.h"

namespace cuesta::twins {
namespace {

template <class A, class G>
class TypedRayValues final : public RayValues {
 public:
  TypedRayValues(TexelLayoutKind layout, const Pyramid& pyramid, const MapShape& map,
                 const NumberFormat& format, const Schedule& schedule, std::span<const MachineRay> rays)
      : walk_(map, format, schedule, pyramid.highest()),
        layout_(layout, pyramid),
        pyramid_(pyramid),
        rays_(rays),
        states_(rays.size()),
        ends_(rays.size(), Visit::kContinue),
        kept_(rays.size()) {}

  Visit start(int ray) override { return ends_[ray] = cuesta::start(walk_, rays_[ray], states_[ray]); }
  std::vector<uint64_t> addresses(int ray) const override {
    const auto [level, i, j] = node(ray);
    if (walk_.schedule.fetch == FetchRule::kTexel) return {layout_.offset(level, i, j)};
    if (kept_[ray] == Node{level, i / 2, j / 2}) return {};
    std::vector<uint64_t> all;
    for (int y = j / 2 * 2; y < j / 2 * 2 + 2; ++y) {
      for (int x = i / 2 * 2; x < i / 2 * 2 + 2; ++x) {
        if (x < pyramid_.width(level) && y < pyramid_.height(level))
          all.push_back(layout_.offset(level, x, y));
      }
    }
    return all;
  }
  Visit step(int ray) override {
    const auto [level, i, j] = node(ray);
    kept_[ray] = {level, i / 2, j / 2};
    return ends_[ray] = visit(walk_, states_[ray], pyramid_.at(level, i, j));
  }
  HitRecord record(int ray) const override {
    return hit_record(walk_, states_[ray], rays_[ray].id, ends_[ray]);
  }

 private:
  struct Node {
    int level = -1, i = 0, j = 0;
    bool operator==(const Node&) const = default;
  };
  Node node(int ray) const {
    const RayState<A, G>& state = states_[ray];
    return {state.level, static_cast<int>(state.gx.fetch_index(walk_.x, state.level)),
            static_cast<int>(state.gy.fetch_index(walk_.y, state.level))};
  }

  Walk<A, G> walk_;
  TexelLayout layout_;
  const Pyramid& pyramid_;
  std::span<const MachineRay> rays_;
  std::vector<RayState<A, G>> states_;
  std::vector<Visit> ends_;
  std::vector<Node> kept_;  ///< level and half the indices of the siblings fetched last
};

/// Replays what a ray's search has told.
template <class Real>
class SearchRayValues final : public RayValues {
 public:
  SearchRayValues(Arithmetic arithmetic, const Search& search, const SearchMap& search_map,
                  const MapShape& map, const NumberFormat& format, double depth,
                  std::span<const MachineRay> rays)
      : arithmetic_(arithmetic),
        searcher_(search, search_map, map, format, depth),
        rays_(rays),
        told_(rays.size()),
        done_(rays.size(), 0) {}

  Visit start(int ray) override {
    records_[ray] = searcher_.trace(rays_[ray], arithmetic_, told_[ray]);
    return told_[ray].steps.empty() ? end_of(ray) : Visit::kContinue;
  }
  std::vector<uint64_t> addresses(int ray) const override { return told_[ray].steps[done_[ray]].offsets; }
  int compute_slots(int ray) const override { return told_[ray].steps[done_[ray]].compute; }
  Visit step(int ray) override {
    return ++done_[ray] == told_[ray].steps.size() ? end_of(ray) : Visit::kContinue;
  }
  HitRecord record(int ray) const override { return records_.at(ray); }

 private:
  struct Step {
    std::vector<uint64_t> offsets;
    int compute = 0;
  };
  struct Told {
    std::vector<Step> steps;
    Step now;
    void read(uint64_t offset) { now.offsets.push_back(offset); }
    void compute() { ++now.compute; }
    void end_step() { steps.push_back(std::exchange(now, {})); }
  };
  /// A ray without a step takes the slot of a dead one, hit or not.
  Visit end_of(int ray) const {
    const bool hit = records_.at(ray).status == HitStatus::kHit && !told_[ray].steps.empty();
    return hit ? Visit::kHit : Visit::kMiss;
  }

  Arithmetic arithmetic_;
  Searcher<Real> searcher_;
  std::span<const MachineRay> rays_;
  std::vector<Told> told_;
  std::vector<size_t> done_;
  std::map<int, HitRecord> records_;
};

}  // namespace

std::unique_ptr<RayValues> make_ray_values(const Architecture& architecture, const Pyramid& pyramid,
                                           const MapShape& map, const NumberFormat& format,
                                           const Schedule& schedule, std::span<const MachineRay> rays) {
  return with_traversal_types(architecture.traverse.arithmetic, map,
                              [&]<class A, class G>() -> std::unique_ptr<RayValues> {
                                return std::make_unique<TypedRayValues<A, G>>(
                                    architecture.texels.layout, pyramid, map, format, schedule, rays);
                              });
}

std::unique_ptr<RayValues> make_search_values(Arithmetic arithmetic, const Search& search,
                                              const SearchMap& search_map, const MapShape& map,
                                              const NumberFormat& format, double depth,
                                              std::span<const MachineRay> rays) {
  if (arithmetic == Arithmetic::kDouble) {
    return std::make_unique<SearchRayValues<double>>(arithmetic, search, search_map, map, format, depth,
                                                     rays);
  }
  return std::make_unique<SearchRayValues<float>>(arithmetic, search, search_map, map, format, depth, rays);
}

}  // namespace cuesta::twins
