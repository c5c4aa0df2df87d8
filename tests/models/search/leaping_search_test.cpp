#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "models/traversal/traversal.h"
#include "tests/models/search/search_cases.h"

// What cones and safety radii guarantee on constant texels, asked of the exact oracle and of the exact walk in the same
// arithmetic. CUESTA_SEARCH_RAYS=N runs N rays instead of the sample.

namespace cuesta {
namespace {

int64_t rays_wanted(int64_t few) {
  const char* wanted = std::getenv("CUESTA_SEARCH_RAYS");
  return wanted == nullptr ? few : std::max(few, static_cast<int64_t>(std::atoll(wanted)));
}

HitRecord leaf_walk(const SearchCase& c, const MachineRay& ray, Arithmetic arithmetic) {
  return with_traversal_types(arithmetic, c.shape, [&]<class A, class G>() {
    const Walk<A, G> walk(c.shape, c.format, {StartRule::kLeaf, 1, UpRule::kNever}, c.pyramid.highest());
    return traverse_ray(walk, ray, [&](int level, int64_t i, int64_t j) -> int64_t {
      return c.pyramid.at(level, static_cast<int>(i), static_cast<int>(j));
    });
  });
}

/// A ray over the map at a grazing angle, from the top.
MachineRay grazing_ray(Random& random, const SearchCase& c, uint64_t id) {
  const double turn = random.unit() * 6.283185307179586, tangent = 1 / (0.01 + 0.3 * random.unit());
  const double spread = c.shape.address_mode == AddressMode::kBorder ? 0.2 : 1;
  const auto place = [&] { return -spread + random.unit() * (1 + 2 * spread); };
  const double u = place(), v = place();
  MachineRay ray = ray_from(c, u, v, 0.3 + 0.7 * random.unit(), tangent * std::cos(turn),
                            tangent * std::sin(turn), -4 * random.unit() - 0.1);
  ray.id = id;
  return ray;
}

struct GuaranteeCounts {
  int64_t rays = 0, hits = 0, bits_differ = 0, overshot = 0, lost = 0, invented = 0, short_of = 0;
  int64_t steps = 0, walk_steps = 0;
};

void print(const char* what, const GuaranteeCounts& n) {
  std::printf(
      "%s: rays %lld, hits %lld, steps per ray %.2f (leaf walk %.2f), bits differ %lld, later than the truth "
      "%lld, lost "
      "%lld, not there %lld, short of it with few steps %lld\n",
      what, static_cast<long long>(n.rays), static_cast<long long>(n.hits),
      static_cast<double>(n.steps) / static_cast<double>(n.rays),
      static_cast<double>(n.walk_steps) / static_cast<double>(n.rays), static_cast<long long>(n.bits_differ),
      static_cast<long long>(n.overshot), static_cast<long long>(n.lost), static_cast<long long>(n.invented),
      static_cast<long long>(n.short_of));
}

template <class Real>
void check_ray(const SearchCase& c, const Search& search, const SearchMap& map, const MachineRay& ray,
               const SearchTruth& truth, GuaranteeCounts& counts, const std::string& where) {
  const HitRecord walked = leaf_walk(c, ray, sizeof(Real) == 4 ? Arithmetic::kFloat : Arithmetic::kDouble);
  const SearchAnswer whole = run_search<Real>(c, search, map, ray);
  ++counts.rays;
  counts.hits += truth.hit.hit;
  counts.steps += whole.hit.steps;
  counts.walk_steps += walked.steps;
  HitRecord same = walked;
  same.steps = whole.hit.steps;
  if (!(same == whole.hit)) {
    ++counts.bits_differ;
    EXPECT_EQ(whole.hit.status, walked.status) << where;
    EXPECT_EQ(whole.hit.i, walked.i) << where;
    EXPECT_EQ(whole.hit.j, walked.j) << where;
    EXPECT_EQ(whole.hit.t, walked.t) << where;
    EXPECT_EQ(whole.hit.face, walked.face) << where;
  }
  // Few steps: at most as late as the truth, and never without a hit that is there.
  Search few = search;
  few.steps = 1 + static_cast<int>(ray.id % 7);
  few.refinements = ray.id % 2 == 0 ? 64 : static_cast<int>(ray.id % 5);
  const SearchAnswer early = run_search<Real>(c, few, map, ray);
  const bool hit = early.hit.status == HitStatus::kHit;
  const auto time = [](int64_t bits) {
    return sizeof(Real) == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(bits)))
                             : std::bit_cast<double>(bits);
  };
  const bool walk_hits = walked.status == HitStatus::kHit;
  if (walk_hits && (!hit || time(early.hit.t) > time(walked.t))) {
    ++counts.overshot;
    ADD_FAILURE() << "later than the walk in its own arithmetic: " << where;
  }
  if (sizeof(Real) == 8 && truth.hit.hit && !hit && truth.verdict(early) != Verdict::kTie) {
    ++counts.lost;
    ADD_FAILURE() << "lost: " << where;
  }
  if (truth.hit.hit && hit) {
    // Beyond what rounding the ray's origin to `Real` makes of its times.
    const bool late = sizeof(Real) == 8 && early.t > truth.t * (1 + 1e-12L) + 1;
    if (late && truth.verdict(early) != Verdict::kTie) {
      ++counts.overshot;
      ADD_FAILURE() << "later than the truth: " << where;
    }
    counts.short_of += early.t < truth.t * (1 - 1e-4L) - 1;
  }
  const bool used_up = few.refinements < 64 || early.hit.steps >= static_cast<uint32_t>(few.steps);
  counts.invented += !walk_hits && hit && !used_up;
}

