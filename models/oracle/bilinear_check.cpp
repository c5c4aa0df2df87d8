#include "models/oracle/bilinear_check.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/common/error.h"
#include "models/oracle/bilinear_oracle.h"
#include "models/oracle/checked_walks.h"
#include "models/oracle/random_cases.h"
#include "models/rays/hit_time.h"
#include "models/rays/map_shape.h"
#include "models/traversal/bilinear.h"

namespace cuesta {
namespace {

constexpr int kRaysPerMap = 50;
constexpr int kPrecision = 80;  ///< bits of the exact time
constexpr int kFanSteps = 8;    ///< to either side
constexpr int kMostBorders = 200;
constexpr std::array<Arithmetic, 2> kArithmetics = {Arithmetic::kFloat, Arithmetic::kDouble};

std::string name_of(Arithmetic arithmetic) { return arithmetic == Arithmetic::kFloat ? "float" : "double"; }

/// A random map as a bilinear surface: an address mode that it can have, and half a texel on the grid.
RandomMap bilinear_map(Random& random, int max_side) {
  RandomMap map = random_map(random.next(), max_side);
  constexpr std::array<AddressMode, 3> kModes = {AddressMode::kBorder, AddressMode::kWrap,
                                                 AddressMode::kClamp};
  if (map.shape.address_mode == AddressMode::kMirror) map.shape.address_mode = kModes[random.below(3)];
  map.shape.surface = Surface::kBilinear;
  map.format.fraction_bits = std::max(1, map.format.fraction_bits);
  return map;
}

/// Moved so that what lay on texel planes lies on the planes of the patches.
TracedRay on_patches(TracedRay ray, const RandomMap& map) {
  ray.origin[0] += 0.5 / map.grid.width;
  ray.origin[1] += 0.5 / map.grid.height;
  return ray;
}

/// For walks of which nobody asks what they read.
struct NoReader {
  void node(int, int, int) {}
  void patch(const PatchCorners&) {}
};

class Checker {
 public:
  explicit Checker(const RandomMap& map)
      : map_(map),
        pyramid_(build_four_corner_pyramid(build_max_pyramid(map.grid),
                                           map.shape.address_mode == AddressMode::kWrap)) {}

  /// Throws where `quantise` does.
  MachineRay machine_ray(const TracedRay& ray) const { return quantise(ray, map_.shape, map_.format); }

  HitRecord walk(Arithmetic arithmetic, const Schedule& schedule, const MachineRay& ray) const {
    return with_bilinear_types(arithmetic, map_.shape,
                               [&]<class A, class G>() { return limited_walk<A, G>(schedule, ray); });
  }

  void check_schedules(const TracedRay& traced, const MachineRay& ray, const std::vector<Schedule>& schedules,
                       BilinearCheck& counts) const {
    for (const Arithmetic arithmetic : kArithmetics) {
      const HitRecord plain = walk(arithmetic, schedules[0], ray);
      if (plain.status == HitStatus::kDidNotFinish) ++counts.endless;
      for (size_t s = 1; s < schedules.size(); ++s) {
        const HitRecord found = walk(arithmetic, schedules[s], ray);
        if (found.status == HitStatus::kDidNotFinish) ++counts.endless;
        ++counts.comparisons;
        if (same_answer(found, plain)) continue;
        ++counts.mismatches;
        fail(counts, traced, ray,
             name_of(arithmetic) + ", " + describe(schedules[s]) + ": another answer than the leaf walk's" +
                 "\n  expected: " + describe(plain) + "\n  found:    " + describe(found));
      }
      if (arithmetic == Arithmetic::kDouble && plain.status == HitStatus::kHit) ++counts.hits;
    }
    count_ray(counts);
  }

