#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "models/common/error.h"
#include "models/oracle/traversal_check.h"

// Every schedule returns the leaf walk's hit bit for bit, and the leaf walk in fixed point is exact. The suite is
// a sample; `cuesta verify oracle --rays N`, or CUESTA_ORACLE_RAYS=N here, runs as many as wanted.

namespace cuesta {
namespace {

int64_t rays_per_suite(int64_t few) {
  const char* wanted = std::getenv("CUESTA_ORACLE_RAYS");
  return wanted == nullptr ? few : std::max(few, static_cast<int64_t>(std::atoll(wanted)));
}

void expect_passed(const TraversalCheck& c) {
  EXPECT_EQ(c.mismatches, 0) << c.first_failure;
  EXPECT_EQ(c.endless, 0) << c.first_failure;
  EXPECT_EQ(c.oracle_errors, 0) << c.first_failure;
  EXPECT_EQ(c.step_errors, 0) << c.first_failure;
  EXPECT_EQ(c.lane_errors, 0) << c.first_failure;
  const auto print = [](const char* what, int64_t count) {
    std::printf("%s %lld; ", what, static_cast<long long>(count));
  };
  print("rays", c.rays);
  print("hits", c.hits);
  print("comparisons", c.comparisons);
  print("exact walks", c.oracle_walks);
  print("by brute force", c.oracle_brute);
  print("steps", c.step_comparisons);
  print("many at a time", c.lane_comparisons);
  std::printf("\n");
}

TEST(Traversal, AllSchedulesReturnTheSameExactHitOnTinyMaps) {
  expect_passed(check_random_traversals(101, rays_per_suite(4000), 5, 40, {}));
}

TEST(Traversal, AllSchedulesReturnTheSameExactHitOnSmallMaps) {
  expect_passed(check_random_traversals(102, rays_per_suite(4000), 33, 40, {}));
}

TEST(Traversal, AllSchedulesReturnTheSameExactHitOnLargerMaps) {
  expect_passed(check_random_traversals(103, rays_per_suite(1500), 160, 40, {.step_check_every = 40}));
}

/// A map of any size: random_map's own are small.
RandomMap tall_and_rare(int width, int height, int bits, AddressMode mode) {
  RandomMap map;
  map.kind = "hashed";
  map.grid = {width, height, bits, {}};
  map.grid.texels.resize(static_cast<size_t>(width) * static_cast<size_t>(height));
  Random random(17);
  for (size_t k = 0; k < map.grid.texels.size(); ++k) {
    // Mostly low, with rarer and rarer heights: walks are long.
    const uint64_t height_bits = random.below(static_cast<uint64_t>(bits) * 4);
    map.grid.texels[k] = static_cast<uint16_t>(random.below(map.grid.full_scale() + 1) >> height_bits / 2);
  }
  map.shape = {width, height, 0, bits, mode};
  while ((1 << map.shape.root_level) < std::max(width, height)) ++map.shape.root_level;
  map.format.mantissa_bits = bits + 4;
  return map;
}

void check_on(const RandomMap& map, int rays) {
  TraversalChecker checker(map, {.step_check_every = 0});
  TraversalCheck counts;
  Random random(23);
  while (counts.rays < rays) {
    try {
      checker.check(random_ray(random, map, static_cast<uint64_t>(counts.rays)), counts);
    } catch (const Error&) {  // moved to the top, it started beyond the format's tiles
    }
  }
  checker.check_lanes(counts);
  expect_passed(counts);
}

TEST(Traversal, AllSchedulesReturnTheSameExactHitAtTheLongestSide) {
  check_on(tall_and_rare(16384, 1, 16, AddressMode::kWrap), 40);
  check_on(tall_and_rare(3, 16383, 16, AddressMode::kBorder), 40);
  check_on(tall_and_rare(16383, 2, 16, AddressMode::kMirror), 40);
  check_on(tall_and_rare(5, 16384, 16, AddressMode::kClamp), 40);
}

TEST(Traversal, AllSchedulesReturnTheSameExactHitOnASquarePowerOfTwo) {
  check_on(tall_and_rare(256, 256, 8, AddressMode::kWrap), 400);
  check_on(tall_and_rare(256, 256, 16, AddressMode::kBorder), 400);
  check_on(tall_and_rare(256, 256, 8, AddressMode::kMirror), 100);
  check_on(tall_and_rare(256, 256, 16, AddressMode::kClamp), 100);
}

TEST(Traversal, StoppedAboveTheTexelsTheMeanPyramidIsTheSurface) {
  TraversalCheck all;
  Random random(31);
  for (int m = 0; m < 60; ++m) {
    const RandomMap map = random_map(random.next(), 40);
    for (int level = 1; level <= map.shape.root_level; ++level) {
      TraversalChecker checker(map, {.all_combinations = m % 4 == 0, .stop_level = level});
      for (int r = 0; r < 10; ++r) {
        try {
          checker.check(random_ray(random, map, static_cast<uint64_t>(r)), all);
        } catch (const Error&) {  // beyond this format's tiles
        }
      }
    }
  }
  EXPECT_GT(all.rays, 1000);
  expect_passed(all);
}

TEST(Traversal, PrecisionIsThatOfTheDefaultNumberFormat) {
  const TraversalCheck c = check_random_traversals(104, rays_per_suite(12000), 64, 40,
                                                   {.all_combinations = false, .step_check_every = 0});
  const int64_t judged = c.verdicts[0].total();
  ASSERT_GT(judged, 3000);
  constexpr int64_t kLeastExact[3] = {9900, 9990, 9999};  // of 10000: fixed, float, double
  for (size_t a = 0; a < 3; ++a) {
    const VerdictCounts& v = c.verdicts[a];
    std::printf("%s:", a == 0 ? "fixed" : a == 1 ? "float" : "double");
    for (size_t k = 0; k < kVerdicts; ++k) {
      std::printf(" %s %lld", std::string(name_of(static_cast<Verdict>(k))).c_str(),
                  static_cast<long long>(v.of[k]));
    }
    std::printf(", other face %lld\n", static_cast<long long>(c.other_face[a]));
    const int64_t right = v.count(Verdict::kExact) + v.count(Verdict::kTie);
    EXPECT_GE(right * 10000, judged * kLeastExact[a]) << c.first_other[a];
  }
}

}  // namespace
}  // namespace cuesta
