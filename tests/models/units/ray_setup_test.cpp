#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tests/twins/ray_setup_twin.h"

namespace cuesta::twins {
namespace {

/// Runs one ray_setup: rays sent in the cycles `sent`, a taker that takes what it may from `takes_from` on.
struct Times {
  std::vector<Cycle> entered, taken;
};

Times run(const RaySetupParameters& parameters, int dispatch_latency, const std::vector<Cycle>& sent,
          Cycle takes_from) {
  const PortStalls stalls;
  RaySetupTwin unit(parameters, dispatch_latency, 0, stalls);
  Times times;
  for (Cycle cycle = 0; cycle < 500; ++cycle) {
    const auto here = std::find(sent.begin(), sent.end(), cycle);
    if (here != sent.end()) unit.receive(static_cast<int>(here - sent.begin()), cycle);
    const auto offered = unit.offered(cycle);
    if (offered && cycle >= takes_from) {
      EXPECT_EQ(*offered, static_cast<int>(times.taken.size()));
      unit.take();
      times.taken.push_back(cycle);
    }
    if (unit.evaluate(cycle)) times.entered.push_back(cycle);
    unit.commit();
  }
  EXPECT_TRUE(unit.empty());
  return times;
}

TEST(RaySetup, ARayEntersDispatchLatencyAfterItWasSent) {
  EXPECT_EQ(run({24, 4, 8}, 1, {0}, 0).entered, (std::vector<Cycle>{1}));
  EXPECT_EQ(run({24, 4, 8}, 4, {3}, 0).entered, (std::vector<Cycle>{7}));
}

TEST(RaySetup, RaysEnterOnePerInterval) {
  EXPECT_EQ(run({24, 4, 8}, 4, {0, 1, 2}, 0).entered, (std::vector<Cycle>{4, 8, 12}));
  EXPECT_EQ(run({24, 1, 8}, 4, {0, 1, 2}, 0).entered, (std::vector<Cycle>{4, 5, 6}));
  // A pause longer than the interval is not made up for.
  EXPECT_EQ(run({24, 4, 8}, 4, {0, 10, 11}, 0).entered, (std::vector<Cycle>{4, 14, 18}));
}

TEST(RaySetup, TraverseMayTakeARayLatencyCyclesAfterItsEntry) {
  EXPECT_EQ(run({24, 4, 8}, 4, {0, 1}, 0).taken, (std::vector<Cycle>{28, 32}));
  EXPECT_EQ(run({1, 1, 8}, 1, {0, 1}, 0).taken, (std::vector<Cycle>{2, 3}));
}

TEST(RaySetup, AFullUnitLetsTheNextEnterInTheCycleAfterATake) {
  // Entries 4, 6; the third waits for the first to be taken at 50: entry 51, the fourth after the take at 51.
  const Times times = run({10, 2, 2}, 4, {0, 1, 2, 3}, 50);
  EXPECT_EQ(times.entered, (std::vector<Cycle>{4, 6, 51, 53}));
  EXPECT_EQ(times.taken, (std::vector<Cycle>{50, 51, 61, 63}));
}

TEST(RaySetup, ADepthOfOneMakesEveryRayWaitForTheTakeBefore) {
  const Times times = run({10, 1, 1}, 1, {0, 1, 2}, 0);
  EXPECT_EQ(times.entered, (std::vector<Cycle>{1, 12, 23}));
  EXPECT_EQ(times.taken, (std::vector<Cycle>{11, 22, 33}));
}

}  // namespace
}  // namespace cuesta::twins
