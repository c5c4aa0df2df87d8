#include "sim/verify/lockstep/shrink.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "models/common/error.h"
#include "models/units/ray_dispatch/dispatch_order.h"

namespace cuesta {
namespace {

class Shrinker {
 public:
  Shrinker(const LockstepCase& failing, const CaseFails& fails, int most_runs)
      : best_(failing), fails_(fails), most_runs_(most_runs) {}

  ShrunkCase run(uint64_t completed) {
    rays_about(completed);
    // The machine and the map first, as far as groups of rays go: single rays then cost little.
    fewer_rays(best_.rays.size() / 16);
    simpler_machine();
    smaller_map();
    bool smaller = true;
    while (smaller && !spent()) {
      smaller = fewer_rays(1);
      smaller |= simpler_machine();
      smaller |= smaller_map();
    }
    return {std::move(best_), runs_, !spent()};
  }

 private:
  bool spent() const { return runs_ >= most_runs_; }

  /// Keeps the candidate if it fails.
  bool keep(LockstepCase candidate) {
    if (spent()) return false;
    ++runs_;
    try {
      if (!fails_(candidate)) return false;
    } catch (const Error&) {
      return false;
    }
    best_ = std::move(candidate);
    return true;
  }
  /// The same after `change`, which says whether it has changed anything.
  template <class Change>
  bool keep_with(Change change) {
    LockstepCase candidate = best_;
    return change(candidate) && keep(std::move(candidate));
  }

  /// The last 64, 256, 1024 ... of the rays that can have been inside by then, in the machine's order.
  void rays_about(uint64_t completed) {
    const Architecture& a = best_.machine.architecture;
    std::vector<uint32_t> order(best_.rays.size());
    std::iota(order.begin(), order.end(), 0u);
    if (!best_.machine.memory) {
      std::vector<uint32_t> pixels;
      for (const TracedRay& ray : best_.rays)
        pixels.push_back(ray.pixel_y * static_cast<uint32_t>(best_.width) + ray.pixel_x);
      order = dispatch_order(pixels, best_.width, a.ray_dispatch.order, a.ray_dispatch.tile_size);
    }
    const uint64_t inside =
        static_cast<uint64_t>(a.machine.pipelines) *
        static_cast<uint64_t>(a.traverse.contexts + a.ray_setup.queue_depth + a.ray_dispatch.queue_depth);
    const size_t end = std::min<size_t>(order.size(), completed + inside + 1);
    for (size_t count = 64; count < order.size(); count *= 4) {
      std::vector<uint32_t> kept(order.begin() + static_cast<std::ptrdiff_t>(end - std::min(end, count)),
                                 order.begin() + static_cast<std::ptrdiff_t>(end));
      std::ranges::sort(kept);
      LockstepCase candidate = without_rays();
      for (const uint32_t ray : kept) candidate.rays.push_back(best_.rays[ray]);
      if (keep(std::move(candidate)) || spent()) return;
    }
  }
  LockstepCase without_rays() {
    std::vector<TracedRay> rays;
    rays.swap(best_.rays);
    LockstepCase copy = best_;
    rays.swap(best_.rays);
    return copy;
  }

  /// Groups of half the rays, a quarter ... down to `least`.
  bool fewer_rays(size_t least) {
    bool smaller = false;
    for (size_t chunk = (best_.rays.size() + 1) / 2; chunk >= std::max<size_t>(least, 1) && !spent();) {
      bool kept = false;
      for (size_t first = 0; first < best_.rays.size() && best_.rays.size() > 1 && !spent();) {
        LockstepCase candidate = best_;
        const size_t last = std::min(first + chunk, candidate.rays.size());
        candidate.rays.erase(candidate.rays.begin() + static_cast<std::ptrdiff_t>(first),
                             candidate.rays.begin() + static_cast<std::ptrdiff_t>(last));
        if (!candidate.rays.empty() && keep(std::move(candidate))) {
          kept = smaller = true;
        } else {
          first = last;
        }
      }
      if (chunk > 1 || !kept) chunk /= 2;
    }
    return smaller;
  }

  bool simpler_machine() {
    bool smaller = keep_with(
        [](LockstepCase& c) { return std::exchange(c.machine.architecture.machine.pipelines, 1) > 1; });
    smaller |= keep_with([](LockstepCase& c) {
      bool any = false;
      for (uint16_t& chance : c.machine.stalls.per_mille) any |= std::exchange(chance, 0) > 0;
      return any;
    });
    for (int port = 0; port < kPortCount; ++port) {
      smaller |= keep_with(
          [port](LockstepCase& c) { return std::exchange(c.machine.stalls.per_mille[port], 0) > 0; });
    }
    smaller |=
        keep_with([](LockstepCase& c) { return std::exchange(c.machine.memory, std::nullopt).has_value(); });
    smaller |= keep_with([](LockstepCase& c) {
      return c.machine.memory && std::exchange(c.machine.memory->most_gap_cycles, 0) > 0;
    });
    smaller |= keep_with([](LockstepCase& c) {
      if (!c.machine.memory) return false;
      const int least = c.machine.memory->least_cycles;
      return std::exchange(c.machine.memory->most_cycles, least) > least;
    });
    smaller |= keep_with([](LockstepCase& c) { return std::exchange(c.machine.schedule.stop_level, 0) > 0; });
    smaller |= keep_with([](LockstepCase& c) {
      return std::exchange(c.machine.schedule.start, StartRule::kRoot) != StartRule::kRoot;
    });
    return smaller;
  }

  bool smaller_map() {
    bool smaller = false;
    bool kept = true;
    while (kept && best_.pyramid->width(0) > 1 && best_.pyramid->height(0) > 1) {
      kept = false;
      for (int quarter = 0; quarter < 4 && !kept; ++quarter) {
        kept = keep_with([quarter](LockstepCase& c) {
          const Pyramid& whole = *c.pyramid;
          HeightGrid grid{whole.width(0) / 2, whole.height(0) / 2, whole.bits(), {}};
          const int i0 = quarter % 2 * grid.width, j0 = quarter / 2 * grid.height;
          for (int j = 0; j < grid.height; ++j) {
            for (int i = 0; i < grid.width; ++i) grid.texels.push_back(whole.at(0, i0 + i, j0 + j));
          }
          c.pyramid = std::make_shared<Pyramid>(build_max_pyramid(grid));
          return c.machine.schedule.stop_level <= c.pyramid->root_level();
        });
      }
      smaller |= kept;
    }
    return smaller;
  }

  LockstepCase best_;
  const CaseFails& fails_;
  int most_runs_;
  int runs_ = 0;
};

}  // namespace

ShrunkCase shrink(const LockstepCase& failing, const CaseFails& fails, uint64_t completed, int most_runs) {
  return Shrinker(failing, fails, most_runs).run(completed);
}

}  // namespace cuesta
