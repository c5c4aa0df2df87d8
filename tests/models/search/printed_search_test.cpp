#include "models/search/printed_search.h"

#include <gtest/gtest.h>

#include "tests/models/search/search_cases.h"

// Rays worked out by hand after the listings; and what the faults do.

namespace cuesta {
namespace {

/// 4 x 4 texels: `wall` in one column, else 0.
HeightGrid wall_grid(int bits, int column, uint16_t wall) {
  HeightGrid grid = flat_grid(4, 4, bits, 0);
  for (size_t j = 0; j < 4; ++j) grid.texels[4 * j + static_cast<size_t>(column)] = wall;
  return grid;
}

/// In a slab as deep as its tile is wide, so that a delta of half a texel is an eighth of 4 texels' depth.
SearchAnswer run_printed(const SearchCase& c, const char* name, const MachineRay& ray) {
  const Search search = parse_search(name);
  const SearchMap map(search, c.pyramid, c.shape.address_mode);
  SearchAnswer answer;
  answer.sink.size_bytes = map.size_bytes();
  answer.sink.most_reads = search.linear ? 4 : 1;
  answer.hit = Searcher<float>(search, map, c.shape, c.format, 1).trace(ray, Arithmetic::kFloat, answer.sink);
  EXPECT_EQ(answer.hit.steps, answer.sink.steps.size());
  return answer;
}

void expect_hit(const HitRecord& hit, int i, int j, uint32_t steps) {
  EXPECT_EQ(hit.status, HitStatus::kHit);
  EXPECT_EQ(hit.i, i);
  EXPECT_EQ(hit.j, j);
  EXPECT_EQ(hit.steps, steps);
}

void expect_none(const HitRecord& hit, HitStatus status, uint32_t steps) {
  HitRecord none;
  none.status = status;
  none.steps = steps;
  EXPECT_EQ(hit, none);
}

/// Depth where a ray of direction (., ., -1) in tiles and slabs that starts on the top was found.
double depth_of(const SearchCase& c, const MachineRay& ray, const HitRecord& hit) {
  const double t = static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(hit.t)));
  return -t * static_cast<double>(ray.dz) / static_cast<double>(c.shape.full_scale());
}

// Heights 204 of 255 lie 0.2 deep, heights 0 at 1. P = (0.125, 0.375), E = (0.5, 0.0625). Root: on to 0.2, at (0.225,
// 0.3875). Level 1, node (0, 0): 1 deep, which lies in node (1, 0); the boundary x = 0.5 is 0.375 * 0.2 / 0.1 = 0.75
// deep, y = 0.5 is 2 deep; on to 0.75 + 0.125 at (0.5625, 0.4297). Level 1 again, node (1, 0), and level 0, texel (2,
// 1): under.
TEST(Printed, KiStaysOnTheLevelOfACrossing) {
  const SearchCase c(wall_grid(8, 2, 204), AddressMode::kWrap, {});
  const MachineRay ray = ray_from(c, 0.125, 0.375, 1, 0.5, 0.0625, -1);
  const SearchAnswer answer = run_printed(c, "ki2007-printed", ray);
  expect_hit(answer.hit, 2, 1, 4);
  EXPECT_NEAR(depth_of(c, ray, answer.hit), 0.875, 1e-6);
  // Level 0 takes 16 bytes of 64, level 1 four, from 64 on; the root is at 128.
  EXPECT_EQ(answer.sink.offsets, (std::vector<uint64_t>{128, 64, 65, 6}));
}

// The same, but after the crossing the root is read again.
TEST(Printed, DrobotGoesUpAfterACrossing) {
  const SearchCase c(wall_grid(8, 2, 204), AddressMode::kWrap, {});
  const MachineRay ray = ray_from(c, 0.125, 0.375, 1, 0.5, 0.0625, -1);
  const SearchAnswer answer = run_printed(c, "drobot2009-printed", ray);
  expect_hit(answer.hit, 2, 1, 5);
  EXPECT_NEAR(depth_of(c, ray, answer.hit), 0.875, 1e-6);
  EXPECT_EQ(answer.sink.offsets, (std::vector<uint64_t>{128, 64, 128, 65, 6}));
}

// Heights 1 of 1 lie at the top: the root moves nothing, so that the crossing on level 1 divides 0 by 0.
TEST(Printed, TheFirstCrossingIsZeroOverZeroForKi) {
  const SearchCase c(wall_grid(1, 2, 1), AddressMode::kWrap, {});
  const MachineRay ray = ray_from(c, 0.125, 0.375, 1, 0.5, 0.0625, -1);
  expect_none(run_printed(c, "ki2007-printed", ray).hit, HitStatus::kNotANumber, 4);
  expect_none(run_printed(c, "ki2007-printed:linear", ray).hit, HitStatus::kNotANumber, 4 + 1 + 2);
  const MachineRay along = ray_from(c, 0.125, 0.375, 1, 0.5, 0, -1);
  expect_none(run_printed(c, "ki2007-printed", along).hit, HitStatus::kNotANumber, 4);
}

