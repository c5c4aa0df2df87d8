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
        ends_(rays.size(), Visit::kContinue) {}

  Visit start(int ray) override { return ends_[ray] = cuesta::start(walk_, rays_[ray], states_[ray]); }
  uint64_t address(int ray) const override {
    const auto [level, i, j] = node(ray);
    return layout_.offset(level, i, j);
  }
  Visit step(int ray) override {
    const auto [level, i, j] = node(ray);
    return ends_[ray] = visit(walk_, states_[ray], pyramid_.at(level, i, j));
  }
  HitRecord record(int ray) const override {
    return hit_record(walk_, states_[ray], rays_[ray].id, ends_[ray]);
  }

 private:
  struct Node {
    int level, i, j;
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
