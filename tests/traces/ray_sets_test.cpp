#include "traces/ray_sets.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/traces/support.h"

namespace cuesta {
namespace {

MapShape shape(AddressMode mode) {
  MapShape map;
  map.width = 100;
  map.height = 48;
  map.root_level = 7;
  map.bits = 8;
  map.address_mode = mode;
  return map;
}

TEST(RaySets, SameSeedSameRaysOtherSeedOtherRays) {
  for (auto make : {random_rays, lattice_rays}) {
    const MapShape map = shape(AddressMode::kWrap);
    EXPECT_TRUE(identical(make(map, 1, 5000), make(map, 1, 5000)));
    EXPECT_FALSE(identical(make(map, 1, 5000), make(map, 2, 5000)));
    EXPECT_EQ(make(map, 1, 0).rays.size(), 0u);
    sentence_of(ExitCode::kUsage, [&] { make(map, 1, uint64_t{1} << 40); });
  }
}

TEST(RaySets, EveryRayIsInOrderAndNumbered) {
  for (auto make : {random_rays, lattice_rays}) {
    for (AddressMode mode : {AddressMode::kBorder, AddressMode::kWrap}) {
      const RayTrace trace = make(shape(mode), 3, 20000);
      ASSERT_EQ(trace.rays.size(), 20000u);
      for (size_t k = 0; k < trace.rays.size(); ++k) {
        EXPECT_EQ(trace.rays[k].id, k);
        EXPECT_EQ(fault_of(trace.rays[k], trace.width, trace.height), "");
        EXPECT_GE(trace.rays[k].origin[2], 0);
        EXPECT_LE(trace.rays[k].origin[2], 1);
      }
    }
  }
}

TEST(RaySets, RandomRaysFallAsTheirAngleClassSays) {
  const RayTrace trace = random_rays(shape(AddressMode::kBorder), 3, 10000);
  for (const TracedRay& ray : trace.rays) {
    const uint64_t angle_class = ray.id % 10;
    const int sign = (ray.direction[2] > 0) - (ray.direction[2] < 0);
    EXPECT_EQ(sign, angle_class < 5 ? -1 : angle_class > 5 ? 1 : 0) << ray.id;
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_GE(ray.origin[axis], 0);
      EXPECT_LE(ray.origin[axis], 1);
    }
  }
}

TEST(RaySets, LatticeRaysLieOnTheLatticeAndHoldTheHardCases) {
  const RayTrace trace = lattice_rays(shape(AddressMode::kBorder), 3, 20000);
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

}  // namespace
}  // namespace cuesta
