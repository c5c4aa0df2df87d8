#include "models/oracle/verdict.h"

#include <gtest/gtest.h>

#include "tests/support/hand_made_rays.h"

namespace cuesta {
namespace {

constexpr NumberFormat kFormat{.fraction_bits = 8, .direction_bits = 8, .mantissa_bits = 4, .tile_bits = 4};
constexpr int64_t kTexel = 4096;  // machine time of a component of 128 for one texel or LSB

struct Case {
  HeightGrid grid;
  MachineRay ray;

  Verdict of(const JudgedAnswer& answer) const {
    const MapShape shape{grid.width, grid.height, 2, grid.bits, AddressMode::kBorder};
    const auto exact = exact_ray(ray, shape, kFormat, OracleInput::kMachineInput);
    const OracleMap map = oracle_map(grid, shape);
    return judge(exact, map, oracle_leaf_walk(exact, map), answer);
  }
};

HeightGrid flat(int value) { return {4, 4, 8, std::vector<uint16_t>(16, static_cast<uint16_t>(value))}; }

constexpr JudgedAnswer kMissAnswer{};
JudgedAnswer hit_at(int64_t i, int64_t j, long double texels) { return {true, i, j, texels * kTexel}; }

TEST(Verdict, NamesWhatIsWrongWithAnAnswer) {
  Case c{flat(0), ray_from(0.5, 0.5, 100, 128, 0, 0)};
  c.grid.at(2, 0) = 200;  // hit at plane 2, 1.5 texels on
  c.grid.at(3, 0) = 200;
  EXPECT_EQ(c.of(hit_at(2, 0, 1.5)), Verdict::kExact);
  EXPECT_EQ(c.of(kMissAnswer), Verdict::kMissed);
  EXPECT_EQ(c.of(hit_at(3, 0, 2.5)), Verdict::kBehind);
  EXPECT_EQ(c.of(hit_at(1, 0, 0.5)), Verdict::kWrongCell);
  EXPECT_EQ(c.of(hit_at(1, 1, 1.0)), Verdict::kWrongCell);
  EXPECT_EQ(c.of(hit_at(-9, 0, 1.0)), Verdict::kWrongCell);
}

TEST(Verdict, CallsAHitThatIsNotThereAWrongCell) {
  const Case c{flat(0), ray_from(0.5, 0.5, 100, 128, 0, 0)};
  EXPECT_EQ(c.of(kMissAnswer), Verdict::kExact);
  EXPECT_EQ(c.of(hit_at(1, 0, 0.5)), Verdict::kWrongCell);
}

TEST(Verdict, CallsTheTouchedCornersCellsATie) {
  Case c{flat(0), ray_from(0.5, 0.5, 100, 128, 128, 0)};
  c.grid.at(1, 0) = c.grid.at(0, 1) = 200;
  c.grid.at(3, 3) = 200;
  EXPECT_EQ(c.of(hit_at(3, 3, 2.5)), Verdict::kExact);
  EXPECT_EQ(c.of(hit_at(1, 0, 0.5)), Verdict::kTie);
  EXPECT_EQ(c.of(hit_at(0, 1, 0.5)), Verdict::kTie);
  EXPECT_EQ(c.of(hit_at(2, 1, 1.5)), Verdict::kWrongCell);  // touched, but flat
}

TEST(Verdict, CallsGrazingTheTopATie) {
  Case c{flat(0), ray_from(0.5, 0.5, 100, 128, 0, 0)};
  c.grid.at(2, 0) = 100;
  EXPECT_EQ(c.of(kMissAnswer), Verdict::kExact);
  EXPECT_EQ(c.of(hit_at(2, 0, 1.5)), Verdict::kTie);
  c.grid.at(2, 0) = 99;
  EXPECT_EQ(c.of(hit_at(2, 0, 1.5)), Verdict::kWrongCell);
}

TEST(Verdict, CallsTheOtherSideOfAPlaneATieButNotAnythingBehindIt) {
  Case c{flat(0), ray_from(1, 0.5, 100, 0, 128, 0)};  // along plane x = 1
  c.grid.at(0, 2) = c.grid.at(1, 3) = 200;
  EXPECT_EQ(c.of(hit_at(1, 3, 2.5)), Verdict::kExact);
  EXPECT_EQ(c.of(hit_at(0, 2, 1.5)), Verdict::kTie);
  EXPECT_EQ(c.of(kMissAnswer), Verdict::kMissed);
  c.grid.at(0, 2) = 0;
  EXPECT_EQ(c.of(kMissAnswer), Verdict::kTie);  // the other side holds nothing
}

TEST(Verdict, CountsAddUp) {
  VerdictCounts counts;
  counts.add(Verdict::kTie);
  counts.add(Verdict::kTie);
  counts.add(Verdict::kExact);
  EXPECT_EQ(counts.count(Verdict::kTie), 2);
  EXPECT_EQ(counts.total(), 3);
}

}  // namespace
}  // namespace cuesta
