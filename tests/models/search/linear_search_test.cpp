#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/models/search/search_cases.h"

// Searches in equal steps, and those that take one sample or none. Expected values are worked by hand on flat maps, or
// come from the exact leaf walk.

namespace cuesta {
namespace {

Search with_steps(SearchKind kind, int steps, int least = 0, int refinements = 0) {
  return {kind, steps, least, refinements, SearchFilter::kTexel};
}

/// t of a hit as a share of the time from z = 1 to z = 0.
double share_of(const SearchAnswer& answer, const SearchCase& c, const MachineRay& ray) {
  const double units_per_depth =
      static_cast<double>(c.shape.full_scale()) / static_cast<double>(-ray.dz) *
      std::exp2(c.format.fraction_bits + c.format.direction_bits - 1 + c.format.mantissa_bits) * 1.0 /
      std::exp2(0);
  return static_cast<double>(answer.t) / units_per_depth;
}

class OnFlat64 : public ::testing::Test {
 protected:
  SearchCase c{flat_grid(16, 16, 8, 64), AddressMode::kWrap, {}};
  MachineRay ray = ray_from(c, 0.5, 0.5, 1, 1, 0.25, -4);
  const double truth = 1 - 64.0 / 255;

  double share(const Search& search, double depth = 0.1) {
    const SearchMap map(search, c.pyramid, c.shape.address_mode);
    const SearchAnswer answer = run_search<double>(c, search, map, ray, depth);
    EXPECT_EQ(answer.hit.status, HitStatus::kHit);
    return share_of(answer, c, ray);
  }
};

TEST_F(OnFlat64, NormalStaysAtTheEntryWithoutAStep) {
  const Search search = with_steps(SearchKind::kNormal, 0);
  const SearchMap map(search, c.pyramid, c.shape.address_mode);
  const SearchAnswer answer = run_search<float>(c, search, map, ray);
  EXPECT_EQ(answer.hit.steps, 0u);
  EXPECT_EQ(answer.hit.i, 8);
  EXPECT_EQ(answer.hit.j, 8);
  EXPECT_EQ(answer.hit.t, 0);
  EXPECT_EQ(map.record_bytes(), 4);
  EXPECT_EQ(int{map.normal_at(3, 3)[0]}, 128);  // straight up
  EXPECT_EQ(int{map.normal_at(3, 3)[2]}, 255);
}

TEST_F(OnFlat64, ParallaxIsExactAndItsLimitedFormShorterByTheCosine) {
  EXPECT_NEAR(share(with_steps(SearchKind::kParallax, 0)), truth, 1e-12);
  const double depth = 0.5, w = 4 * depth;
  const double cosine = w / std::sqrt(1 + 0.25 * 0.25 + w * w);
  EXPECT_NEAR(share(with_steps(SearchKind::kParallaxLimited, 0), depth), truth * cosine, 1e-9);
}

TEST_F(OnFlat64, SteepStopsAtTheFirstSampleUnderAndSecantsAreExact) {
  // Samples at heights 1, .8, .6, .4, .2: the fifth is the first under .251.
  EXPECT_NEAR(share(with_steps(SearchKind::kSteep, 5)), 0.8, 1e-12);
  EXPECT_NEAR(share(with_steps(SearchKind::kPom, 5, 5)), truth, 1e-12);
  EXPECT_NEAR(share(with_steps(SearchKind::kPomTatarchuk, 5, 5)), truth, 1e-12);
  EXPECT_NEAR(share(with_steps(SearchKind::kInterval, 5, 0, 1)), truth, 1e-12);
  // [.6, .8] halved: .7 above, .75 under, .725 above; the last one under is .75.
  EXPECT_NEAR(share(with_steps(SearchKind::kRelief, 5, 0, 3)), 0.75, 1e-12);
}

TEST_F(OnFlat64, AsPrintedPomComparesOneStepLateSoThatAFlatMapIsFoundAStepTooEarly) {
  EXPECT_NEAR(share(with_steps(SearchKind::kPomPrinted, 5, 5)), truth - 0.2, 1e-12);
  EXPECT_NEAR(share(with_steps(SearchKind::kPomPrinted, 50, 50)), truth - 0.02, 1e-12);
}

TEST_F(OnFlat64, ConesUnderTheRayNearTheSurfaceByTheSameShareEachStep) {
  // Nothing is higher: the cone reaches a tile's side per full scale. What is left of the way to the surface shrinks by
  // v / (v + 4), v = hypot(1, 1/4) tiles of ground per unit of t, in which the ray falls by 4.
  const double v = std::sqrt(1 + 0.0625), left = v / (v + 4);
  Search cone = with_steps(SearchKind::kCone, 3);
  cone.filter = SearchFilter::kBilinear;
  EXPECT_NEAR(share(cone), truth * (1 - left * left * left), 1e-12);
  EXPECT_NEAR(share(with_steps(SearchKind::kRelaxedCone, 2)), truth * (1 - left * left), 1e-12);
  // Over constant texels the texel itself is asked, and the ray meets it.
  EXPECT_NEAR(share(with_steps(SearchKind::kCone, 100)), truth, 1e-12);
}

TEST_F(OnFlat64, PomTakesItsLeastStepsAlongTheNormalAndItsMostAtGrazing) {
  const auto samples = [&](const MachineRay& input, double depth) {
    const Search search = with_steps(SearchKind::kPom, 40, 8);
    const SearchMap map(search, c.pyramid, c.shape.address_mode);
    return run_search<float>(c, search, map, input, depth).hit.steps;
  };
  // Ends at the first sample under .251: ceil(.749 n) + 1 samples, and one division.
  EXPECT_EQ(samples(ray_from(c, 0.5, 0.5, 1, 0, 0, -1), 0.1), 6u + 1 + 1);
  EXPECT_EQ(samples(ray_from(c, 0.5, 0.5, 1, 1, 0, -0.1), 0.1), 30u + 1 + 1);  // n = 39: cut, not rounded
  // N.V = cos 60 degrees = 1/2: n = 24.
  EXPECT_EQ(samples(ray_from(c, 0.5, 0.5, 1, std::sqrt(3.0), 0, -1), 1), 18u + 1 + 1);
}

TEST(LinearSearch, AsPrintedPomTurnsAMissIntoAHitWithoutOffset) {
  const SearchCase c(flat_grid(8, 8, 8, 0), AddressMode::kBorder, {});
  const MachineRay ray = ray_from(c, 0.3, 0.5, 1, 1, 0, -0.5);  // leaves the map at z = .65
  const auto answer = [&](SearchKind kind) {
    const Search search = with_steps(kind, 16, 8);
    const SearchMap map(search, c.pyramid, c.shape.address_mode);
    return run_search<double>(c, search, map, ray).hit;
  };
  const HitRecord printed = answer(SearchKind::kPomPrinted);
  EXPECT_EQ(printed.status, HitStatus::kHit);
  EXPECT_EQ(printed.i, 2);
  EXPECT_EQ(std::bit_cast<double>(printed.t), 0);
  for (const SearchKind kind : {SearchKind::kPom, SearchKind::kPomTatarchuk, SearchKind::kSteep,
                                SearchKind::kParallax, SearchKind::kRelief, SearchKind::kInterval}) {
    EXPECT_EQ(answer(kind).status, HitStatus::kMiss) << static_cast<int>(kind);
  }
}

TEST(LinearSearch, TheBottomAndTheTopOfTheSlabAreFoundExactly) {
  for (const int height : {0, 255}) {
    const SearchCase c(flat_grid(7, 5, 8, static_cast<uint16_t>(height)), AddressMode::kWrap, {});
    const MachineRay ray = ray_from(c, 0.3, 0.4, 1, 2, -3, -0.7);
    for (const SearchKind kind : {SearchKind::kSteep, SearchKind::kPom, SearchKind::kPomTatarchuk,
                                  SearchKind::kInterval, SearchKind::kParallax}) {
      const Search search = with_steps(kind, 16, 8, 2);
      const SearchMap map(search, c.pyramid, c.shape.address_mode);
      const SearchTruth truth(c, ray);
      const SearchAnswer answer = run_search<double>(c, search, map, ray);
      ASSERT_EQ(answer.hit.status, HitStatus::kHit) << static_cast<int>(kind);
      EXPECT_NEAR(static_cast<double>(answer.t), static_cast<double>(truth.t),
                  1e-9 * static_cast<double>(truth.t));
    }
  }
}

TEST(LinearSearch, SteepNeverFindsTheSurfaceBeforeItIsThereNorMissesACellLongerThanAStep) {
  Random random(71);
  int64_t hits = 0, thick = 0, same_cell = 0, ties = 0;
  for (int m = 0; m < 300; ++m) {
    const RandomMap map = random_map(random.next(), 12);
    const SearchCase c(map);
    const Search search = with_steps(SearchKind::kSteep, static_cast<int>(random.between(1, 4096)));
    const SearchMap records(search, c.pyramid, c.shape.address_mode);
    for (int r = 0; r < 30; ++r) {
      const auto ray = random_machine_ray(random, map, static_cast<uint64_t>(r));
      if (!ray) continue;
      const SearchTruth truth(c, *ray);
      const SearchAnswer answer = run_search<double>(c, search, records, *ray);
      const bool hit = answer.hit.status == HitStatus::kHit;
      if (hit && truth.hit.hit) {
        EXPECT_GE(answer.t, truth.t * (1 - 1e-9L) - 1e-3L) << describe(map) << describe(*ray);
      }
      if (hit && !truth.hit.hit) {
        EXPECT_EQ(truth.verdict(answer), Verdict::kTie) << describe(map) << describe(*ray);
      }
      if (!truth.hit.hit) continue;
      ++hits;
      // How long the ray stays in the cell that it hits, beside a step.
      const OracleSpan u =
          oracle_span_of_node(truth.hit.i, ray->dx < 0, c.shape.width, 0, c.shape.address_mode);
      const OracleSpan v =
          oracle_span_of_node(truth.hit.j, ray->dy < 0, c.shape.height, 0, c.shape.address_mode);
      auto t_out = earlier(earlier(truth.ray.x.plane(u.upper), truth.ray.y.plane(v.upper)), truth.ray.t_max);
      if (ray->dz < 0) t_out = earlier(t_out, truth.ray.z.reaches(0));
      if (ray->dz > 0) continue;
      const auto format = RealArithmetic<double>::format(c.shape, c.format);
      const auto segment = make_search_ray<double>(*ray, c.shape, format);
      const long double step = static_cast<long double>((segment.t_end - segment.t_start) / search.steps) /
                               static_cast<long double>(format.unit_of_time);
      if (!(truth.ray.in_machine_units(t_out) - truth.t > step * 1.001L)) continue;
      ++thick;
      EXPECT_TRUE(hit) << describe(map) << describe(*ray);
      if (answer.hit.i == truth.hit.i && answer.hit.j == truth.hit.j) {
        ++same_cell;
        EXPECT_LE(answer.t, truth.t + step * 1.001L);
      } else {
        ++ties;
        EXPECT_EQ(truth.verdict(answer), Verdict::kTie) << describe(map) << describe(*ray);
      }
    }
  }
  EXPECT_GT(thick, 1000);
  std::printf("hits %lld; longer than a step %lld, the same cell %lld, ties %lld\n",
              static_cast<long long>(hits), static_cast<long long>(thick), static_cast<long long>(same_cell),
              static_cast<long long>(ties));
}

/// A round hill, smooth to a 16-bit height.
HeightGrid hill(int side) {
  HeightGrid grid{side, side, 16, {}};
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i) {
      const double x = (2.0 * i + 1) / side - 1, y = (2.0 * j + 1) / side - 1;
      const double a = (1 - x * x) * (1 - y * y);
      grid.texels.push_back(static_cast<uint16_t>(60000 * a * a));
    }
  }
  return grid;
}

