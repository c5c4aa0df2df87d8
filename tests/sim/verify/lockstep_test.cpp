#include "sim/verify/lockstep/lockstep.h"

#include <gtest/gtest.h>

#include "sim/machine/cycle_machine.h"
#include "sim/verify/lockstep/random_rtl_case.h"
#include "sim/verify/lockstep/rig.h"
#include "sim/verify/lockstep/shrink.h"

// The comparison itself, model against model: equal where nothing differs, and with one thing changed on one side
// the first difference in the cycle, unit and field that follow from the timing rules.

namespace cuesta {
namespace {

constexpr Cycle kDispatch = 5, kSetup = 9, kMemory = 40, kStages = 6;
constexpr Cycle kLookup = kDispatch + kSetup;       // of a ray that is sent in cycle 0
constexpr Cycle kLands = kLookup + kMemory;         // its miss leaves in that very cycle
constexpr Cycle kCompletes = kLands + 1 + kStages;  // replayed in the next cycle, and once round the pipe

const LockstepSide kPlain{"left", {}};

/// One ray straight down onto a map of one texel: one step, one miss.
LockstepCase one_ray() {
  LockstepCase one;
  Architecture& a = one.machine.architecture;
  a.ray_dispatch.latency_cycles = kDispatch;
  a.ray_setup.latency_cycles = kSetup;
  a.traverse.stages = kStages;
  a.dram.request_latency_cycles = a.dram.response_latency_cycles = 3;
  one.machine.memory = MemoryTiming{7, kMemory, kMemory, 0, -1, 0};
  one.pyramid = std::make_shared<Pyramid>(build_max_pyramid(HeightGrid{1, 1, 8, {100}}));
  TracedRay ray;
  ray.id = 4711;
  ray.origin[0] = ray.origin[1] = 0.5;
  ray.origin[2] = 1;
  ray.direction[2] = -1;
  one.rays = {ray};
  return one;
}

Difference first_difference(const LockstepCase& one, const LockstepSide& right) {
  const LockstepResult result = run_lockstep(one, kPlain, right);
  return result.equal() ? Difference{} : result.differences.front();
}

TEST(Lockstep, EqualMachinesDifferNowhereAndTakeTheCyclesOfTheMachineAlone) {
  int outside = 0, stalled = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const LockstepCase one = random_rtl_case({}, seed, 120);
    const LockstepResult result = run_lockstep(one, kPlain, {"right", {}});
    ASSERT_TRUE(result.equal()) << report(result.differences, {"left", "right"}) << describe(one);
    ASSERT_FALSE(result.stuck) << describe(one);
    EXPECT_EQ(result.rays, one.rays.size());
    EXPECT_FALSE(result.stopped);
    outside += one.machine.memory.has_value();
    stalled += text_of(one.machine.stalls) != text_of(PortStalls{one.machine.stalls.seed, {}});
    if (one.machine.memory) continue;
    const LockstepWork work(one, one.machine);
    const Workload load = work.workload(one, one.machine);
    CycleHooks hooks;
    hooks.stalls = &one.machine.stalls;
    const Outcome alone = run_cycle_detailed(load, one.machine.architecture, {}, hooks, nullptr);
    EXPECT_EQ(result.cycles, alone.measurements.counters.get("machine.cycles"));
    EXPECT_EQ(static_cast<int64_t>(result.requests), alone.measurements.counters.sum("height_l1", "misses"));
  }
  EXPECT_GE(outside, 20);
  EXPECT_GE(stalled, 30);
}

TEST(Lockstep, ALateAnswerIsFoundInTheCycleInWhichItShouldHaveLanded) {
  const Difference found = first_difference(one_ray(), {"right", [](LockstepMachine& m) {
                                                          m.memory->late_request = 0;
                                                          m.memory->late_cycles = 11;
                                                        }});
  EXPECT_EQ(found.cycle, kLands);
  EXPECT_EQ(found.unit, "height_l1[0]");
  EXPECT_EQ(found.field, "fills");
  EXPECT_EQ(found.values[0], "1 (0x1)");
  EXPECT_EQ(found.values[1], "0 (0x0)");
}

TEST(Lockstep, ASlowerRaySetupIsFoundInTheCycleInWhichTraverseTakesTheRay) {
  const LockstepResult result = run_lockstep(
      one_ray(), kPlain, {"right", [](LockstepMachine& m) { m.architecture.ray_setup.latency_cycles += 1; }});
  ASSERT_FALSE(result.equal());
  EXPECT_EQ(result.differences[0].cycle, kLookup);
  EXPECT_EQ(result.differences[0].unit, "ray_setup[0]");
  EXPECT_EQ(result.differences[0].field, "rays_before_traverse");
  // What follows stands behind it: the ray in its context, its slot, its miss and its request.
  std::vector<std::string> others;
  for (const Difference& d : result.differences) {
    EXPECT_EQ(d.cycle, kLookup);
    others.push_back(d.unit + "." + d.field);
  }
  EXPECT_LT(std::ranges::find(others, "traverse[0].contexts"),
            std::ranges::find(others, "height_l1[0].request"));
  EXPECT_LT(std::ranges::find(others, "height_l1[0].request"),
            std::ranges::find(others, "height_l1[0].misses"));
  EXPECT_NE(std::ranges::find(others, "height_l1[0].misses"), others.end());
}

TEST(Lockstep, AWrongTimeOfAHitIsFoundInTheCycleOfItsCompletionWithTheRay) {
  const LockstepCase one = one_ray();
  const LockstepResult result = run_lockstep(
      one, kPlain, {"right", [](LockstepMachine& m) { m.architecture.traverse.mantissa_bits = 13; }});
  ASSERT_EQ(result.differences.size(), 1u) << report(result.differences, {"left", "right"});
  const Difference& found = result.differences[0];
  EXPECT_EQ(found.cycle, kCompletes);
  EXPECT_EQ(found.unit, "traverse[0]");
  EXPECT_EQ(found.field, "hit.t");
  // 155 LSBs down; one bit more of the reciprocal's mantissa halves the unit of time.
  EXPECT_EQ(std::stoll(found.values[1]), 2 * std::stoll(found.values[0]));
  EXPECT_NE(found.ray.find("pixel number 0"), std::string::npos) << found.ray;
}

TEST(Lockstep, AnEarlierEntryIsNamedAtItsPort) {
  const Difference found = first_difference(
      one_ray(), {"right", [](LockstepMachine& m) { m.architecture.ray_dispatch.latency_cycles -= 1; }});
  EXPECT_EQ(found.cycle, kDispatch - 1);
  EXPECT_EQ(found.unit, "ray_setup[0]");
  EXPECT_EQ(found.field, "entry");
  EXPECT_EQ(found.values[0], "none");
}

TEST(Lockstep, ARequestIsDecodedToItsTexel) {
  LockstepCase one = one_ray();
  one.pyramid = std::make_shared<Pyramid>(build_max_pyramid(HeightGrid{2, 2, 8, {1, 2, 3, 4}}));
  one.machine.architecture.height_l1.line_bytes = 64;
  const Difference found =
      first_difference(one, {"right", [](LockstepMachine& m) { m.schedule.start = StartRule::kLeaf; }});
  // Levels begin on multiples of 64 bytes: level 0 at 0, level 1 at 64.
  EXPECT_EQ(found.cycle, kLookup);
  EXPECT_EQ(found.unit + "." + found.field, "height_l1[0].request.address");
  EXPECT_EQ(found.values[0], "address 64 (0x40), from level 1, i 0, j 0 on");
  EXPECT_EQ(found.values[1], "address 0 (0x0), from level 0, i 0, j 0 on");
}

TEST(Lockstep, EveryParameterOfTheHardwareIsSeen) {
  const std::pair<const char*, void (*)(Architecture&)> changes[] = {
      {"ray_setup.interval_cycles", [](Architecture& a) { a.ray_setup.interval_cycles += 1; }},
      {"ray_setup.queue_depth", [](Architecture& a) { a.ray_setup.queue_depth = 1; }},
      {"traverse.stages", [](Architecture& a) { a.traverse.stages += 1; }},
      {"traverse.contexts", [](Architecture& a) { a.traverse.contexts = a.traverse.stages; }},
      {"height_l1.ways", [](Architecture& a) { a.height_l1.ways = 1; }},
      {"height_l1.mshrs", [](Architecture& a) { a.height_l1.mshrs = 1; }},
      {"height_l1.size_bytes", [](Architecture& a) { a.height_l1.size_bytes /= 4; }},
  };
  for (const auto& [name, change] : changes) {
    bool seen = false;
    for (uint64_t seed = 1; seed <= 12 && !seen; ++seed) {
      RtlStructure structure;
      structure.architecture.height_l1 = {1024, 32, 4, 4};
      const LockstepCase one = random_rtl_case(structure, seed, 300);
      const LockstepSide right{"right", [turn = change](LockstepMachine& m) { turn(m.architecture); }};
      seen = !run_lockstep(one, kPlain, right, LockstepDepth::kWhether).equal();
    }
    EXPECT_TRUE(seen) << name;
  }
}

TEST(Lockstep, TheFirstCycleIsThatOfARunComparedCycleByCycle) {
  int differences = 0;
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const LockstepCase one = random_rtl_case({}, seed, 60);
    const LockstepSide right{"right", [](LockstepMachine& m) { m.architecture.height_l1.mshrs = 1; }};
    const LockstepResult result = run_lockstep(one, kPlain, right);
    if (result.equal()) continue;
    ++differences;
    // Up to the cycle before, nothing that anybody counts differs; in that cycle something does.
    const Cycle cycle = result.differences.front().cycle;
    LockstepMachine machines[2] = {one.machine, one.machine};
    right.change(machines[1]);
    const auto work = std::make_shared<LockstepWork>(one, one.machine);
    LockstepRig a(one, machines[0], work), b(one, machines[1], work);
    for (LockstepRig* rig : {&a, &b}) rig->step_by(1);
    auto text = [](LockstepRig& rig) {
      std::string all;
      const Counters counters = rig.machine().counters();
      for (const auto& [path, value] : counters.all()) all += path + std::to_string(value);
      for (int p = 0; p < rig.machine().pipelines(); ++p) {
        const PipelineFill fill = rig.machine().fill(p);
        all += " " + std::to_string(fill.mshrs) + " " + std::to_string(fill.retries);
      }
      return all;
    };
    for (Cycle end = 1; end <= cycle; ++end) {
      a.advance(end);
      b.advance(end);
    }
    EXPECT_EQ(text(a), text(b)) << "seed " << seed;
    a.advance(cycle + 1);
    b.advance(cycle + 1);
    EXPECT_NE(text(a), text(b)) << "seed " << seed;
  }
  EXPECT_GE(differences, 3);
}

