#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

#include "tests/twins/dram_twin.h"

// By hand, from the rules of dram. Unless said otherwise: tRCD = tRP = tCL = 11, tRAS = 28, 64 bytes = 8 bus clocks,
// memory clock = machine clock, 10 cycles each way; rows of 2048 bytes, 8 banks: address 2048 is bank 1, 16384
// the second row of bank 0.

namespace cuesta::twins {
namespace {

DramParameters parameters() {
  DramParameters p;
  p.clock_num = p.clock_den = 1;
  return p;
}

struct Sending {
  Cycle cycle;
  uint64_t address;
  bool write = false;
  int pipeline = 0;
};

/// The cycle in which the answer to each of `requests` lands.
std::vector<Cycle> landings(const DramParameters& p, const std::vector<Sending>& requests,
                            const PortStalls& stalls = {}) {
  DramTwin dram(p, 64, 64, 2, stalls);
  std::vector<Cycle> landed(requests.size(), -1);
  for (Cycle cycle = 0; cycle < 2000; ++cycle) {
    for (int pipeline = 0; pipeline < 2; ++pipeline) {
      if (const auto tag = dram.landing_read(pipeline, cycle)) landed[static_cast<size_t>(*tag)] = cycle;
      for (int left = dram.landing_writes(pipeline, cycle); left > 0; --left) {
        // Bursts have no tag: the oldest of the pipeline that is open.
        for (size_t r = 0; r < requests.size(); ++r) {
          if (requests[r].write && requests[r].pipeline == pipeline && landed[r] < 0) {
            landed[r] = cycle;
            break;
          }
        }
      }
    }
    for (size_t r = 0; r < requests.size(); ++r) {
      if (requests[r].cycle == cycle) {
        dram.send({requests[r].pipeline, requests[r].write, static_cast<int>(r), requests[r].address, 0},
                  cycle);
      }
    }
    dram.evaluate(cycle);
  }
  EXPECT_TRUE(dram.idle());
  return landed;
}

TEST(Dram, AFirstReadWaitsForActivateColumnAndBus) {
  // Arrives 10; activate 10, column 21, data 32 to 40; lands 50.
  EXPECT_EQ(landings(parameters(), {{0, 0}}), (std::vector<Cycle>{50}));
}

TEST(Dram, ARowHitFollowsOnTheBusWithoutAGap) {
  // Column max(11, ready = 32 - 11 + 8 = 29), data 40 to 48.
  EXPECT_EQ(landings(parameters(), {{0, 0}, {1, 64}}), (std::vector<Cycle>{50, 58}));
}

TEST(Dram, ALateRowHitWaitsForColumnLatencyOnly) {
  // Arrives 110: column 110, data 121 to 129.
  EXPECT_EQ(landings(parameters(), {{0, 0}, {100, 2047}}), (std::vector<Cycle>{50, 139}));
}

TEST(Dram, ARowConflictWaitsForTRASThenPrechargesAndActivates) {
  // Precharge max(11, 29, 10 + 28) = 38, activate 49, column 60, data 71 to 79.
  EXPECT_EQ(landings(parameters(), {{0, 0}, {1, 16384}}), (std::vector<Cycle>{50, 89}));
  // Late: precharge 110, activate 121, column 132, data 143 to 151.
  EXPECT_EQ(landings(parameters(), {{0, 0}, {100, 16384}}), (std::vector<Cycle>{50, 161}));
  // tRAS shorter than the bank's readiness: precharge 29, activate 40, column 51, data 62 to 70.
  DramParameters p = parameters();
  p.tRAS = 5;
  EXPECT_EQ(landings(p, {{0, 0}, {1, 16384}}), (std::vector<Cycle>{50, 80}));
}

TEST(Dram, BanksOverlapAndShareTheBus) {
  // Bank 1: activate 11, column 22, data max(33, 40) to 48.
  EXPECT_EQ(landings(parameters(), {{0, 0}, {1, 2048}}), (std::vector<Cycle>{50, 58}));
  // Its next column: ready = 40 - 11 + 8 = 37, data max(48, 48) to 56.
  EXPECT_EQ(landings(parameters(), {{0, 0}, {1, 2048}, {2, 2112}}), (std::vector<Cycle>{50, 58, 66}));
}

TEST(Dram, TheBusServesInOrderOfArrivalEvenBehindAConflict) {
  // The conflict's data are at 71 to 79; bank 1, ready long before, goes after it: 79 to 87.
  EXPECT_EQ(landings(parameters(), {{0, 0}, {1, 16384}, {2, 2048}}), (std::vector<Cycle>{50, 89, 97}));
}

TEST(Dram, ChannelsHaveTheirOwnBus) {
  DramParameters p = parameters();
  p.channels = 2;  // address 64 lies in channel 1
  EXPECT_EQ(landings(p, {{0, 0}, {1, 64}}), (std::vector<Cycle>{50, 51}));
}

TEST(Dram, ClockRatioRoundsArrivalAndAnswerUp) {
  DramParameters p = parameters();
  p.clock_num = 8;  // arrives at clock 16: data 38 to 46; 46 * 5 / 8 = 28.75
  p.clock_den = 5;
  EXPECT_EQ(landings(p, {{0, 0}}), (std::vector<Cycle>{39}));
  EXPECT_EQ(landings(p, {{1, 0}}), (std::vector<Cycle>{40}));  // clock 17.6: 18; 48 * 5 / 8 = 30
  p.clock_num = 3;  // arrives at clock 4.3: 5; data 27 to 35; 35 * 7 / 3 = 81.7
  p.clock_den = 7;
  EXPECT_EQ(landings(p, {{0, 0}}), (std::vector<Cycle>{92}));
}

TEST(Dram, TwoFillsOfOneL1NeverLandInOneCycle) {
  DramParameters p = parameters();
  p.channels = 3;
  // Channel 0: 50 and 58; channel 1, sent in 8: 58 as well; channel 2, sent in 9: 59. In order of service.
  EXPECT_EQ(landings(p, {{0, 0}, {1, 3 * 64}, {8, 64}, {9, 128}}), (std::vector<Cycle>{50, 58, 59, 60}));
}

TEST(Dram, FillsOfTwoL1sMayLandInOneCycle) {
  DramParameters p = parameters();
  p.channels = 2;
  EXPECT_EQ(landings(p, {{0, 0, false, 0}, {0, 64, false, 1}}), (std::vector<Cycle>{50, 50}));
}

TEST(Dram, AServedFirstFillTakesItsCycleBeforeALaterOneThatIsReadyEarlier) {
  // Ready 89 (conflict) and, in channel 1, 88: each in its own cycle. With the port blocked in 88: the one served
  // first takes 89, the other waits.
  DramParameters p = parameters();
  p.channels = 2;
  const std::vector<Sending> requests = {{0, 0}, {1, 2 * 16384}, {38, 64}};
  EXPECT_EQ(landings(p, requests), (std::vector<Cycle>{50, 89, 88}));
  PortStalls stalls{0, {}};
  stalls.per_mille[static_cast<int>(Port::kMemoryResponse)] = 300;
  auto blocked = [&](Cycle c) { return stalls.blocked(Port::kMemoryResponse, 0, c); };
  while (blocked(50) || !blocked(88) || blocked(89) || blocked(90)) ++stalls.seed;
  EXPECT_EQ(landings(p, requests, stalls), (std::vector<Cycle>{50, 89, 90}));
}

TEST(Dram, AWriteIsAcknowledgedLikeAReadAndNeverBooksThePort) {
  EXPECT_EQ(landings(parameters(), {{0, 0, true}}), (std::vector<Cycle>{50}));
  DramParameters p = parameters();
  p.channels = 2;
  EXPECT_EQ(landings(p, {{0, 0, true}, {0, 64, false}}), (std::vector<Cycle>{50, 50}));
}

TEST(Dram, ABurstAndALineThatDifferShareOneGranule) {
  // Lines of 32, bursts of 128 on an 8-byte bus: 4 and 16 clocks. Granule 128, so 4 lines share a channel.
  DramParameters p = parameters();
  p.channels = 2;
  const PortStalls stalls;
  DramTwin dram(p, 32, 128, 1, stalls);
  std::vector<std::pair<Cycle, int>> landed;
  for (Cycle cycle = 0; cycle < 200; ++cycle) {
    if (const auto tag = dram.landing_read(0, cycle)) landed.emplace_back(cycle, *tag);
    if (dram.landing_writes(0, cycle) > 0) landed.emplace_back(cycle, -1);
    if (cycle == 0) dram.send({0, false, 0, 96, 0}, cycle);  // channel 0: data 32 to 36
    if (cycle == 0) dram.send({0, true, 0, 128, 0}, cycle);  // channel 1: data 32 to 48
    if (cycle == 1) dram.send({0, false, 1, 32, 0}, cycle);  // channel 0, same row: data 36 to 40
    dram.evaluate(cycle);
  }
  EXPECT_EQ(landed, (std::vector<std::pair<Cycle, int>>{{46, 0}, {50, 1}, {58, -1}}));
}

}  // namespace
}  // namespace cuesta::twins