// min(d, NaN) = d: to the ground and a delta below it, over the boundary.
TEST(Printed, TheFirstCrossingIsOversteppedByDrobot) {
  const SearchCase c(wall_grid(1, 2, 1), AddressMode::kWrap, {});
  const MachineRay ray = ray_from(c, 0.125, 0.375, 1, 0.5, 0.0625, -1);
  const SearchAnswer answer = run_printed(c, "drobot2009-printed", ray);
  expect_hit(answer.hit, 2, 1, 5);
  EXPECT_NEAR(depth_of(c, ray, answer.hit), 1.125, 1e-6);
}

TEST(Printed, TheSlopeFindsTheSameBoundaryWithoutZeroOverZero) {
  const SearchCase c(wall_grid(1, 2, 1), AddressMode::kWrap, {});
  const MachineRay ray = ray_from(c, 0.125, 0.375, 1, 0.5, 0.0625, -1);
  const SearchAnswer exact = run_printed(c, "ki2007-printed:slope:delta=0", ray);
  expect_hit(exact.hit, 2, 1, 4);
  EXPECT_EQ(depth_of(c, ray, exact.hit), 0.75);
  const SearchAnswer beyond = run_printed(c, "ki2007-printed:slope", ray);
  expect_hit(beyond.hit, 2, 1, 4);
  EXPECT_EQ(depth_of(c, ray, beyond.hit), 0.875);
  expect_hit(run_printed(c, "drobot2009-printed:slope", ray).hit, 2, 1, 5);
}

// Toward smaller x the boundary 0.5 belongs to the node that is left: the same crossing again and again.
TEST(Printed, WithoutADeltaSomeRaysDoNotFinish) {
  const SearchCase c(wall_grid(1, 1, 1), AddressMode::kWrap, {});
  const MachineRay ray = ray_from(c, 0.875, 0.375, 1, -0.5, 0.0625, -1);
  expect_none(run_printed(c, "ki2007-printed:slope:delta=0", ray).hit, HitStatus::kDidNotFinish, 1000);
  expect_none(run_printed(c, "ki2007-printed:slope:delta=0:steps=7", ray).hit, HitStatus::kDidNotFinish, 7);
  expect_hit(run_printed(c, "ki2007-printed:slope", ray).hit, 1, 1, 4);
}

// E.y = 0: the middle of the node is taken for its boundary, at b / 0. Ahead of the ray it is infinitely far. Behind it
// it is -infinity: the ray goes there, where nothing equals or differs from a NaN, and comes back with the next texel
// read.
// Ki's reads texel 0 of level 1, 1 deep: over the boundary. Drobot's reads the root again, 0.2 deep: round and round.
TEST(Printed, ARayAlongAnAxisIsAstrayWhereItsNodesMiddleLiesBehindIt) {
  const SearchCase c(wall_grid(8, 2, 204), AddressMode::kWrap, {});
  const MachineRay ahead = ray_from(c, 0.125, 0.125, 1, 0.5, 0, -1);  // level 1's middle is 0.25
  const MachineRay behind = ray_from(c, 0.125, 0.375, 1, 0.5, 0, -1);
  const SearchAnswer right = run_printed(c, "ki2007-printed", ahead);
  expect_hit(right.hit, 2, 0, 4);
  EXPECT_NEAR(depth_of(c, ahead, right.hit), 0.875, 1e-6);
  const SearchAnswer astray = run_printed(c, "ki2007-printed", behind);
  expect_hit(astray.hit, 2, 1, 4);
  EXPECT_EQ(depth_of(c, behind, astray.hit), 1);
  expect_hit(run_printed(c, "drobot2009-printed", ahead).hit, 2, 0, 5);
  expect_none(run_printed(c, "drobot2009-printed:steps=100", behind).hit, HitStatus::kDidNotFinish, 100);
  for (const char* name : {"ki2007-printed:slope", "drobot2009-printed:slope"}) {
    const SearchAnswer sloped = run_printed(c, name, behind);
    EXPECT_NEAR(depth_of(c, behind, sloped.hit), 0.875, 1e-6) << name;
  }
}

// As KiStaysOnTheLevelOfACrossing, taken up 0.5 deep, at (0.375, 0.40625).
TEST(Printed, ARayThatStartsInsideTheSlabIsTakenUpOnItsWay) {
  const SearchCase c(wall_grid(8, 2, 204), AddressMode::kWrap, {});
  const MachineRay ray = ray_from(c, 0.375, 0.40625, 0.5, 0.5, 0.0625, -1);
  const SearchAnswer answer = run_printed(c, "ki2007-printed", ray);
  expect_hit(answer.hit, 2, 1, 4);
  EXPECT_NEAR(depth_of(c, ray, answer.hit), 0.375, 1e-6);
}

