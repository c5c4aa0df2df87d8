#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>

#include "sim/machine/cycle_machine.h"
#include "tests/twins/machine_difference.h"

// The machine of sim/machine/cycle_machine.h against the ticking machine: every ray's completion cycle, hit, slots and
// memory costs, every counter and plane, over random machines with random work and random stalls on every port.

namespace cuesta::twins {
namespace {

constexpr int kMostRays = 200;

/// Rays to compare: `fallback`, or what the environment variable CUESTA_TWIN_RAYS says, shared among `tests`.
int64_t rays_to_compare(int64_t fallback, int64_t tests) {
  const char* told = std::getenv("CUESTA_TWIN_RAYS");
  return told == nullptr ? fallback : (std::stoll(told) + tests - 1) / tests;
}

/// Compares random machines from `first_seed` on until `rays` rays have been compared.
void compare_from(uint64_t first_seed, int64_t rays) {
  const auto begin = std::chrono::steady_clock::now();
  int64_t compared = 0, stalled = 0, machines = 0;
  for (uint64_t seed = first_seed; compared < rays; ++seed) {
    const RandomMachine machine = random_machine(seed, kMostRays);
    const std::string found = difference(machine);
    if (!found.empty()) FAIL() << found;
    compared += static_cast<int64_t>(machine.rays.size());
    if (machine.stalled) stalled += static_cast<int64_t>(machine.rays.size());
    ++machines;
  }
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  std::cout << compared << " rays (" << stalled << " under random stalls) on " << machines
            << " machines, no difference, " << time.count() << " s\n";
}

constexpr int64_t kTests = 4;
#ifdef __SANITIZE_ADDRESS__
constexpr int64_t kRays = 10'000;  // of each test
#else
constexpr int64_t kRays = 100'000;
#endif

TEST(MachineEqualsTwins, FirstQuarter) { compare_from(1'000'000, rays_to_compare(kRays, kTests)); }
TEST(MachineEqualsTwins, SecondQuarter) { compare_from(2'000'000, rays_to_compare(kRays, kTests)); }
TEST(MachineEqualsTwins, ThirdQuarter) { compare_from(3'000'000, rays_to_compare(kRays, kTests)); }
TEST(MachineEqualsTwins, LastQuarter) { compare_from(4'000'000, rays_to_compare(kRays, kTests)); }

/// Each ray waits alone for a memory 20'000 cycles away.
RandomMachine far_memory(uint64_t seed) {
  RandomMachine machine = random_machine(seed, kMostRays);
  Architecture& architecture = machine.architecture;
  architecture.machine.pipelines = 1;
  architecture.traverse.stages = architecture.traverse.contexts = 1;
  architecture.height_l1.mshrs = architecture.height_l1.ways = 1;
  architecture.height_l1.size_bytes = architecture.height_l1.line_bytes = 16;
  architecture.dram.request_latency_cycles = architecture.dram.response_latency_cycles = 10'000;
  return machine;
}

TEST(MachineEqualsTwins, ForMillionsOfCyclesWithAFarMemory) {
  RandomMachine machine = far_memory(5'000'000);
  while (run_ticking(machine).counters.get("machine.cycles") < 3'000'000)
    machine = far_memory(machine.seed + 1);
  for (const bool stalled : {false, true}) {
    machine.stalled = stalled;
    machine.stalls = {1, {}};
    for (uint16_t& chance : machine.stalls.per_mille) chance = stalled ? 100 : 0;
    const std::string found = difference(machine);
    if (!found.empty()) FAIL() << found;
  }
}

}  // namespace
}  // namespace cuesta::twins
