#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "sim/verify/lockstep/lockstep.h"
#include "sim/verify/lockstep/rtl_sides.h"
#include "tests/support/temporary_folder.h"

// The Verilated hardware in the machine's place of its units against the model: every ray's entry, memory request and
// hit record with their cycles, every counter and fill, what each ray took; random machines over the compiled sets,
// random stalls on every outer port, and in half of them a memory outside with random latencies in any order.

namespace cuesta {
namespace {

/// Several times CUESTA_RTL_RAYS where that is set.
uint64_t rays_wanted(uint64_t rays) {
  const char* told = std::getenv("CUESTA_RTL_RAYS");
  return told == nullptr ? rays : std::stoull(told);
}

/// Every set in turn, with machines that follow from `first_seed` and the set.
void compare_all(HardwareUnit unit, uint64_t rays_per_set, uint64_t first_seed) {
  const auto sides = rtl_sides(unit);
  for (const rtl::RtlSet& set : compiled_sets({})) {
    uint64_t rays = 0, requests = 0, machines = 0, cycles = 0, outside = 0;
    for (uint64_t seed = first_seed; rays < rays_wanted(rays_per_set); ++seed, ++machines) {
      const LockstepCase one = random_rtl_case(structure_of(set.parameters, unit), seed);
      const LockstepResult result = run_lockstep(one, sides[0], sides[1]);
      ASSERT_TRUE(result.equal()) << "set " << set.name << "\n"
                                  << report(result.differences, {"model", "RTL"}) << describe(one);
      EXPECT_EQ(result.rays, one.rays.size());
      rays += result.rays;
      requests += result.requests;
      cycles += static_cast<uint64_t>(result.cycles);
      outside += one.machine.memory.has_value();
    }
    std::cout << set.name << ": " << rays << " rays, " << cycles << " cycles, " << requests << " requests on "
              << machines << " machines, " << outside << " of them with memory outside: no difference\n";
  }
}

TEST(HmtTopRtl, EqualsTheModelAtEveryPortInEveryCycleUnderRandomStalls) {
  compare_all(HardwareUnit::kHmtTop, 8'000, 1);
}

TEST(TraverseRtl, EqualsTheModelAtEveryPortInEveryCycleUnderRandomStalls) {
  compare_all(HardwareUnit::kTraverse, 4'000, 100'001);
}

TEST(LockstepRtl, AFaultInTheModelIsFoundAndLeavesWavesAroundIt) {
  // The model's cache has half the MSHRs that the hardware has.
  const rtl::RtlSet set = compiled_sets({}).front();
  auto sides = rtl_sides(HardwareUnit::kHmtTop);
  sides[0].change = [](LockstepMachine& m) {
    m.architecture.units = {};
    m.architecture.height_l1.mshrs /= 2;
  };
  LockstepResult result;
  LockstepCase one;
  for (uint64_t seed = 1; seed < 50 && result.equal(); ++seed) {
    one = random_rtl_case(structure_of(set.parameters, HardwareUnit::kHmtTop), seed);
    result = run_lockstep(one, sides[0], sides[1]);
  }
  ASSERT_FALSE(result.equal());
  // What the model refuses the hardware sends for.
  auto has = [&](const char* field) {
    return std::ranges::any_of(result.differences, [&](const Difference& d) { return d.field == field; });
  };
  EXPECT_TRUE(has("slots_refused"));
  EXPECT_TRUE(has("misses"));
  const TemporaryFolder folder;
  const std::string file = folder.path("waves.fst");
  EXPECT_FALSE(leave_waves(one, sides[0], result.differences.front(), file));
  ASSERT_TRUE(leave_waves(one, sides[1], result.differences.front(), file));
  EXPECT_GT(std::filesystem::file_size(file), 1000u);
  EXPECT_LT(std::filesystem::file_size(file), 5'000'000u);
}

}  // namespace
}  // namespace cuesta