  void check_exactly(const MachineRay& ray, BilinearCheck& counts) const {
    const BilinearOracle oracle(ray, map_.grid, map_.shape, map_.format);
    const BilinearHit truth = oracle.walk(kPrecision);
    for (size_t a = 0; a < kArithmetics.size(); ++a) {
      const HitRecord found = walk(kArithmetics[a], {StartRule::kLeaf, 1, UpRule::kNever}, ray);
      judge(oracle, truth, found, kArithmetics[a], counts.exact[a]);
    }
    if (truth.hit) ++counts.hits;
    count_ray(counts);
  }

  void check_borders(const TracedRay& traced, const MachineRay& ray, BilinearCheck& counts) const {
    for (const Arithmetic arithmetic : kArithmetics) {
      with_bilinear_types(arithmetic, map_.shape, [&]<class A, class G>() {
        std::string fault = cross_borders<A, G>(ray, counts);
        if (!fault.empty()) fail(counts, traced, ray, name_of(arithmetic) + ": " + fault);
      });
    }
    count_ray(counts);
  }

 private:
  template <class A, class G>
  Walk<A, G> walk_of(const Schedule& schedule) const {
    return {map_.shape, map_.format, schedule, pyramid_.highest()};
  }

  template <class A, class G>
  HitRecord limited_walk(const Schedule& schedule, const MachineRay& input) const {
    const Walk<A, G> walk = walk_of<A, G>(schedule);
    BilinearState<A, G> state;
    const int64_t limit = most_steps(map_.shape, map_.format);
    Visit now = start_bilinear(walk, input, state);
    NoReader nobody;
    while (now == Visit::kContinue) {
      now = step_bilinear(walk, pyramid_, state, nobody);
      if (state.ray.steps > limit) {
        HitRecord record;
        record.status = HitStatus::kDidNotFinish;
        return record;
      }
    }
    return hit_record(walk, state.ray, input.id, now);
  }

  /// From leaf to leaf, through the surface too. A sentence about the first fault.
  template <class A, class G>
  std::string cross_borders(const MachineRay& input, BilinearCheck& counts) const {
    using Real = typename A::Time;
    const Walk<A, G> walk = walk_of<A, G>({StartRule::kLeaf, 1, UpRule::kNever});
    std::string fault;
    BilinearState<A, G> state;
    Visit now = start_bilinear(walk, input, state);
    const bool falls = !input.dead && input.dz < 0 && now == Visit::kContinue &&
                       A::at(state.ray.z, 0) < state.ray.t_max * Real{0.999};
    PatchQuadratic<Real> before{0, -1, 0, 0, 0};
    for (int k = 0; k < kMostBorders && now == Visit::kContinue; ++k) {
      const PatchHeights heights = heights_at(pyramid_, corners_of(walk, state));
      now = visit_with(walk, state.ray, map_.shape.full_scale(), [&](Real, Real t_out) {
        const PatchQuadratic<Real> here = quadratic_over(walk, state, heights, t_out);
        if (!(here.t_in < here.end)) return false;
        if (before.end == here.t_in) {
          ++counts.borders;
          if (before.b2 != here.b0) {
            ++counts.border_differences;
            fault = "two patches disagree on their border: " + std::to_string(before.b2) + " and " +
                    std::to_string(here.b0) + " LSBs above it";
          }
        }
        before = here;
        return false;
      });
    }
    if (!falls) return fault;
    ++counts.falling;
    const HitRecord found = limited_walk<A, G>({StartRule::kLeaf, 1, UpRule::kNever}, input);
    if (found.status == HitStatus::kHit) return fault;
    ++counts.gaps;
    return "a ray that falls to the floor finds no surface: " + describe(found);
  }

