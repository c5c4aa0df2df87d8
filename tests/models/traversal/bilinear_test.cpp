#include "models/traversal/bilinear.h"

#include <gtest/gtest.h>

#include <bit>

#include "models/oracle/bilinear_check.h"
#include "models/oracle/bilinear_oracle.h"
#include "tests/support/hand_made_rays.h"

namespace cuesta {
namespace {

constexpr NumberFormat kFormat{.fraction_bits = 8, .direction_bits = 8, .mantissa_bits = 12, .tile_bits = 4};

// Rays are in the frame of the patches; a component of 128 crosses a texel or an LSB in 1/128 of time.

MapShape patches_of(const HeightGrid& grid, AddressMode mode) {
  return shape_of(grid, mode, Surface::kBilinear);
}

struct CountingReader {
  int nodes = 0, patches = 0, samples = 0;
  void node(int, int, int) { ++nodes; }
  void patch(const PatchCorners& corners) {
    ++patches;
    samples += corners.samples();
  }
};

HitRecord ask(const HeightGrid& grid, const MachineRay& ray, AddressMode mode = AddressMode::kClamp,
              CountingReader* counted = nullptr, const Schedule& schedule = {StartRule::kLeaf}) {
  const MapShape shape = patches_of(grid, mode);
  const Pyramid pyramid = build_four_corner_pyramid(build_max_pyramid(grid), mode == AddressMode::kWrap);
  return with_bilinear_types(Arithmetic::kDouble, shape, [&]<class A, class G>() {
    const Walk<A, G> walk(shape, kFormat, schedule, pyramid.highest());
    CountingReader reader;
    const HitRecord record = traverse_bilinear_ray(walk, pyramid, ray, reader);
    if (counted != nullptr) *counted = reader;
    return record;
  });
}

/// Texels (or LSBs) moved by a component of 128 until the hit.
double distance(const HitRecord& record) { return std::bit_cast<double>(record.t) * 128; }

void expect_hit(const HitRecord& record, int i, int j, double moved, HitFace face) {
  ASSERT_EQ(record.status, HitStatus::kHit);
  EXPECT_EQ(record.i, i);
  EXPECT_EQ(record.j, j);
  EXPECT_DOUBLE_EQ(distance(record), moved);
  EXPECT_EQ(record.face, face);
}

TEST(Bilinear, MeetsATiltedPlaneWhereTheLinesCross) {
  // Heights rise by 4 a texel along x; from z = 14 at x = 0, down 1 a texel: 4 s = 14 - s at s = 2.8.
  const HeightGrid ramp{8, 1, 8, {0, 4, 8, 12, 16, 20, 24, 28}};
  expect_hit(ask(ramp, ray_from(0, 0.25, 14, 128, 0, -128)), 2, 0, 2.8, HitFace::kTop);
  // The other way, an eighth of a texel for each LSB: 30 - s = 28 - s / 2 at s = 4, half a texel into patch 6.
  expect_hit(ask(ramp, ray_from(7, 0.25, 30, -16, 0, -128)), 6, 0, 4, HitFace::kTop);
}

TEST(Bilinear, FindsTheSaddleBetweenTwoEndsThatLieAboveIt) {
  // Along the diagonal of one patch the height is 16 s (1 - s): 3 at s = 1/4 and 3/4, 4 at the middle.
  const HeightGrid saddle{2, 2, 8, {0, 8, 8, 0}};
  expect_hit(ask(saddle, ray_from(0, 0, 3, 128, 128, 0)), 0, 0, 0.25, HitFace::kTop);
  EXPECT_EQ(ask(saddle, ray_from(0, 0, 4, 128, 128, 0), AddressMode::kBorder).status, HitStatus::kMiss)
      << "touching is not going below";
  // Across the other diagonal it is 8 - 16 s (1 - s): from z = 7 at once inside, out at s = 1/16 or so.
  expect_hit(ask(saddle, ray_from(1, 0, 7, -128, 128, 0)), 0, 0, 0, HitFace::kInside);
}

TEST(Bilinear, ARayThatTouchesAPatchWhereItEntersFallsBelowItLaterToTheLastBits) {
  // From (1.5, 1, 3) by (-3/2, -1, -1): at x = 1 on the surface but for rounding, above it then, below after 2/3.
  const HeightGrid grid{3, 2, 8, {3, 2, 0, 1, 3, 0}};
  expect_hit(ask(grid, ray_from(1.5, 1, 3, -192, -128, -128)), 0, 0, 2.0 / 3, HitFace::kTop);
}

TEST(Bilinear, RepeatsTheEdgeOrBeginsAnew) {
  const HeightGrid grid{2, 1, 8, {0, 8}};
  // Patch 1 of a wrapped map falls from 8 to 0, of a clamped one it stays at 8.
  expect_hit(ask(grid, ray_from(2, 0.5, 4, -128, 0, 0), AddressMode::kWrap), 1, 0, 0.5, HitFace::kTop);
  expect_hit(ask(grid, ray_from(5, 0.5, 4, -128, 0, 0), AddressMode::kClamp), 5 - 1, 0, 0, HitFace::kInside);
  // Over a border the last patch is the last one: the ray comes in through the map's own side.
  expect_hit(ask(grid, ray_from(5, 0.5, 4, -128, 0, 0), AddressMode::kBorder), 1, 0, 3, HitFace::kWallX);
  EXPECT_EQ(ask(grid, ray_from(5, 0.5, 9, -128, 0, 0), AddressMode::kBorder).status, HitStatus::kMiss);
}

TEST(Bilinear, ARisingRayPassesWhatIsNotAboveIt) {
  const HeightGrid ramp{4, 1, 8, {0, 4, 8, 12}};
  // From below the plane z = 4 x: inside. From above it, rising as steeply: never.
  expect_hit(ask(ramp, ray_from(1, 0.5, 3, 128, 0, 128)), 1, 0, 0, HitFace::kInside);
  EXPECT_EQ(ask(ramp, ray_from(0, 0.5, 0, 32, 0, 128), AddressMode::kBorder).status, HitStatus::kMiss);
  // Rising by 1 a texel from z = 2: 2 + s = 4 s.
  expect_hit(ask(ramp, ray_from(0, 0.5, 2, 128, 0, 128)), 0, 0, 2.0 / 3, HitFace::kTop);
}

TEST(Bilinear, ReadsFourSamplesALeafAndFewerAtARepeatedEdge) {
  const HeightGrid flat{4, 4, 8, std::vector<uint16_t>(16, 0)};
  CountingReader reader;
  // Through patches 1, 2, 3 of row 1; the last repeats its samples along x.
  EXPECT_EQ(ask(flat, ray_from(1.5, 1.5, 9, 128, 0, 0), AddressMode::kBorder, &reader).steps, 3u);
  EXPECT_EQ(reader.patches, 3);
  EXPECT_EQ(reader.nodes, 0);
  EXPECT_EQ(reader.samples, 4 + 4 + 2);
  ask(flat, ray_from(1.5, 1.5, 9, 128, 0, 0), AddressMode::kBorder, &reader, {StartRule::kRoot});
  EXPECT_EQ(reader.patches, 0) << "the root lies below the ray";
  EXPECT_EQ(reader.nodes, 1);
}

TEST(Bilinear, MovesTheRayByHalfATexelOnce) {
  const HeightGrid grid{4, 4, 8, std::vector<uint16_t>(16, 0)};
  TracedRay traced;
  traced.origin[0] = 0.5;    // texel plane 2 of 4
  traced.origin[1] = 0.125;  // the middle of texel 0
  traced.origin[2] = 1;
  traced.direction[2] = -1;
  const MachineRay ray = quantise(traced, patches_of(grid, AddressMode::kWrap), kFormat);
  EXPECT_EQ(ray.x0, 2 * 256 - 128);
  EXPECT_EQ(ray.y0, 0);
}

TEST(BilinearOracle, KnowsIrrationalTimesToTheBitsAskedFor) {
  // Heights 64 u v; the diagonal at z = 32 meets 64 s^2 = 32 at s = 1 / sqrt 2.
  const HeightGrid grid{2, 2, 8, {0, 0, 0, 64}};
  const BilinearOracle oracle(ray_from(0, 0, 32, 128, 128, 0), grid, patches_of(grid, AddressMode::kBorder),
                              kFormat);
  const BilinearHit found = oracle.walk(60);
  ASSERT_TRUE(found.hit);
  // In grid steps of 1/256 texel per component of 128: s = 128 t / 256.
  const auto s = [](const ExactTime<BigInt>& t) {
    return static_cast<long double>(t.num) / static_cast<long double>(t.den) / 2;
  };
  const long double root = 0.70710678118654752440084436210485L;
  EXPECT_LE(s(found.t_low), root + 1e-18L);
  EXPECT_GE(s(found.t_high), root - 1e-18L);
  EXPECT_LE(s(found.t_high) - s(found.t_low), 1e-18L);
  // At z = 64 the ray only touches the far corner, with the patch's end: a hit if both readings are the other ones.
  const BilinearOracle touching(ray_from(0, 0, 64, 128, 128, 0), grid, patches_of(grid, AddressMode::kBorder),
                                kFormat);
  EXPECT_FALSE(touching.walk(60).hit);
  EXPECT_TRUE(touching.walk(60, {.touching = true, .edges_above = true}).hit);
  EXPECT_TRUE(touching.is_tie(true, 0, 0));
  EXPECT_FALSE(touching.is_tie(true, 1, 0));
}

TEST(BilinearCheck, EveryScheduleReturnsTheLeafWalksBits) {
  const BilinearCheck check = check_bilinear_walks(1, 3000, 40);
  EXPECT_EQ(check.mismatches, 0) << check.first_failure;
  EXPECT_EQ(check.endless, 0);
  EXPECT_EQ(check.comparisons, 3000 * 108 * 2);
  EXPECT_GT(check.hits, 1000);
  for (const AddressMode mode : {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kClamp})
    EXPECT_GT(check.rays_by_mode[static_cast<size_t>(mode)], 300);
}

TEST(BilinearCheck, PatchesAgreeOnTheirBordersAndNoRayFallsThrough) {
  const BilinearCheck check = check_bilinear_borders(2, 20000, 24);
  EXPECT_EQ(check.border_differences, 0) << check.first_failure;
  EXPECT_EQ(check.gaps, 0) << check.first_failure;
  EXPECT_GT(check.borders, 100000);
  EXPECT_GT(check.falling, 10000);
}

TEST(BilinearCheck, DoubleFindsTheExactPatchAndFloatNearlyAlways) {
  const BilinearCheck check = check_bilinear_exactly(3, 4000, 40);
  const auto& [single, twice] = check.exact;
  EXPECT_GE(twice.verdicts.count(Verdict::kExact) + twice.verdicts.count(Verdict::kTie), 3996);
  EXPECT_GE(single.verdicts.count(Verdict::kExact) + single.verdicts.count(Verdict::kTie), 3960);
  // 16-bit heights: a float's last bit at full scale is 1/256 LSB, a double's 2^-37.
  EXPECT_LT(twice.largest_height, 1e-6);
  EXPECT_LT(single.largest_height, 2);
}

}  // namespace
}  // namespace cuesta
