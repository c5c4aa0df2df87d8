#include "models/units/ray_source.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "models/units/ray_dispatch/dispatch_order.h"
#include "sim/machine/cycle_machine.h"
#include "sim/verify/lockstep/random_memory.h"
#include "tests/twins/random_machine.h"

// The contract RaySource: however the same rays come, whole as a trace, one by one, or some behind a trace, a machine
// does the same with them in the same cycles.

namespace cuesta::twins {
namespace {

/// Brings the first rays as a trace at reset and the others one by one; all of them are there in cycle 0.
class TraceThenRays final : public RaySource {
 public:
  TraceThenRays(const RandomMachine& machine, size_t in_trace) : machine_(machine), in_trace_(in_trace) {}

  void bring_until(Cycle, RayIntake& machine) override {
    if (brought_) return;
    brought_ = true;
    const std::span<const MachineRay> rays = machine_.rays;
    const std::span<const uint32_t> pixels = machine_.pixels;
    if (in_trace_ > 0) machine.trace_arrives(rays.first(in_trace_), pixels.first(in_trace_));
    for (size_t k = in_trace_; k < rays.size(); ++k) machine.ray_arrives(rays[k], pixels[k], 0);
    machine.end_of_rays(0);
  }

 private:
  const RandomMachine& machine_;
  size_t in_trace_;
  bool brought_ = false;
};

/// When each ray completes, and all counters.
struct Ran {
  std::vector<Cycle> completed;
  std::map<std::string, int64_t> counters;
  bool operator==(const Ran&) const = default;
};

Ran run(const RandomMachine& machine, size_t in_trace) {
  const DramParameters& dram = machine.architecture.dram;
  RandomMemory memory({.seed = machine.seed}, dram.request_latency_cycles + dram.response_latency_cycles);
  TraceThenRays source(machine, in_trace);
  CycleHooks hooks;
  if (machine.stalled) hooks.stalls = &machine.stalls;
  const Workload work = machine.work();
  CycleMachine hosted(work, machine.architecture, memory, &source, hooks);
  constexpr Cycle kMost = 10'000'000;
  for (Cycle now = 0; !hosted.done() && now < kMost;) {
    for (const RandomMemory::Answer& answer : memory.answers())
      hosted.answer(answer.number, answer.response, 0, 0);
    memory.answers().clear();
    now += hosted.window();
    hosted.advance(now);
  }
  Ran ran;
  for (uint32_t k = 0; k < machine.rays.size(); ++k) ran.completed.push_back(hosted.timing(k).completed);
  ran.counters = hosted.outcome(true, true, nullptr).measurements.counters.all();
  return ran;
}

TEST(RaySource, HoweverTheSameRaysComeTheMachineDoesTheSame) {
  int rays = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    RandomMachine machine = random_machine(seed, 120);
    machine.architecture.ray_dispatch.order = DispatchOrder::kScanline;
    // In the machine's order, which a trace is brought into and single rays come in.
    const std::vector<uint32_t> order = dispatch_order(
        machine.pixels, machine.width, DispatchOrder::kScanline, machine.architecture.ray_dispatch.tile_size);
    const std::vector<MachineRay> by_trace = machine.rays;
    const std::vector<uint32_t> pixels = machine.pixels;
    for (size_t k = 0; k < order.size(); ++k) {
      machine.rays[k] = by_trace[order[k]];
      machine.pixels[k] = pixels[order[k]];
    }
    const Ran alone = run(machine, 0);
    EXPECT_EQ(run(machine, machine.rays.size()), alone) << describe(machine);
    EXPECT_EQ(run(machine, machine.rays.size() / 2), alone) << describe(machine);
    rays += static_cast<int>(machine.rays.size());
  }
  EXPECT_GT(rays, 2000);
}

}  // namespace
}  // namespace cuesta::twins