void check_guarantee(SearchKind kind) {
  const Search search{kind, 4096, 0, 64, SearchFilter::kTexel};
  GuaranteeCounts of_float, of_double;
  Random random(77 + static_cast<uint64_t>(kind));
  const int64_t wanted = rays_wanted(12000);
  while (of_float.rays < wanted && !::testing::Test::HasFailure()) {
    const RandomMap map = random_map(random.next(), random.chance(0.3) ? 5 : 40);
    const SearchCase c(map);
    const SearchMap records(search, c.pyramid, c.shape.address_mode);
    for (int r = 0; r < 60 && !::testing::Test::HasFailure(); ++r) {
      std::optional<MachineRay> ray;
      try {
        ray = r % 3 == 0 ? grazing_ray(random, c, static_cast<uint64_t>(r))
                         : random_machine_ray(random, map, static_cast<uint64_t>(r));
      } catch (const Error&) {  // beyond this format's tiles
      }
      if (!ray) continue;
      const SearchTruth truth(c, *ray);
      if (truth.hit.visits > 4000) continue;  // more cells than the search has steps
      const std::string where = describe(map) + "; " + describe(*ray);
      check_ray<float>(c, search, records, *ray, truth, of_float, where);
      check_ray<double>(c, search, records, *ray, truth, of_double, where);
    }
  }
  for (const GuaranteeCounts& n : {of_float, of_double}) {
    EXPECT_EQ(n.bits_differ, 0);
    EXPECT_EQ(n.overshot, 0);
    EXPECT_EQ(n.lost, 0);
    EXPECT_EQ(n.invented, 0);
    EXPECT_GT(n.short_of, 0);
    EXPECT_LT(n.steps, n.walk_steps);
  }
  print("float", of_float);
  print("double", of_double);
}

TEST(ConeSearch, WithStepsEnoughIsTheLeafWalkBitForBitAndWithFewNeverLaterThanTheTruth) {
  check_guarantee(SearchKind::kCone);
}

TEST(SafetyRadiusSearch, WithStepsEnoughIsTheLeafWalkBitForBitAndWithFewNeverLaterThanTheTruth) {
  check_guarantee(SearchKind::kSafetyRadius);
}

TEST(SafetyRadiusSearch, OutsideAClampedMapEveryTexelIsAsked) {
  // A groove along x, closed at its right end by one texel, which clamping repeats for ever. From far right a ray comes
  // down on these repetitions and would come out of them again into the groove.
  HeightGrid grid = flat_grid(12, 3, 8, 200);
  for (int i = 0; i < 11; ++i) grid.at(i, 1) = 0;
  const SearchCase c(grid, AddressMode::kClamp, {});
  const Search search{SearchKind::kSafetyRadius, 64, 0, 64, SearchFilter::kTexel};
  const SearchMap map(search, c.pyramid, AddressMode::kClamp);
  ASSERT_EQ(map.added_at(11, 1), 255);  // the groove's end sees no edge but its own
  const MachineRay ray = ray_from(c, 20.0 / 12, 0.5, 204.0 / 255, -1, 0, -8.0 / 255);
  const SearchAnswer answer = run_search<double>(c, search, map, ray);
  EXPECT_EQ(answer.hit.status, HitStatus::kHit);
  EXPECT_EQ(answer.hit.i, 13);  // 4 LSB down, 6 texels on, at x = 14, from the right
  EXPECT_EQ(SearchTruth(c, ray).verdict(answer), Verdict::kExact);
}

}  // namespace
}  // namespace cuesta