  void judge(const BilinearOracle& oracle, const BilinearHit& truth, const HitRecord& found,
             Arithmetic arithmetic, BilinearCheck::Exact& exact) const {
    const bool hit = found.status == HitStatus::kHit;
    // As the machine counts time, and as the oracle does, in grid steps.
    const bool is_float = arithmetic == Arithmetic::kFloat;
    const long double t = hit ? recorded_time(found, arithmetic) : 0.0L;
    const long double scale = std::ldexp(1.0L, map_.format.fraction_bits);
    const long double exact_t = truth.hit ? static_cast<long double>(truth.t_high.num) /
                                                static_cast<long double>(truth.t_high.den) / scale
                                          : 0.0L;
    if (hit != truth.hit || (hit && (found.i != truth.i || found.j != truth.j))) {
      const bool tie = oracle.is_tie(hit, found.i, found.j);
      exact.verdicts.add(tie                        ? Verdict::kTie
                         : !hit                     ? Verdict::kMissed
                         : truth.hit && t > exact_t ? Verdict::kBehind
                                                    : Verdict::kWrongCell);
      return;
    }
    exact.verdicts.add(Verdict::kExact);
    if (!hit) return;
    const long double ulp =
        is_float ? std::nextafter(static_cast<float>(exact_t), 1e38F) - static_cast<float>(exact_t)
                 : std::nextafter(static_cast<double>(exact_t), 1e300) - static_cast<double>(exact_t);
    const auto ulps = static_cast<double>(std::abs(t - exact_t) / ulp);
    ++exact.times;
    if (ulps <= 4) ++exact.within_4;
    exact.largest_ulps = std::max(exact.largest_ulps, ulps);
    if (found.face != HitFace::kTop) return;
    const long double height = oracle.height_above(t * scale, found.i, found.j);
    exact.largest_height = std::max(exact.largest_height, static_cast<double>(std::abs(height)));
  }

  void count_ray(BilinearCheck& counts) const {
    ++counts.rays;
    ++counts.rays_by_mode[static_cast<size_t>(map_.shape.address_mode)];
  }

  void fail(BilinearCheck& counts, const TracedRay& traced, const MachineRay& ray,
            const std::string& what) const {
    if (!counts.first_failure.empty()) return;
    counts.first_failure =
        what + "\n  " + describe(map_) + "\n  " + describe(traced) + "\n  machine ray: " + describe(ray);
  }

