#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "models/common/error.h"
#include "models/oracle/precision_check.h"
#include "models/oracle/traversal_check.h"
#include "models/rays/map_shape.h"

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
  EXPECT_EQ(c.quad_errors, 0) << c.first_failure;
  const auto print = [](const char* what, int64_t count) {
    std::printf("%s %lld; ", what, static_cast<long long>(count));
  };
  print("rays", c.rays);
  print("hits", c.hits);
  print("comparisons", c.comparisons);
  print("exact walks", c.oracle_walks);
  print("by brute force", c.oracle_brute);
  print("steps", c.step_comparisons);
  print("through kept siblings", c.quad_comparisons);
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
  map.shape = map_shape(width, height, bits, mode);
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

TEST(Traversal, FixedPointIsExactForTheRayAsSetUpAtEveryWidthAndInEveryMode) {
  for (const PrecisionRays kind : {PrecisionRays::kFree, PrecisionRays::kLattice}) {
    const PrecisionCheck c = check_precision(105, rays_per_suite(1500), 48, kind);
    EXPECT_EQ(c.errors(), 0) << c.first_failure;
    for (size_t k = 0; k < kPrecisionFormats.size(); ++k) {
      const bool fixed = kPrecisionFormats[k].arithmetic == Arithmetic::kFixed;
      EXPECT_EQ(c.rows[k].set_up.total(), fixed ? c.rays : 0);
    }
  }
}

TEST(Traversal, PrecisionOfEachNumberFormatIsNearTheExactAnswer) {
  const PrecisionCheck c = check_precision(104, rays_per_suite(4000), 64, PrecisionRays::kFree);
  const auto right = [&](const VerdictCounts& counts) {
    return counts.count(Verdict::kExact) + counts.count(Verdict::kTie);
  };
  const auto of = [&](std::string_view name) -> const PrecisionRow& {
    for (size_t k = 0; k < c.rows.size(); ++k) {
      if (kPrecisionFormats[k].name == name) return c.rows[k];
    }
    throw std::runtime_error("no such format");
  };
  // Of 10000; the default format's own figures are above 9980.
  EXPECT_GE(right(of("fixed, M = B + 4 (default)").quantised) * 10000, c.rays * 9900);
  EXPECT_GE(right(of("fixed, M = B + 4 (default)").traced) * 10000, c.rays * 9900);
  EXPECT_GE(right(of("float").quantised) * 10000, c.rays * 9990);
  EXPECT_GE(right(of("double").quantised) * 10000, c.rays * 9999);
  // More bits, no more faults, end to end.
  EXPECT_LE(right(of("fixed, M = B").traced), right(of("fixed, M = B + 2").traced));
  EXPECT_LE(right(of("fixed, M = B + 2").traced), right(of("fixed, M = B + 4 (default)").traced));
  EXPECT_LT(right(of("fixed, f = 4").traced), right(of("fixed, M = B + 4 (default)").traced));
}

}  // namespace
}  // namespace cuesta
