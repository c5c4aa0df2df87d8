#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "sim/machine/cycle_machine.h"
#include "tests/twins/random_machine.h"

// The port log and the counters of a machine that stands in the middle of a run, on random machines with random
// stalls: what they say may not depend on how the machine is moved on.

namespace cuesta::twins {
namespace {

constexpr uint64_t kMachines = 150;
constexpr int kRays = 60;

struct Bench {
  explicit Bench(const RandomMachine& random, Cycle step)
      : machine(random.work(), random.architecture, hooks(random)) {
    machine.step_by(step);
  }
  CycleHooks hooks(const RandomMachine& random) {
    CycleHooks hooks;
    if (random.stalled) hooks.stalls = &random.stalls;
    hooks.port_logs = &logs;
    return hooks;
  }
  /// Those that are exact in the middle of a run.
  std::map<std::string, int64_t> counters() const {
    std::map<std::string, int64_t> all = machine.counters().all();
    std::erase_if(all, [](const auto& counter) {
      return counter.first == "ray_dispatch.rays" || counter.first.starts_with("ray_setup[");
    });
    return all;
  }

  std::vector<PortLog> logs;
  CycleMachine machine;
};

/// Entries of cycles below `end`.
template <class T>
size_t before(const std::vector<T>& log, Cycle end) {
  return static_cast<size_t>(std::ranges::find_if(log, [end](const T& entry) { return entry.cycle >= end; }) -
                             log.begin());
}

TEST(PortLog, CountersAndPortsInTheMiddleOfARunDoNotDependOnTheStep) {
  for (uint64_t seed = 1; seed <= kMachines; ++seed) {
    const RandomMachine random = random_machine(seed, kRays);
    Bench one(random, 1), many(random, kNever);
    const Cycle block = 1 + static_cast<Cycle>(seed * 37 % 200);
    for (Cycle end = block; !many.machine.done(); end += block) {
      one.machine.advance(end);
      many.machine.advance(end);
      ASSERT_EQ(one.counters(), many.counters()) << "before cycle " << end << "\n" << describe(random);
      for (size_t p = 0; p < one.logs.size(); ++p) {
        const PortLog &a = one.logs[p], &b = many.logs[p];
        ASSERT_EQ(before(a.hits, end), before(b.hits, end)) << end << "\n" << describe(random);
        ASSERT_EQ(before(a.requests, end), before(b.requests, end)) << end << "\n" << describe(random);
        ASSERT_EQ(before(a.entries, end), before(b.entries, end)) << end << "\n" << describe(random);
      }
    }
    for (size_t p = 0; p < one.logs.size(); ++p) {
      ASSERT_EQ(one.logs[p].hits, many.logs[p].hits) << describe(random);
      ASSERT_EQ(one.logs[p].requests, many.logs[p].requests) << describe(random);
      ASSERT_EQ(one.logs[p].entries, many.logs[p].entries) << describe(random);
    }
  }
}

TEST(PortLog, HoldsEveryHitAtItsCompletionEveryMissAndEveryRayThatEntered) {
  for (uint64_t seed = 1; seed <= kMachines; ++seed) {
    const RandomMachine random = random_machine(seed, kRays);
    Bench bench(random, kNever);
    ASSERT_TRUE(bench.machine.run({}));
    CycleDetail detail;
    const Outcome outcome = bench.machine.outcome(true, false, &detail);
    size_t hits = 0;
    for (size_t p = 0; p < bench.logs.size(); ++p) {
      const PortLog& log = bench.logs[p];
      const std::string index = "[" + std::to_string(p) + "].";
      const Counters& counters = outcome.measurements.counters;
      EXPECT_EQ(static_cast<int64_t>(log.hits.size()), counters.get("traverse" + index + "rays"));
      EXPECT_EQ(static_cast<int64_t>(log.requests.size()), counters.get("height_l1" + index + "misses"));
      EXPECT_EQ(static_cast<int64_t>(log.entries.size()), counters.get("ray_setup" + index + "rays"));
      hits += log.hits.size();
      for (const PortLog::Hit& hit : log.hits) {
        const auto found = std::ranges::find(outcome.hits, hit.record.ray_id, &HitRecord::ray_id);
        ASSERT_NE(found, outcome.hits.end());
        EXPECT_EQ(hit.record, *found);
        EXPECT_EQ(hit.cycle, detail.timing[static_cast<size_t>(found - outcome.hits.begin())].completed);
      }
      EXPECT_TRUE(std::ranges::is_sorted(log.hits, std::less_equal<>{}, &PortLog::Hit::cycle));
      EXPECT_TRUE(std::ranges::is_sorted(log.requests, std::less_equal<>{}, &PortLog::Request::cycle));
      EXPECT_TRUE(std::ranges::is_sorted(log.entries, std::less_equal<>{}, &PortLog::Entry::cycle));
    }
    EXPECT_EQ(hits, random.rays.size());
  }
}

}  // namespace
}  // namespace cuesta::twins