  const RandomMap& map_;
  Pyramid pyramid_;
};

/// A fan across a corner or a border of a patch, near the surface: parallel rays, a grid step apart.
std::vector<TracedRay> fan(Random& random, const RandomMap& map, uint64_t first_id) {
  const HeightGrid& grid = map.grid;
  const auto full = static_cast<double>(grid.full_scale());
  const int i = static_cast<int>(random.below(static_cast<uint64_t>(grid.width)));
  const int j = static_cast<int>(random.below(static_cast<uint64_t>(grid.height)));
  const double step = 1.0 / static_cast<double>(int64_t{1} << map.format.fraction_bits);
  double target[3] = {static_cast<double>(i), static_cast<double>(j), static_cast<double>(grid.at(i, j))};
  if (random.chance(0.5)) target[random.below(2)] += random.chance(0.5) ? 0.5 : random.unit();
  double direction[3] = {
      static_cast<double>(random.between(-3, 3)), static_cast<double>(random.between(-3, 3)),
      -static_cast<double>(random.between(1, std::max<int64_t>(1, grid.full_scale() / 2)))};
  if (random.chance(0.2)) direction[2] = -1;
  const double back = std::min((full - target[2]) / -direction[2], static_cast<double>(random.between(0, 3)));
  const auto swept = static_cast<size_t>(random.below(3));  // x, y, or all rays through one height
  std::vector<TracedRay> rays;
  for (int k = -kFanSteps; k <= kFanSteps; ++k) {
    TracedRay ray;
    ray.id = first_id + rays.size();
    double origin[3];
    for (int a = 0; a < 3; ++a) origin[a] = target[a] - back * direction[a];
    double turned[3] = {direction[0], direction[1], direction[2]};
    if (swept < 2) {
      origin[swept] += k * step;
    } else {
      turned[0] += k * step;
    }
    const double size[3] = {static_cast<double>(grid.width), static_cast<double>(grid.height), full};
    for (int a = 0; a < 3; ++a) {
      ray.origin[a] = origin[a] / size[a];
      ray.direction[a] = turned[a] / size[a];
    }
    ray.origin[2] = std::min(ray.origin[2], 1.0);
    rays.push_back(on_patches(ray, map));
  }
  return rays;
}

/// Maps until `check` has counted `rays` rays; a ray that does not fit its format is left out.
template <class Rays, class Check>
BilinearCheck on_maps(uint64_t seed, int64_t rays, int max_side, Rays&& rays_of, Check&& check) {
  BilinearCheck counts;
  Random random(seed);
  while (counts.rays < rays) {
    const RandomMap map = bilinear_map(random, max_side);
    const Checker checker(map);
    ++counts.maps;
    for (const TracedRay& ray : rays_of(random, map)) {
      if (counts.rays == rays) break;
      try {
        check(checker, ray, checker.machine_ray(ray), counts);
      } catch (const Error&) {
        // An origin outside the tiles that this format can hold: refused, as it should be.
      }
    }
  }
  return counts;
}

std::vector<TracedRay> random_rays(Random& random, const RandomMap& map) {
  std::vector<TracedRay> rays;
  for (uint64_t k = 0; k < kRaysPerMap; ++k) rays.push_back(on_patches(random_ray(random, map, k), map));
  return rays;
}

std::vector<TracedRay> random_fans(Random& random, const RandomMap& map) {
  std::vector<TracedRay> rays;
  while (rays.size() < kRaysPerMap) {
    for (const TracedRay& ray : fan(random, map, rays.size())) rays.push_back(ray);
  }
  return rays;
}

}  // namespace

void BilinearCheck::add(const BilinearCheck& other) {
  for (const auto member :
       {&BilinearCheck::maps, &BilinearCheck::rays, &BilinearCheck::hits, &BilinearCheck::comparisons,
        &BilinearCheck::mismatches, &BilinearCheck::endless, &BilinearCheck::borders,
        &BilinearCheck::border_differences, &BilinearCheck::falling, &BilinearCheck::gaps}) {
    this->*member += other.*member;
  }
  for (size_t mode = 0; mode < rays_by_mode.size(); ++mode) rays_by_mode[mode] += other.rays_by_mode[mode];
  for (size_t a = 0; a < exact.size(); ++a) {
    Exact& to = exact[a];
    const Exact& from = other.exact[a];
    for (size_t v = 0; v < to.verdicts.of.size(); ++v) to.verdicts.of[v] += from.verdicts.of[v];
    to.times += from.times;
    to.within_4 += from.within_4;
    to.largest_ulps = std::max(to.largest_ulps, from.largest_ulps);
    to.largest_height = std::max(to.largest_height, from.largest_height);
  }
  if (first_failure.empty()) first_failure = other.first_failure;
}

BilinearCheck check_bilinear_walks(uint64_t seed, int64_t rays, int max_side) {
  const std::vector<Schedule> schedules = checked_schedules(true, 0);
  return on_maps(seed, rays, max_side, random_rays,
                 [&](const Checker& checker, const TracedRay& traced, const MachineRay& ray,
                     BilinearCheck& counts) { checker.check_schedules(traced, ray, schedules, counts); });
}

BilinearCheck check_bilinear_exactly(uint64_t seed, int64_t rays, int max_side) {
  return on_maps(
      seed, rays, max_side,
      [](Random& random, const RandomMap& map) {
        return random.chance(0.25) ? random_fans(random, map) : random_rays(random, map);
      },
      [](const Checker& checker, const TracedRay&, const MachineRay& ray, BilinearCheck& counts) {
        checker.check_exactly(ray, counts);
      });
}

BilinearCheck check_bilinear_borders(uint64_t seed, int64_t rays, int max_side) {
  return on_maps(
      seed, rays, max_side,
      [](Random& random, const RandomMap& map) {
        return map.shape.address_mode == AddressMode::kBorder ? std::vector<TracedRay>{}
                                                              : random_fans(random, map);
      },
      [](const Checker& checker, const TracedRay& traced, const MachineRay& ray, BilinearCheck& counts) {
        checker.check_borders(traced, ray, counts);
      });
}

}  // namespace cuesta