TEST(LinearSearch, ManyStepsAndHalvingsOfReliefConvergeToTheExactHitOnASmoothMap) {
  const SearchCase c(hill(64), AddressMode::kWrap, {.mantissa_bits = 20});
  double worst[3] = {0, 0, 0};
  const int steps[3] = {4, 64, 4096};
  Random random(9);
  for (int r = 0; r < 500; ++r) {
    const double turn = random.unit() * 6.28;
    const MachineRay ray =
        ray_from(c, random.unit(), random.unit(), 1, std::cos(turn), std::sin(turn), -1 - 3 * random.unit());
    const SearchTruth truth(c, ray);
    ASSERT_TRUE(truth.hit.hit);
    for (int k = 0; k < 3; ++k) {
      const Search search = with_steps(SearchKind::kRelief, steps[k], 0, 40);
      const SearchMap map(search, c.pyramid, c.shape.address_mode);
      const SearchAnswer answer = run_search<double>(c, search, map, ray);
      ASSERT_EQ(answer.hit.status, HitStatus::kHit);
      const SearchRay<double> segment =
          make_search_ray<double>(ray, c.shape, RealArithmetic<double>::format(c.shape, c.format));
      const double unit = RealArithmetic<double>::format(c.shape, c.format).unit_of_time;
      const double error = std::abs(static_cast<double>(answer.t - truth.t)) * unit / segment.t_end;
      worst[k] = std::max(worst[k], error);
    }
  }
  EXPECT_LT(worst[2], 1e-9);
  EXPECT_GT(worst[0], worst[2]);
  std::printf("worst error, share of the segment: 4 steps %.3g, 64 steps %.3g, 4096 steps %.3g\n", worst[0],
              worst[1], worst[2]);
}

}  // namespace
}  // namespace cuesta
