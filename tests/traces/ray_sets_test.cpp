#include "traces/ray_sets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/traces/support.h"

namespace cuesta {
namespace {

constexpr AddressMode kModes[] = {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kMirror,
                                  AddressMode::kClamp};

RaySet set_of(std::string_view kind, uint64_t seed, uint64_t count, int tile_bits = 4) {
  return {std::string(kind), count, seed, tile_bits};
}

/// 100 x 48 texels of 8 bits.
MapShape shape(AddressMode mode) { return shape_of(100, 48, mode); }

double across(const TracedRay& ray) {
  return std::max(std::fabs(ray.direction[0]), std::fabs(ray.direction[1]));
}

TEST(RaySets, SameSeedSameRaysOtherSeedOtherRays) {
  const MapShape map = shape(AddressMode::kWrap);
  for (const RaySetKind& kind : ray_set_kinds()) {
    const RayTrace trace = make_ray_set(set_of(kind.name, 1, 5000), map);
    EXPECT_TRUE(identical(trace, make_ray_set(set_of(kind.name, 1, 5000), map))) << kind.name;
    EXPECT_FALSE(identical(trace, make_ray_set(set_of(kind.name, 2, 5000), map))) << kind.name;
  }
}

TEST(RaySets, WhatIsNoSetIsAUsageError) {
  const MapShape map = shape(AddressMode::kWrap);
  const auto refused = [&](const RaySet& set) {
    return sentence_of(ExitCode::kUsage, [&] { make_ray_set(set, map); });
  };
  EXPECT_NE(refused(set_of("adversary", 1, 10)).find("did you mean `adversarial`"), std::string::npos);
  refused(set_of("random", 1, 0));
  refused(set_of("random", 1, uint64_t{1} << 40));
  refused(set_of("random", 1, 10, 21));
  refused(set_of("random", 1, 10, -1));
}

TEST(RaySets, StopWhenTheWatchSaysSo) {
  uint64_t seen = 0;
  const RayWatch watch = [&](uint64_t finished) {
    seen = finished;
    return finished < 10000;
  };
  sentence_of(ExitCode::kIncomplete,
              [&] { make_ray_set(set_of("random", 1, 100000), shape(AddressMode::kWrap), watch); });
  EXPECT_GE(seen, 10000u);
  EXPECT_LT(seen, 20000u);
}

TEST(RaySets, EveryRayIsInOrderNumberedAndTakenByAMachineOfItsTileBits) {
  for (const RaySetKind& kind : ray_set_kinds()) {
    for (AddressMode mode : kModes) {
      for (int tile_bits : {0, 1, 4, 9}) {
        const MapShape map = tile_bits == 1 ? shape_of(64, 64, mode) : shape(mode);
        const RayTrace trace = make_ray_set(set_of(kind.name, 3, 6000, tile_bits), map);
        NumberFormat format;
        format.tile_bits = tile_bits;
        ASSERT_EQ(trace.rays.size(), 6000u);
        for (size_t k = 0; k < trace.rays.size(); ++k) {
          const TracedRay& ray = trace.rays[k];
          ASSERT_EQ(ray.id, k);
          ASSERT_EQ(ray.pixel_y * 1024 + ray.pixel_x, k);
          ASSERT_EQ(fault_of(ray, trace.width, trace.height), "") << kind.name;
          ASSERT_GE(ray.origin[2], 0);
          ASSERT_LE(ray.origin[2], 1);
          ASSERT_NO_THROW(quantise(ray, map, format)) << kind.name << " " << tile_bits << " ray " << k;
        }
      }
    }
  }
}

TEST(RaySets, StratifiedRaysFallAsTheirAngleClassSays) {
  const RayTrace trace = make_ray_set(set_of("stratified", 3, 10000), shape(AddressMode::kBorder));
  const double low[] = {0, 30, 60, 80, 89}, high[] = {30, 60, 80, 89, 89.99};
  for (const TracedRay& ray : trace.rays) {
    const uint64_t angle_class = ray.id % 10;
    const int sign = (ray.direction[2] > 0) - (ray.direction[2] < 0);
    EXPECT_EQ(sign, angle_class < 5 ? -1 : angle_class > 5 ? 1 : 0) << ray.id;
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_GE(ray.origin[axis], 0);
      EXPECT_LE(ray.origin[axis], 1);
    }
    if (angle_class == 5) continue;
    bool in_class = false;  // over one of the three depths
    for (double depth : {0.05, 0.35, 1.0}) {
      const double angle =
          std::atan2(std::hypot(ray.direction[0], ray.direction[1]), std::fabs(ray.direction[2]) * depth) *
          180 / 3.14159265358979;
      const size_t range = angle_class < 5 ? angle_class : angle_class - 6;
      in_class = in_class || (angle >= low[range] - 1e-6 && angle <= high[range] + 1e-6);
    }
    EXPECT_TRUE(in_class) << ray.id;
  }
}

TEST(RaySets, RandomRaysLookIntoEveryOctant) {
  const RayTrace trace = make_ray_set(set_of("random", 3, 8000), shape(AddressMode::kWrap));
  int of_octant[8] = {};
  for (const TracedRay& ray : trace.rays) {
    ++of_octant[(ray.direction[0] > 0) + 2 * (ray.direction[1] > 0) + 4 * (ray.direction[2] > 0)];
  }
  for (int count : of_octant) EXPECT_NEAR(count, 1000, 200);
}

TEST(RaySets, LatticeRaysLieOnTheLatticeAndHoldTheHardCases) {
  const RayTrace trace = make_ray_set(set_of("lattice", 3, 20000), shape(AddressMode::kBorder));
  int along_axis = 0, diagonal = 0, vertical = 0, horizontal = 0, rising = 0, corner = 0, outside = 0,
      on_top = 0;
  for (const TracedRay& ray : trace.rays) {
    const double x = ray.origin[0] * 100, y = ray.origin[1] * 48, z = ray.origin[2] * 255;
    EXPECT_NEAR(2 * x, std::round(2 * x), 1e-9);
    EXPECT_NEAR(2 * y, std::round(2 * y), 1e-9);
    EXPECT_NEAR(z, std::round(z), 1e-9);
    const double dx = std::round(ray.direction[0] * 100), dy = std::round(ray.direction[1] * 48);
    EXPECT_NEAR(ray.direction[0] * 100, dx, 1e-9);
    EXPECT_NEAR(ray.direction[1] * 48, dy, 1e-9);
    along_axis += (dx == 0) != (dy == 0);
    diagonal += dx != 0 && std::fabs(dx) == std::fabs(dy);
    vertical += dx == 0 && dy == 0;
    horizontal += ray.direction[2] == 0;
    rising += ray.direction[2] > 0;
    corner += x == std::round(x) && y == std::round(y);
    outside += x < 0 || x > 100 || y < 0 || y > 48;
    on_top += z == 255;
  }
  for (int count : {along_axis, diagonal, vertical, horizontal, rising, corner, outside, on_top})
    EXPECT_GT(count, 400);
}

// Claims by hand, one for each hard case, in the order of its classes.
TEST(RaySets, AdversarialRaysAreWhatTheirClassSays) {
  for (AddressMode mode : kModes) {
    const RayTrace trace = make_ray_set(set_of("adversarial", 3, 10000), shape(mode));
    double flattest = 1, farthest = 0;
    for (const TracedRay& ray : trace.rays) {
      const double u = ray.direction[0], v = ray.direction[1], z = ray.direction[2];
      const double x = ray.origin[0] * 100, y = ray.origin[1] * 48;
      const bool x_whole = std::fabs(x - std::round(x)) < 1e-9, y_whole = std::fabs(y - std::round(y)) < 1e-9;
      switch (ray.id % 10) {
        case 0:
          EXPECT_TRUE((u == 0) != (v == 0));
          break;
        case 1:
          EXPECT_TRUE(x_whole && y_whole);
          EXPECT_NEAR(u * 100, std::round(u * 100), 1e-9);
          EXPECT_NEAR(v * 48, std::round(v * 48), 1e-9);
          EXPECT_TRUE(u != 0 && v != 0);
          break;
        case 2:
          EXPECT_TRUE(u == 0 ? x_whole : y_whole);
          EXPECT_TRUE((u == 0) != (v == 0));
          break;
        case 3:
          EXPECT_LT(z, 0);
          EXPECT_GE(-z / across(ray), 1e-6);
          EXPECT_LE(-z / across(ray), 1e-2);
          flattest = std::min(flattest, -z / across(ray));
          break;
        case 4:
          EXPECT_EQ(z, 0);
          break;
        case 5:
          EXPECT_GT(z, 0);
          break;
        case 6:
          EXPECT_TRUE(u == 0 && v == 0 && z < 0);
          break;
        case 7:  // one coordinate on the edge of the tile or outside, the ray looking in
          EXPECT_TRUE((ray.origin[0] <= 0 && u > 0) || (ray.origin[0] >= 1 && u < 0) ||
                      (ray.origin[1] <= 0 && v > 0) || (ray.origin[1] >= 1 && v < 0));
          break;
        case 8:
          EXPECT_TRUE(z <= 0 && ray.origin[2] < 1 && ray.origin[0] < 1 && ray.origin[1] < 1);
          break;
        default:
          farthest = std::max({farthest, std::fabs(ray.origin[0]), std::fabs(ray.origin[1])});
          EXPECT_LE(-z / across(ray), 1.0 / 16);
      }
    }
    EXPECT_LT(flattest, 2e-6);
    EXPECT_GE(farthest, 15);
    EXPECT_LT(farthest, 16);
  }
}

}  // namespace
}  // namespace cuesta
