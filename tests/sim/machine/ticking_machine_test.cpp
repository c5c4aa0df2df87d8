#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/twins/ticking_machine.h"

// The whole machine by hand, with the parameters of the default architecture.

namespace cuesta::twins {
namespace {

TickingResult run_one_texel(const std::vector<MachineRay>& rays, const Architecture& architecture = {}) {
  HeightGrid grid{1, 1, 8, {100}};
  const Pyramid pyramid = build_max_pyramid(grid);
  const MapShape map{1, 1, 0, 8, AddressMode::kWrap};
  const NumberFormat format;
  auto values = make_ray_values(architecture, pyramid, map, format, Schedule{}, rays);
  const std::vector<uint32_t> pixels(rays.size());
  const PortStalls stalls;
  return TickingMachine(architecture, stalls, *values, pixels, 1, 1).run();
}

MachineRay straight_down() {
  TracedRay ray;
  ray.origin[0] = ray.origin[1] = 0.5;
  ray.origin[2] = 1;
  ray.direction[2] = -1;
  return quantise(ray, MapShape{1, 1, 0, 8, AddressMode::kWrap}, NumberFormat{});
}

TEST(TickingMachine, NoRaysTakeNoCycle) { EXPECT_EQ(run_one_texel({}).cycles, 0); }

TEST(TickingMachine, ADeadRayByHand) {
  // Sent 0, set-up 4, traverse 28, hit_queue 36, writer 37, burst 38; at dram 48 = clock 77: activate 77, column
  // 88, data 99 to 107 = cycle 67; acknowledged 77.
  MachineRay dead;
  dead.dead = true;
  const TickingResult result = run_one_texel({dead});
  EXPECT_EQ(result.rays[0].sent, 0);
  EXPECT_EQ(result.rays[0].completed, 36);
  EXPECT_EQ(result.cycles, 78);
}

TEST(TickingMachine, AOneStepRayByHand) {
  // Miss 28; at dram 38 = clock 61: column 72, data 83 to 91 = cycle 57; fill 67; replay 68; done 76. Burst 78; at
  // dram 88 = clock 141, another row: precharge 141, activate 152, column 163, data 174 to 182 = cycle 114;
  // acknowledged 124.
  const TickingResult result = run_one_texel({straight_down()});
  EXPECT_EQ(result.hits[0].status, HitStatus::kHit);
  EXPECT_EQ(result.hits[0].steps, 1u);
  EXPECT_EQ(result.rays[0].completed, 76);
  EXPECT_EQ(result.cycles, 125);
  EXPECT_EQ(result.dram.row_misses, 1);
  EXPECT_EQ(result.dram.row_conflicts, 1);
}

TEST(TickingMachine, TwoRaysToOneTexelByHand) {
  // The second enters set-up 8, traverse 32, merges; replays 68 and 69. Both in one burst: taken 77, 78, full at
  // the end of 78, sent 79.
  const TickingResult result = run_one_texel({straight_down(), straight_down()});
  EXPECT_EQ(result.rays[0].completed, 76);
  EXPECT_EQ(result.rays[1].completed, 77);
  EXPECT_EQ(result.pipelines[0].merged, 1);
  EXPECT_EQ(result.pipelines[0].bursts, 1);
  EXPECT_EQ(result.rays[0].write_bytes, 64);
  EXPECT_EQ(result.rays[1].write_bytes, 0);
}

}  // namespace
}  // namespace cuesta::twins
