#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "models/common/error.h"
#include "models/oracle/random_cases.h"
#include "models/rays/machine_ray.h"
#include "models/rays/map_shape.h"

namespace cuesta {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
// 4 x 8 texels, 8 bits, n = 3; T = max(3 + 4, 8) + 8 + 12 = 28.
constexpr MapShape kMap{4, 8, 3, 8, AddressMode::kWrap};
constexpr NumberFormat kFormat{.fraction_bits = 8, .direction_bits = 32, .mantissa_bits = 12, .tile_bits = 4};
constexpr int64_t kTop = 255 << 8;

TracedRay ray_of(double u, double v, double z, double du, double dv, double dz) {
  TracedRay ray;
  ray.id = 7;
  ray.origin[0] = u;
  ray.origin[1] = v;
  ray.origin[2] = z;
  ray.direction[0] = du;
  ray.direction[1] = dv;
  ray.direction[2] = dz;
  return ray;
}

TEST(MapShape, TheRootIsTheLeastLevelWhoseOneNodeHoldsTheMap) {
  const struct {
    int width, height, level;
  } cases[] = {{1, 1, 0}, {2, 1, 1},     {1, 3, 2},   {4, 4, 2},
               {5, 3, 3}, {256, 255, 8}, {257, 2, 9}, {16384, 1, 14}};
  for (const auto& [width, height, level] : cases) {
    EXPECT_EQ(root_level_of(width, height), level) << width << " x " << height;
    EXPECT_EQ(map_shape(width, height, 8, AddressMode::kClamp).root_level, level);
  }
}

TEST(Quantise, ScalesToTexelsAndHeightsWithAllBitsOfTheLargestComponent) {
  // In texels and LSBs a unit of t: (4 * 0.25, 8 * 0.25, -255 * 1/255) = (1, 2, -1).
  const MachineRay ray = quantise(ray_of(0.5, 0.25, 1, 0.25, 0.25, -1 / 255.0), kMap, kFormat);
  EXPECT_EQ(ray.x0, 2 << 8);
  EXPECT_EQ(ray.y0, 2 << 8);
  EXPECT_EQ(ray.z0, kTop);
  EXPECT_EQ(ray.dy, int64_t{1} << 31);
  EXPECT_EQ(ray.dx, int64_t{1} << 30);
  EXPECT_EQ(ray.dz, -(int64_t{1} << 30));
  EXPECT_EQ(ray.exponent, -30);
  EXPECT_FALSE(ray.dead);
}

TEST(Quantise, RoundsOriginsToNearestEven) {
  const double grid = 1 / 1024.0;  // of four texels: one 2^-8 step
  EXPECT_EQ(quantise(ray_of(10.5 * grid, 0, 1, 1, 0, -1), kMap, kFormat).x0, 10);
  EXPECT_EQ(quantise(ray_of(11.5 * grid, 0, 1, 1, 0, -1), kMap, kFormat).x0, 12);
  EXPECT_EQ(quantise(ray_of(-10.5 * grid, 0, 1, 1, 0, -1), kMap, kFormat).x0, -10);
  EXPECT_EQ(quantise(ray_of(10.75 * grid, 0, 1, 1, 0, -1), kMap, kFormat).x0, 11);
}

TEST(Quantise, KeepsTheLargestComponentBelowItsWidthWhenItRoundsUp) {
  // 2^33 - 1 in 32 bits rounds to 2^32, which has 33 bits: one exponent more.
  const MachineRay ray = quantise(ray_of(0, 0, 1, 0.25 * 8589934591.0, 0, -1), kMap, kFormat);
  EXPECT_EQ(ray.dx, int64_t{1} << 31);
  EXPECT_EQ(ray.exponent, 2);
}

TEST(Quantise, MovesAPrimaryRayThatStartsAboveTheSlabToItsTop) {
  // From z = 2, three units of z down for one u: reaches 1 at a third of the way.
  TracedRay above = ray_of(0, 0, 2, 0.75, 0, -1);
  above.t_max = 1.5;
  const MachineRay ray = quantise(above, kMap, kFormat);
  EXPECT_EQ(ray.x0, 3 << 8);
  EXPECT_EQ(ray.z0, kTop);
  // Half a unit of t is left: dz = -255 LSB = -(255 << 24) at q = -24, units of 2^(8 + 31 + 12 - 24).
  EXPECT_EQ(ray.exponent, -24);
  EXPECT_EQ(ray.t_max, int64_t{1} << (8 + 31 + 12 - 24 - 1));
  EXPECT_FALSE(ray.dead);
}

TEST(Quantise, CallsRaysDeadThatLeaveTheSlabOrEndBeforeTheyStart) {
  EXPECT_TRUE(quantise(ray_of(0, 0, 1.5, 1, 0, 0.5), kMap, kFormat).dead);
  EXPECT_TRUE(quantise(ray_of(0, 0, 1.5, 1, 0, 0), kMap, kFormat).dead);
  EXPECT_TRUE(quantise(ray_of(0, 0, -0.5, 1, 0, -1), kMap, kFormat).dead);
  TracedRay ray = ray_of(0, 0, 0.5, 1, 0, -1);
  ray.t_max = 0;
  EXPECT_TRUE(quantise(ray, kMap, kFormat).dead);
  ray.t_max = 1;
  ray.t_min = 2;
  EXPECT_TRUE(quantise(ray, kMap, kFormat).dead);
  ray = ray_of(0, 0, 3, 1, 0, -1);  // ends above the slab
  ray.t_max = 2;
  EXPECT_TRUE(quantise(ray, kMap, kFormat).dead);
}

TEST(Quantise, TakesTheCoordinateThatTheParentFixedExactly) {
  TracedRay ray = ray_of(0.3, 0.3, 0.5, 1, 0.1, 1);
  ray.kind = RayKind::kShadow;
  ray.fixed_axis = FixedAxis::kX;
  ray.fixed_coordinate = -5;
  EXPECT_EQ(quantise(ray, kMap, kFormat).x0, -5 * 256);
  ray.fixed_axis = FixedAxis::kY;
  EXPECT_EQ(quantise(ray, kMap, kFormat).y0, -5 * 256);
  ray.fixed_axis = FixedAxis::kZ;
  ray.fixed_coordinate = 200;
  EXPECT_EQ(quantise(ray, kMap, kFormat).z0, 200 * 256);
}

TEST(Quantise, ForgivesASecondaryRaysHeightItsRounding) {
  TracedRay ray = ray_of(0.25, 0.3, 1 + 1e-15, 1, 0.1, -1);
  ray.kind = RayKind::kReflection;
  ray.fixed_axis = FixedAxis::kX;
  ray.fixed_coordinate = 1;
  EXPECT_FALSE(quantise(ray, kMap, kFormat).dead);
  EXPECT_EQ(quantise(ray, kMap, kFormat).z0, kTop);
  ray.origin[2] = -1e-17;
  EXPECT_FALSE(quantise(ray, kMap, kFormat).dead);
  EXPECT_EQ(quantise(ray, kMap, kFormat).z0, 0);
}

TEST(Quantise, EndsEveryRayAfterItsTiles) {
  // 16 tiles of 4 texels, one texel a unit of t; q = -31: 2^(8 + 31 + 12 - 31) machine units for each.
  const MachineRay ray = quantise(ray_of(0, 0, 1, 0.25, 0, 0), kMap, kFormat);
  EXPECT_EQ(ray.t_max, int64_t{64} << 20);
  // Along the longer axis 128 texels, twice as long; the shorter axis is still the first.
  EXPECT_EQ(quantise(ray_of(0, 0, 1, 0.25, 0.125, 0), kMap, kFormat).t_max, int64_t{64} << 20);
  // 128 texels are more than 2^T: t_end.
  EXPECT_EQ(quantise(ray_of(0, 0, 1, 0, 0.125, 0), kMap, kFormat).t_max,
            std::min(int64_t{128} << 20, (int64_t{1} << 28) - 1));
  EXPECT_EQ(quantise(ray_of(0, 0, 1, 0, 0, -1), kMap, kFormat).t_max, (int64_t{1} << 28) - 1);
}

TEST(Quantise, RoundsTMaxUp) {
  TracedRay ray = ray_of(0, 0, 1, 0.25, 0, 0);
  ray.t_max = 3;
  EXPECT_EQ(quantise(ray, kMap, kFormat).t_max, int64_t{3} << 20);
  ray.t_max = 3 + 0x1p-30;
  EXPECT_EQ(quantise(ray, kMap, kFormat).t_max, (int64_t{3} << 20) + 1);
  ray.t_max = 1e-300;
  EXPECT_EQ(quantise(ray, kMap, kFormat).t_max, 1);
}

TEST(Quantise, KeepsItsRangesForAnyRay) {
  Random random(5);
  for (int n = 0; n < 100000; ++n) {
    const RandomMap map = random_map(random.next(), 16);
    TracedRay traced = random_ray(random, map, 1);
    const int power = static_cast<int>(random.between(-300, 300));
    for (double& d : traced.direction) d = std::ldexp(d, power);
    MachineRay ray;
    try {
      ray = quantise(traced, map.shape, map.format);
    } catch (const Error& error) {
      ASSERT_NE(std::string(error.what()).find("tiles"), std::string::npos) << error.what();
      continue;
    }
    const int D = map.format.direction_bits;
    const int64_t largest = std::max({std::abs(ray.dx), std::abs(ray.dy), std::abs(ray.dz)});
    ASSERT_EQ(largest >> (D - 1), 1) << describe(map) << "\n" << describe(traced);
    ASSERT_GE(ray.z0, 0);
    ASSERT_LE(ray.z0, map.shape.full_scale() << map.format.fraction_bits);
    ASSERT_GE(ray.t_max, 0);
    ASSERT_LT(ray.t_max, int64_t{1} << time_bits(map.shape, map.format));
    const int64_t reach =
        int64_t{1} << (map.shape.root_level + map.format.tile_bits + map.format.fraction_bits);
    ASSERT_LE(std::max(std::abs(ray.x0), std::abs(ray.y0)), reach);
    const double scale[3] = {static_cast<double>(map.grid.width), static_cast<double>(map.grid.height),
                             static_cast<double>(map.grid.full_scale())};
    const int64_t d[3] = {ray.dx, ray.dy, ray.dz};
    for (int a = 0; a < 3; ++a) {  // half a unit, and a double's own rounding
      const double wanted = std::ldexp(traced.direction[a] * scale[a], -ray.exponent);
      ASSERT_LE(std::abs(static_cast<double>(d[a]) - wanted), 0.5 + 1e-6) << describe(traced);
    }
  }
}

void expect_refused(const TracedRay& ray, const std::string& word) {
  try {
    quantise(ray, kMap, kFormat);
    ADD_FAILURE() << "accepted; expected a sentence with '" << word << "'";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::kInput);
    EXPECT_NE(std::string(error.what()).find("ray 7"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(Quantise, RefusesWhatIsNoRayAndNamesIt) {
  for (int a = 0; a < 3; ++a) {
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
      TracedRay ray = ray_of(0, 0, 1, 1, 0, -1);
      ray.origin[a] = bad;
      expect_refused(ray, "origin");
      ray = ray_of(0, 0, 1, 1, 0, -1);
      ray.direction[a] = bad;
      expect_refused(ray, "direction");
    }
  }
  expect_refused(ray_of(0, 0, 1, 0, -0.0, 0), "zero");
  TracedRay ray = ray_of(0, 0, 1, 1, 0, -1);
  ray.t_max = kNan;
  expect_refused(ray, "t_max");
  ray.t_max = 1;
  ray.t_min = kInfinity;
  expect_refused(ray, "t_min");
}

TEST(Quantise, RefusesOriginsThatItsTilesCannotHold) {
  // 2^(3 + 4) = 128 texels: 32 tiles along u, 16 along v.
  EXPECT_NO_THROW(quantise(ray_of(31.9, -15.9, 1, 1, 0, -1), kMap, kFormat));
  expect_refused(ray_of(32, 0, 1, 1, 0, -1), "origin u");
  expect_refused(ray_of(0, -16, 1, 1, 0, -1), "origin v");
  expect_refused(ray_of(1e308, 0, 1, 1, 0, -1), "origin u");
  expect_refused(ray_of(0, 0, 1e308, 0, 1e-300, -1e-300), "origin");
  TracedRay ray = ray_of(0, 0, 0.5, 1, 0, 1);
  ray.fixed_axis = FixedAxis::kX;
  ray.fixed_coordinate = std::numeric_limits<int32_t>::max();
  expect_refused(ray, "fixed coordinate");
  ray.fixed_axis = FixedAxis::kZ;
  ray.fixed_coordinate = -1;
  expect_refused(ray, "fixed coordinate");
  ray.fixed_coordinate = 256;
  expect_refused(ray, "fixed coordinate");
}

TEST(Quantise, TakesDirectionsAtTheEndsOfADoublesRange) {
  for (const double size : {5e-324, 1e-310, 1e-300, 1e300, 1.7e308}) {
    const MachineRay ray = quantise(ray_of(0, 0, 0.5, size, 0, 0), kMap, kFormat);
    EXPECT_EQ(ray.dx >> 31, 1) << size;
    EXPECT_EQ(ray.dy, 0);
  }
}

}  // namespace
}  // namespace cuesta
