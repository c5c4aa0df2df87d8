#include <gtest/gtest.h>

#include <vector>

#include "tests/twins/ray_dispatch_twin.h"

// By hand, from the rules of ray_dispatch: one ray a cycle, one credit a ray, credits that come back late.

namespace cuesta::twins {
namespace {

struct Bench {
  Bench(const RayDispatchParameters& parameters, int pipelines, std::vector<uint32_t> pixels, int width)
      : pixels_of_rays(std::move(pixels)), unit(parameters, pipelines, pixels_of_rays, width, stalls) {}

  /// The pipeline to which a ray goes in `cycle`, -1: none goes.
  int target(Cycle cycle) {
    const auto sent = unit.evaluate(cycle);
    unit.commit();
    return sent ? sent->pipeline : -1;
  }

  PortStalls stalls;
  std::vector<uint32_t> pixels_of_rays;
  RayDispatchTwin unit;
};

RayDispatchParameters parameters(int queue_depth, int credit_latency) {
  RayDispatchParameters p;
  p.queue_depth = queue_depth;
  p.credit_latency_cycles = credit_latency;
  return p;
}

TEST(RayDispatch, SendsOneRayACycleFromCycleZeroWhileItHasCredit) {
  Bench bench(parameters(3, 4), 1, std::vector<uint32_t>(5), 8);
  EXPECT_EQ(bench.target(0), 0);
  EXPECT_EQ(bench.target(1), 0);
  EXPECT_EQ(bench.target(2), 0);
  EXPECT_EQ(bench.target(3), -1);
}

TEST(RayDispatch, ACreditIsUsableCreditLatencyCyclesAfterTheEntryAndNotBefore) {
  Bench bench(parameters(1, 4), 1, std::vector<uint32_t>(3), 8);
  EXPECT_EQ(bench.target(0), 0);
  for (Cycle cycle = 1; cycle <= 13; ++cycle) {
    if (cycle == 10) bench.unit.give_back(0, 10);
    EXPECT_EQ(bench.target(cycle), -1) << cycle;
  }
  EXPECT_EQ(bench.target(14), 0);
  EXPECT_EQ(bench.target(15), -1);
}

TEST(RayDispatch, FirstFreeTakesTheLowestPipelineWithCredit) {
  Bench bench(parameters(2, 4), 3, std::vector<uint32_t>(7), 8);
  const int expected[] = {0, 0, 1, 1, 2, 2, -1};
  for (Cycle cycle = 0; cycle < 7; ++cycle) EXPECT_EQ(bench.target(cycle), expected[cycle]) << cycle;
}

TEST(RayDispatch, FirstFreeGoesBackToALowerPipelineWhenItsCreditReturns) {
  Bench bench(parameters(1, 2), 2, std::vector<uint32_t>(3), 8);
  EXPECT_EQ(bench.target(0), 0);
  EXPECT_EQ(bench.target(1), 1);
  bench.unit.give_back(0, 2);
  EXPECT_EQ(bench.target(2), -1);
  EXPECT_EQ(bench.target(3), -1);
  EXPECT_EQ(bench.target(4), 0);
}

TEST(RayDispatch, InterleaveSendsATilesRaysToThePipelineOfItsNumber) {
  // 10 wide, tiles of 4: three tiles across; pixel (5, 9) lies in tile (1, 2) = 7, (9, 0) in tile 2.
  RayDispatchParameters p = parameters(4, 4);
  p.assign = DispatchAssign::kInterleave;
  p.tile_size = 4;
  Bench bench(p, 4, {9 * 10 + 5, 9, 0}, 10);
  EXPECT_EQ(bench.target(0), 3);
  EXPECT_EQ(bench.target(1), 2);
  EXPECT_EQ(bench.target(2), 0);
}

TEST(RayDispatch, InterleaveWaitsForItsTargetWhileOthersHaveCredit) {
  RayDispatchParameters p = parameters(1, 1);
  p.assign = DispatchAssign::kInterleave;
  p.tile_size = 1;
  Bench bench(p, 2, {0, 2, 1}, 4);
  EXPECT_EQ(bench.target(0), 0);
  EXPECT_EQ(bench.target(1), -1);
  bench.unit.give_back(0, 1);
  EXPECT_EQ(bench.target(2), 0);
  EXPECT_EQ(bench.target(3), 1);
}

TEST(RayDispatch, ABlockedTraceSendsNothing) {
  Bench bench(parameters(8, 1), 1, std::vector<uint32_t>(4), 8);
  bench.stalls = {1, {500}};
  int sent = 0;
  for (Cycle cycle = 0; sent < 4; ++cycle) {
    const bool blocked = bench.stalls.blocked(Port::kTrace, 0, cycle);
    EXPECT_EQ(bench.target(cycle), blocked ? -1 : 0) << cycle;
    sent += blocked ? 0 : 1;
  }
  EXPECT_TRUE(bench.unit.all_sent());
}

}  // namespace
}  // namespace cuesta::twins
