#include "models/oracle/oracle.h"

#include <gtest/gtest.h>

#include "models/oracle/verdict.h"
#include "tests/support/hand_made_rays.h"

namespace cuesta {
namespace {

// D = 8, M = 4, f = 8. A component of 128 moves by one texel (or LSB) in 4096 machine time units: its reciprocal
// is 2^11 / 128 = 16 units for each of the 256 grid steps.
constexpr NumberFormat kFormat{.fraction_bits = 8, .direction_bits = 8, .mantissa_bits = 4, .tile_bits = 4};
constexpr int64_t kTexel = 4096;

HeightGrid row(std::vector<uint16_t> texels) {
  return {static_cast<int>(texels.size()), 1, 8, std::move(texels)};
}

/// Leaf walk and brute force must say the same.
HitRecord ask(const HeightGrid& grid, const MachineRay& ray, AddressMode mode = AddressMode::kBorder,
              OracleInput input = OracleInput::kSetup) {
  const MapShape shape = shape_of(grid, mode);
  const auto exact = exact_ray(ray, shape, kFormat, input);
  const OracleMap map = oracle_map(grid, shape);
  const HitRecord walked = to_record(oracle_leaf_walk(exact, map), 0, 0);
  HitRecord brute = to_record(*oracle_brute_force(exact, map), 0, 0);
  brute.steps = walked.steps;
  EXPECT_EQ(walked, brute);
  return walked;
}

void expect_hit(const HitRecord& found, int i, int j, int64_t t, HitFace face) {
  EXPECT_EQ(found.status, HitStatus::kHit);
  EXPECT_EQ(found.i, i);
  EXPECT_EQ(found.j, j);
  EXPECT_EQ(found.t, t);
  EXPECT_EQ(found.face, face);
}

TEST(Oracle, HitsTheTopWhereTheRayFallsBelowTheHeight) {
  // From x = 0.5, z = 10, down one LSB a texel: at z = 7 the ray is at x = 3.5, 3 texels on.
  expect_hit(ask(row({0, 0, 0, 7, 0, 0, 0, 0}), ray_from(0.5, 0.5, 10, 128, 0, -128)), 3, 0, 3 * kTexel,
             HitFace::kTop);
}

TEST(Oracle, HitsTheWallThatTheRayEntersBelowItsTop) {
  // At plane 3 the ray is at z = 7.5, below 8: 2.5 texels on. Cells 0 to 3 are visited.
  const HitRecord found = ask(row({0, 0, 0, 8, 0, 0, 0, 0}), ray_from(0.5, 0.5, 10, 128, 0, -128));
  expect_hit(found, 3, 0, 5 * kTexel / 2, HitFace::kWallX);
  EXPECT_EQ(found.steps, 4u);
}

TEST(Oracle, SeesTheMirroredRayAlike) {
  expect_hit(ask(row({0, 0, 0, 0, 8, 0, 0, 0}), ray_from(7.5, 0.5, 10, -128, 0, -128)), 4, 0, 5 * kTexel / 2,
             HitFace::kWallX);
}

TEST(Oracle, AnswersInsideWhenTheRayStartsBelowTheSurface) {
  expect_hit(ask(row({9, 9}), ray_from(0.5, 0.5, 4, 128, 0, -128)), 0, 0, 0, HitFace::kInside);
  expect_hit(ask(row({9, 9}), ray_from(0.5, 0.5, 4, 128, 0, 128)), 0, 0, 0, HitFace::kInside);
}

TEST(Oracle, LeavesTheBorderedMapAsAMissAndWrapsTheOther) {
  const HeightGrid grid = row({0, 0, 0, 0});
  const MachineRay ray = ray_from(0.5, 0.5, 10, 128, 0, -128);
  EXPECT_EQ(ask(grid, ray).status, HitStatus::kMiss);
  EXPECT_EQ(ask(grid, ray).steps, 4u);
  expect_hit(ask(grid, ray, AddressMode::kWrap), 10, 0, 10 * kTexel, HitFace::kTop);
  const MachineRay back = ray_from(0.5, 0.5, 10, -128, 0, -128);
  expect_hit(ask(grid, back, AddressMode::kWrap), -10, 0, 10 * kTexel, HitFace::kTop);
}

TEST(Oracle, EntersFromTheSideAndHitsTheMapsOwnWall) {
  expect_hit(ask(row({8, 0}), ray_from(-2, 0.5, 9, 128, 0, -128)), 0, 0, 2 * kTexel, HitFace::kWallX);
  // Below the slab before it reaches the map: nothing there.
  EXPECT_EQ(ask(row({8, 0}), ray_from(-10, 0.5, 9, 128, 0, -128)).steps, 0u);
}

TEST(Oracle, CountsTouchingAsAMissForHorizontalAndRisingRays) {
  expect_hit(ask(row({0, 0, 6}), ray_from(0.5, 0.5, 5, 128, 0, 0)), 2, 0, 3 * kTexel / 2, HitFace::kWallX);
  EXPECT_EQ(ask(row({0, 0, 5}), ray_from(0.5, 0.5, 5, 128, 0, 0)).status, HitStatus::kMiss);
  // Rising one LSB a texel from z = 1: at plane 2, 2 texels on, z = 3.
  expect_hit(ask(row({0, 0, 4}), ray_from(0, 0.5, 1, 128, 0, 128)), 2, 0, 2 * kTexel, HitFace::kWallX);
  EXPECT_EQ(ask(row({0, 0, 3}), ray_from(0, 0.5, 1, 128, 0, 128)).status, HitStatus::kMiss);
}

TEST(Oracle, PassesACornerDiagonally) {
  const HeightGrid grid{2, 2, 8, {0, 200, 200, 0}};
  const HitRecord found = ask(grid, ray_from(0.5, 0.5, 2, 128, 128, -128));
  EXPECT_EQ(found.status, HitStatus::kMiss);  // leaves the map at z = 0.5
  EXPECT_EQ(found.steps, 2u);
}

TEST(Oracle, GivesARayAlongAPlaneToTheCellAboveIt) {
  const HeightGrid grid{2, 2, 8, {0, 200, 0, 0}};  // texel (1, 0) is high
  expect_hit(ask(grid, ray_from(1, 1.5, 100, 0, -128, 0)), 1, 0, kTexel / 2, HitFace::kWallY);
  const HeightGrid other{2, 2, 8, {200, 0, 0, 0}};
  EXPECT_EQ(ask(other, ray_from(1, 1.5, 100, 0, -128, 0)).status, HitStatus::kMiss);
}

TEST(Oracle, StopsAtTMax) {
  const HeightGrid grid = row({0, 0, 0, 7, 0, 0, 0, 0});
  EXPECT_EQ(ask(grid, ray_from(0.5, 0.5, 10, 128, 0, -128, 3 * kTexel)).status, HitStatus::kMiss);
  EXPECT_EQ(ask(grid, ray_from(0.5, 0.5, 10, 128, 0, -128, 3 * kTexel + 1)).status, HitStatus::kHit);
  EXPECT_EQ(ask(grid, ray_from(0.5, 0.5, 10, 128, 0, -128, 0)).steps, 0u);
}

TEST(Oracle, RoundsReciprocalsHalfUp) {
  // 2^10 / 96 = 10.67; 2^11 / 128 = 16 = 2^M; 2^4 / 1 = 16; 2^5 / 3 = 10.67; 2^7 / 9 = 14.2.
  const auto expect = [](int64_t d, int64_t mantissa, int exponent) {
    const OracleReciprocal r = oracle_reciprocal(d, kFormat);
    EXPECT_EQ(r.mantissa, mantissa) << d;
    EXPECT_EQ(r.exponent, exponent) << d;
  };
  expect(96, 11, 1);
  expect(128, 16, 0);
  expect(1, 16, 7);
  expect(3, 11, 6);
  expect(9, 14, 4);
  // A half: 2^(b-1+M) / d = n + 1/2 needs d | 2^(b+M): only powers of two, which divide whole.
}

TEST(Oracle, TellsTheRaysInputFromItsRoundedReciprocals) {
  // dx = 96: 64/3 units a grid step, rounded to 22. 256 grid steps take 5461.33 or 5632 units.
  const HeightGrid grid = row({0, 9});
  const MachineRay ray = ray_from(0, 0.5, 5, 96, 0, 0);
  EXPECT_EQ(ask(grid, ray).t, 5632);
  const MapShape shape = shape_of(grid, AddressMode::kBorder);
  const auto exact = exact_ray(ray, shape, kFormat, OracleInput::kMachineInput);
  const auto hit = oracle_leaf_walk(exact, oracle_map(grid, shape));
  ASSERT_TRUE(hit.hit);
  EXPECT_NEAR(static_cast<double>(exact.in_machine_units(hit.t)), 5461 + 1 / 3.0, 1e-9);
}

TEST(Oracle, RefusesToBruteForceMoreCellsThanAllowed) {
  const HeightGrid grid = row({0, 9});
  const MapShape shape = shape_of(grid, AddressMode::kBorder);
  const auto exact = exact_ray(ray_from(0, 0.5, 5, 96, 0, 0), shape, kFormat, OracleInput::kSetup);
  EXPECT_FALSE(oracle_brute_force(exact, oracle_map(grid, shape), 1).has_value());
  EXPECT_TRUE(oracle_brute_force(exact, oracle_map(grid, shape), 2).has_value());
}

TEST(OracleSpan, IsTheNodeThatHoldsTheLeafInBothDirections) {
  // Five leaves, level 1: nodes [0,2) [2,4) [4,5). Seen mirrored, leaf 0 is leaf 4, in node 2 = planes [0, 1).
  const OracleSpan plain = oracle_span(4, false, 5, 1, AddressMode::kWrap);
  EXPECT_EQ(std::tuple(plain.lower, plain.upper, plain.index, plain.stored), std::tuple(4, 5, 2, 2));
  const OracleSpan mirrored = oracle_span(0, true, 5, 1, AddressMode::kWrap);
  EXPECT_EQ(std::tuple(mirrored.lower, mirrored.upper, mirrored.index, mirrored.stored),
            std::tuple(0, 1, 2, 2));
  const OracleSpan next = oracle_span(1, true, 5, 1, AddressMode::kWrap);
  EXPECT_EQ(std::tuple(next.lower, next.upper, next.index, next.stored), std::tuple(1, 3, 1, 1));
  const OracleSpan tile = oracle_span(-1, false, 5, 1, AddressMode::kWrap);  // the tile before
  EXPECT_EQ(std::tuple(tile.lower, tile.upper, tile.index, tile.stored), std::tuple(-1, 0, -1, 2));
}

}  // namespace
}  // namespace cuesta
