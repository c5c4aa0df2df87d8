#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "sim/machine/cycle_machine.h"
#include "tests/twins/machine_difference.h"

namespace cuesta::twins {
namespace {

TEST(CycleMachine, DigestDoesNotDependOnTheOrderOfConstruction) {
  for (uint64_t seed = 1; seed <= 150; ++seed) {
    RandomMachine machine = random_machine(seed, 200);
    if (machine.architecture.machine.pipelines == 1) machine.architecture.machine.pipelines = 3;
    CycleHooks hooks;
    if (machine.stalled) hooks.stalls = &machine.stalls;
    const Outcome forward = run_cycle_detailed(machine.work(), machine.architecture, {}, hooks, nullptr);
    hooks.reverse_construction = true;
    const Outcome reverse = run_cycle_detailed(machine.work(), machine.architecture, {}, hooks, nullptr);
    ASSERT_FALSE(forward.digest.empty());
    ASSERT_EQ(forward.digest, reverse.digest) << describe(machine);
  }
}

TEST(CycleMachine, TwoRunsGiveOneDigest) {
  const RandomMachine machine = random_machine(7, 200);
  EXPECT_EQ(run_cycle(machine.work(), machine.architecture).digest,
            run_cycle(machine.work(), machine.architecture).digest);
}

TEST(TickingMachine, DoesNotDependOnTheOrderInWhichPipelinesAreEvaluated) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    RandomMachine machine = random_machine(seed, 100);
    machine.architecture.machine.pipelines = 4;
    const TwinRun ascending = run_ticking(machine, {0, 1, 2, 3});
    const TwinRun mixed = run_ticking(machine, {2, 0, 3, 1});
    ASSERT_EQ(ascending.counters.all(), mixed.counters.all()) << describe(machine);
    for (size_t k = 0; k < ascending.rays.size(); ++k) {
      ASSERT_EQ(ascending.rays[k].completed, mixed.rays[k].completed) << describe(machine);
    }
  }
}

TEST(RandomMachines, ReachEveryStateOfTheMachine) {
  // What the comparison of machines rests on: each of these happens in many of them.
  constexpr int kMachines = 200;
  std::map<std::string, int> machines_with;
  for (uint64_t seed = 1; seed <= kMachines; ++seed) {
    const TwinRun run = run_ticking(random_machine(seed, 200));
    std::map<std::string, int64_t> sums;
    for (const auto& [path, value] : run.counters.all()) {
      const size_t open = path.find('[');
      sums[open == std::string::npos ? path : path.substr(0, open) + path.substr(path.find(']') + 1)] +=
          value;
    }
    for (const auto& [path, sum] : sums) machines_with[path] += sum > 0;
  }
  for (const char* path :
       {"height_l1.merges", "height_l1.refused", "height_l1.evictions", "traverse.replays",
        "traverse.slots_dead", "traverse.slots_part", "traverse.kept_steps", "traverse.bubble_contexts_full",
        "traverse.bubble_no_ray", "traverse.bubble_drain", "traverse.stall_hit_queue", "dram.row_hits",
        "dram.row_misses", "dram.row_conflicts", "machine.hits", "machine.misses"}) {
    EXPECT_GE(machines_with[path], kMachines / 5) << path;
  }
  EXPECT_GE(machines_with["traverse.slots_compute"], 1);
}

}  // namespace
}  // namespace cuesta::twins