TEST(Printed, TheBestCaseIsOneStepForEachLevel) {
  for (const uint16_t height : {uint16_t{255}, uint16_t{254}}) {
    const SearchCase c(flat_grid(256, 256, 8, height), AddressMode::kWrap, {});
    const MachineRay ray = ray_from(c, 0.501, 0.501, 1, 0.1, 0.1, -1);
    expect_hit(run_printed(c, "ki2007-printed", ray).hit, 128, 128, 9);
    expect_hit(run_printed(c, "drobot2009-printed", ray).hit, 128, 128, 9);
  }
}

// Half a texel ahead and behind are equally far from a flat surface: the secant ends on it, after a sample at the leaf
// and two for the secant, of four reads each.
TEST(Printed, LinearFilteringOfAFlatSurfaceEndsOnIt) {
  const SearchCase c(flat_grid(16, 16, 8, 204), AddressMode::kWrap, {});
  const MachineRay ray = ray_from(c, 0.51, 0.51, 1, 0.2, 0.1, -1);
  const SearchAnswer answer = run_printed(c, "ki2007-printed:linear", ray);
  expect_hit(answer.hit, 8, 8, 5 + 1 + 2);
  EXPECT_NEAR(depth_of(c, ray, answer.hit), 0.2, 1e-6);
  EXPECT_EQ(answer.sink.steps, (std::vector<int>{1, 1, 1, 1, 1, 4, 4, 4}));
  const MachineRay vertical = ray_from(c, 0.51, 0.51, 1, 0, 0, -1);
  EXPECT_EQ(run_printed(c, "ki2007-printed", vertical).hit.status, HitStatus::kHit);
  EXPECT_EQ(run_printed(c, "ki2007-printed:linear", vertical).hit.status, HitStatus::kNotANumber);
}

TEST(Printed, RaysThatDoNotDescendMissWithoutAStep) {
  const SearchCase c(wall_grid(8, 2, 204), AddressMode::kWrap, {});
  for (const double dz : {0.0, 1.0}) {
    expect_none(run_printed(c, "ki2007-printed", ray_from(c, 0.125, 0.375, 0.5, 0.5, 0.1, dz)).hit,
                HitStatus::kMiss, 0);
  }
}

// Whatever the ray: the loop ends, reads stay inside the image, and no NaN reaches the record.
TEST(Printed, EveryRayEndsWithinItsStepsAndItsRecordIsNeverNaN) {
  Random random(2007);
  int64_t ends[4] = {};
  for (int m = 0; m < 40; ++m) {
    const int side = 1 << random.below(6);
    HeightGrid grid = flat_grid(side, side, 8, 0);
    for (uint16_t& texel : grid.texels) texel = static_cast<uint16_t>(random.below(256));
    const SearchCase c(std::move(grid), AddressMode::kWrap, {});
    for (const char* name : {"ki2007-printed:steps=200", "ki2007-printed:delta=0:steps=200:linear",
                             "drobot2009-printed:steps=200", "drobot2009-printed:delta=0:slope:steps=200"}) {
      for (int r = 0; r < 50; ++r) {
        const auto part = [&] { return static_cast<double>(random.between(-1000, 1000)) / 1000; };
        const bool along = random.chance(0.2);
        const MachineRay ray = ray_from(c, part(), part(), random.chance(0.3) ? 0.5 : 1, part(),
                                        along ? 0 : part(), random.chance(0.1) ? -1e-7 : -1);
        const HitRecord hit = run_printed(c, name, ray).hit;
        ++ends[static_cast<size_t>(hit.status)];
        EXPECT_LE(hit.steps, 200u * 2 + 2);
        if (hit.status == HitStatus::kHit) {
          EXPECT_GE(std::bit_cast<float>(static_cast<uint32_t>(hit.t)), 0.0F);
        } else {
          expect_none({hit.ray_id, hit.status, HitFace::kNone, 0, hit.i, hit.j, hit.t, hit.steps}, hit.status,
                      hit.steps);
        }
      }
    }
  }
  EXPECT_GT(ends[static_cast<size_t>(HitStatus::kHit)], 1000);
  EXPECT_GT(ends[static_cast<size_t>(HitStatus::kNotANumber)], 100);
  EXPECT_GT(ends[static_cast<size_t>(HitStatus::kDidNotFinish)], 100);
}

TEST(Printed, MapsThatTheListingsCannotReadAreRefused) {
  const Search search = parse_search("ki2007-printed");
  const Pyramid square = build_max_pyramid(flat_grid(8, 8, 8, 7));
  const Pyramid odd = build_max_pyramid(flat_grid(8, 6, 8, 7));
  for (const AddressMode mode : {AddressMode::kBorder, AddressMode::kMirror, AddressMode::kClamp}) {
    EXPECT_THROW(SearchMap(search, square, mode), Error);
  }
  EXPECT_THROW(SearchMap(search, odd, AddressMode::kWrap), Error);
  EXPECT_NO_THROW(SearchMap(search, square, AddressMode::kWrap));
}

}  // namespace
}  // namespace cuesta
