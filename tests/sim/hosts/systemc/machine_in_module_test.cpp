#include <gtest/gtest.h>

#include <cstdint>
#include <systemc>

#include "sim/machine/cycle_machine.h"
#include "tests/twins/random_machine.h"

namespace cuesta {
namespace {

const sc_core::sc_time kPeriod(2, sc_core::SC_NS);

/// The machine in a module: a thread runs it, hands control to the kernel whenever the machine reports, and ends
/// when as many clock periods have passed as the machine took cycles.
struct MachineModule : sc_core::sc_module {
  SC_HAS_PROCESS(MachineModule);
  MachineModule(const sc_core::sc_module_name& name, const twins::RandomMachine& what)
      : sc_core::sc_module(name), machine(what) {
    SC_THREAD(run);
    set_stack_size(4 << 20);
  }

  void run() {
    auto progress = [this](uint64_t, uint64_t) {
      ++reports;
      wait(kPeriod);
      return true;
    };
    outcome = run_cycle(machine.work(), machine.architecture, progress);
    const int64_t cycles = outcome.measurements.counters.get("machine.cycles");
    wait(kPeriod * static_cast<double>(cycles - reports));
    ended = sc_core::sc_time_stamp();
  }

  const twins::RandomMachine& machine;
  Outcome outcome;
  int64_t reports = 0;
  sc_core::sc_time ended;
};

/// A machine without stalls that runs for millions of cycles, so that it reports on its way.
twins::RandomMachine slow_machine(uint64_t seed, int pipelines) {
  twins::RandomMachine machine = twins::random_machine(seed, 200);
  machine.architecture.machine.pipelines = pipelines;
  machine.architecture.dram.request_latency_cycles = 10'000;
  machine.architecture.dram.response_latency_cycles = 10'000;
  machine.architecture.height_l1.mshrs = 1;
  return machine;
}

TEST(MachineInModule, GivesTheDigestOfTheDirectHost) {
  uint64_t seed = 1;
  auto slow = [&](int pipelines) {
    for (;; ++seed) {
      twins::RandomMachine machine = slow_machine(seed, pipelines);
      const Outcome outcome = run_cycle(machine.work(), machine.architecture);
      if (outcome.measurements.counters.get("machine.cycles") > 2'500'000) return machine;
    }
  };
  const twins::RandomMachine one = slow(1);
  ++seed;
  const twins::RandomMachine three = slow(3);
  const Outcome direct_one = run_cycle(one.work(), one.architecture);
  const Outcome direct_three = run_cycle(three.work(), three.architecture);

  // Two machines at once: each stops in the middle for the other.
  MachineModule module_one("one", one);
  MachineModule module_three("three", three);
  sc_core::sc_start();
  EXPECT_GT(module_one.reports, 2);
  EXPECT_GT(module_three.reports, 2);
  for (const auto& [module, direct] :
       {std::pair(&module_one, &direct_one), std::pair(&module_three, &direct_three)}) {
    ASSERT_FALSE(direct->digest.empty());
    EXPECT_EQ(module->outcome.digest, direct->digest);
    EXPECT_EQ(module->outcome.hits_digest, direct->hits_digest);
    EXPECT_EQ(module->ended,
              kPeriod * static_cast<double>(direct->measurements.counters.get("machine.cycles")));
  }
}

}  // namespace
}  // namespace cuesta
