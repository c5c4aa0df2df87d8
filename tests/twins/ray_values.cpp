#include "tests/twins/ray_values.h"

#include <vector>

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

}  // namespace cuesta::twins