TEST(Shrink, LeavesNoRayThatTheDifferenceDoesNotNeedAndSimplifiesTheMachine) {
  const LockstepSide right{"right", [](LockstepMachine& m) { m.architecture.height_l1.mshrs = 1; }};
  auto fails = [&](const LockstepCase& one) {
    return !run_lockstep(one, kPlain, right, LockstepDepth::kWhether).equal();
  };
  int shrunk = 0;
  for (uint64_t seed = 1; shrunk < 3 && seed < 30; ++seed) {
    const LockstepCase failing = random_rtl_case({}, seed, 120);
    if (failing.rays.size() < 30 || !fails(failing)) continue;
    ++shrunk;
    const ShrunkCase result = shrink(failing, fails, run_lockstep(failing, kPlain, right).rays);
    const LockstepCase& smallest = result.smallest;
    EXPECT_TRUE(result.complete);
    EXPECT_TRUE(fails(smallest));
    // Two rays that miss at the same time, or one with two requests... never more than a handful.
    EXPECT_LE(smallest.rays.size(), 4u) << describe(smallest);
    EXPECT_EQ(smallest.machine.architecture.machine.pipelines, 1);
    for (size_t k = 0; k < smallest.rays.size() && smallest.rays.size() > 1; ++k) {
      LockstepCase fewer = smallest;
      fewer.rays.erase(fewer.rays.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_FALSE(fails(fewer)) << "ray " << k << " is not needed";
    }
  }
  EXPECT_EQ(shrunk, 3);
}

TEST(Shrink, OfManyRaysOnlyThoseAboutTheDifferenceAreLookedAt) {
  // 20 times the same rays; only the last of all makes the difference.
  LockstepCase many = random_rtl_case({}, 5, 300);
  const std::vector<TracedRay> once = many.rays;
  for (int copy = 1; copy < 20; ++copy) many.rays.insert(many.rays.end(), once.begin(), once.end());
  for (size_t k = 0; k < many.rays.size(); ++k) many.rays[k].id = k;
  many.machine.memory = MemoryTiming{};  // rays come in the order of the trace
  const uint64_t last = many.rays.size() - 1;
  size_t rays_tried = 0;
  const ShrunkCase result = shrink(
      many,
      [&](const LockstepCase& one) {
        rays_tried += one.rays.size();
        return std::ranges::any_of(one.rays, [last](const TracedRay& ray) { return ray.id == last; });
      },
      last);
  EXPECT_EQ(result.smallest.rays.size(), 1u);
  EXPECT_LT(rays_tried, many.rays.size());
}

TEST(Shrink, StopsAfterSoManyRuns) {
  int runs = 0;
  const ShrunkCase result = shrink(
      random_rtl_case({}, 3, 200), [&](const LockstepCase&) { return ++runs > 0; }, 0, 5);
  EXPECT_EQ(runs, 5);
  EXPECT_EQ(result.runs, 5);
  EXPECT_FALSE(result.complete);
}

}  // namespace
}  // namespace cuesta
