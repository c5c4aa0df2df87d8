#include <gtest/gtest.h>

#include <vector>

#include "tests/twins/height_l1_twin.h"

// By hand, from the rules of height_l1: what a lookup in c may see is what happened up to c - 1.

namespace cuesta::twins {
namespace {

using Answer = HeightL1Twin::Answer;

/// One height_l1 of `sets` x `ways` lines; lookups, fills and replays by hand, cycle by cycle.
struct Bench {
  Bench(int sets, int ways, int mshrs) : unit({sets * ways * 16, 16, ways, mshrs}, 0, stalls) {}

  Answer lookup(int ray, uint64_t line) {
    const Answer answer = unit.lookup(ray, line);
    end_cycle();
    return answer;
  }
  void fill(int mshr) {
    unit.land(mshr);
    end_cycle();
  }
  int replay() {
    const int ray = unit.take_replay();
    end_cycle();
    return ray;
  }
  /// Miss, fill, replay: the line is there, and the MSHR free.
  void bring(int ray, uint64_t line) {
    ASSERT_EQ(lookup(ray, line), Answer::kAllocated);
    fill(sent.back().mshr);
    ASSERT_EQ(replay(), ray);
  }
  void end_cycle() {
    if (const auto request = unit.evaluate_request(cycle)) sent.push_back(*request);
    unit.commit();
    ++cycle;
  }

  PortStalls stalls;
  HeightL1Twin unit;
  Cycle cycle = 0;
  std::vector<HeightL1Twin::Request> sent;
};

TEST(HeightL1, MergesTwoMissesToOneLine) {
  Bench l1(4, 2, 4);
  EXPECT_EQ(l1.lookup(7, 100), Answer::kAllocated);
  EXPECT_EQ(l1.lookup(8, 100), Answer::kMerged);
  ASSERT_EQ(l1.sent.size(), 1u);
  EXPECT_EQ(l1.sent[0].line, 100u);
  EXPECT_EQ(l1.sent[0].owner, 7);
  l1.fill(l1.sent[0].mshr);
  EXPECT_EQ(l1.replay(), 7);
  EXPECT_TRUE(l1.unit.replay_ready());
  EXPECT_EQ(l1.replay(), 8);
  EXPECT_FALSE(l1.unit.replay_ready());
}

TEST(HeightL1, ALookupInTheCycleOfTheFillMergesAndTheNextHits) {
  Bench l1(4, 2, 4);
  l1.lookup(1, 100);
  l1.unit.land(0);
  EXPECT_FALSE(l1.unit.replay_ready());
  EXPECT_EQ(l1.lookup(2, 100), Answer::kMerged);
  EXPECT_TRUE(l1.unit.replay_ready());
  EXPECT_EQ(l1.lookup(3, 100), Answer::kHit);
  EXPECT_EQ(l1.replay(), 1);
  EXPECT_EQ(l1.replay(), 2);
}

TEST(HeightL1, TheRequestLeavesInTheCycleOfItsMiss) {
  Bench l1(4, 2, 4);
  EXPECT_EQ(l1.unit.lookup(1, 5), Answer::kAllocated);
  const auto request = l1.unit.evaluate_request(0);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->line, 5u);
}

TEST(HeightL1, RequestsLeaveInOrderOneACycleWhenThePortOpens) {
  Bench l1(4, 2, 4);
  l1.stalls = {3, {}};
  l1.stalls.per_mille[static_cast<int>(Port::kMemoryRequest)] = 700;
  std::vector<Cycle> free;
  for (Cycle c = 0; free.size() < 3; ++c) {
    if (!l1.stalls.blocked(Port::kMemoryRequest, 0, c)) free.push_back(c);
  }
  // Seed 3 blocks the first cycles; all three misses stand in line behind them.
  ASSERT_GE(free[0], 2);
  std::vector<Cycle> left;
  for (Cycle c = 0; left.size() < 3; ++c) {
    if (c < 3) l1.unit.lookup(static_cast<int>(c), static_cast<uint64_t>(10 + c));
    if (const auto request = l1.unit.evaluate_request(c)) {
      EXPECT_EQ(request->line, 10 + left.size());
      left.push_back(c);
    }
    l1.unit.commit();
  }
  EXPECT_EQ(left, free);
}

TEST(HeightL1, ReplacesTheLeastRecentlyUsedWay) {
  Bench l1(1, 3, 1);
  l1.bring(1, 10);
  l1.bring(2, 11);
  l1.bring(3, 12);
  EXPECT_EQ(l1.lookup(4, 10), Answer::kHit);  // order of use: 11, 12, 10
  l1.bring(5, 13);                            // in place of 11: 12, 10, 13
  EXPECT_EQ(l1.lookup(6, 12), Answer::kHit);  // 10, 13, 12
  l1.bring(7, 14);                            // in place of 10: 13, 12, 14
  EXPECT_EQ(l1.lookup(8, 13), Answer::kHit);
  EXPECT_EQ(l1.lookup(8, 12), Answer::kHit);
  EXPECT_EQ(l1.lookup(8, 14), Answer::kHit);
  EXPECT_EQ(l1.lookup(9, 10), Answer::kAllocated);
}

TEST(HeightL1, NeitherFillNorReplayCountsAsUse) {
  Bench l1(1, 2, 2);
  EXPECT_EQ(l1.lookup(1, 10), Answer::kAllocated);  // way 0
  l1.bring(2, 11);                                  // way 1, used after way 0
  l1.fill(0);                                       // 10 lands and is replayed last
  EXPECT_EQ(l1.replay(), 1);
  EXPECT_EQ(l1.lookup(3, 12), Answer::kAllocated);  // in place of 10 nevertheless
  l1.fill(0);
  EXPECT_EQ(l1.lookup(4, 11), Answer::kHit);
  EXPECT_EQ(l1.lookup(5, 12), Answer::kHit);
  EXPECT_EQ(l1.lookup(6, 10), Answer::kAllocated);
}

TEST(HeightL1, LinesOfOtherSetsDoNotMeet) {
  Bench l1(2, 1, 1);
  l1.bring(1, 10);
  l1.bring(2, 11);
  EXPECT_EQ(l1.lookup(3, 10), Answer::kHit);
  l1.bring(4, 12);  // set 0: in place of 10
  EXPECT_EQ(l1.lookup(5, 11), Answer::kHit);
  EXPECT_EQ(l1.lookup(6, 10), Answer::kAllocated);
}

TEST(HeightL1, AWayChosenAsVictimCountsAsInUse) {
  Bench l1(1, 2, 3);
  EXPECT_EQ(l1.lookup(1, 10), Answer::kAllocated);  // way 0
  EXPECT_EQ(l1.lookup(2, 11), Answer::kAllocated);  // way 1, although way 0 is still invalid
  l1.fill(1);
  l1.fill(0);
  EXPECT_EQ(l1.lookup(3, 10), Answer::kHit);
  EXPECT_EQ(l1.lookup(4, 11), Answer::kHit);
}

TEST(HeightL1, AVictimBecomesMostRecentlyUsedWhenItIsChosen) {
  Bench l1(1, 2, 2);
  l1.bring(1, 10);                                  // way 0
  l1.bring(2, 11);                                  // way 1
  EXPECT_EQ(l1.lookup(3, 12), Answer::kAllocated);  // way 0
  EXPECT_EQ(l1.lookup(4, 13), Answer::kAllocated);  // way 1, not way 0 again
  l1.fill(0);
  l1.fill(1);
  EXPECT_EQ(l1.lookup(5, 12), Answer::kHit);
  EXPECT_EQ(l1.lookup(6, 13), Answer::kHit);
}

TEST(HeightL1, AVictimStaysReadableUntilItsFillLands) {
  Bench l1(1, 1, 2);
  l1.bring(1, 10);
  EXPECT_EQ(l1.lookup(2, 11), Answer::kAllocated);
  EXPECT_EQ(l1.lookup(3, 10), Answer::kHit);
  l1.unit.land(l1.sent.back().mshr);
  EXPECT_EQ(l1.lookup(4, 10), Answer::kHit);  // the very cycle of the fill
  EXPECT_EQ(l1.lookup(5, 11), Answer::kHit);
  EXPECT_EQ(l1.lookup(6, 10), Answer::kAllocated);
}

TEST(HeightL1, AMissWithoutAFreeMshrGoesToTheRetryFifoAndComesBackInOrder) {
  Bench l1(4, 1, 1);
  EXPECT_EQ(l1.lookup(1, 10), Answer::kAllocated);
  EXPECT_EQ(l1.lookup(2, 11), Answer::kRefused);
  EXPECT_EQ(l1.lookup(3, 12), Answer::kRefused);
  EXPECT_EQ(l1.lookup(4, 10), Answer::kMerged);  // a merge needs no MSHR of its own
  EXPECT_FALSE(l1.unit.retry_ready());
  l1.fill(0);
  EXPECT_EQ(l1.replay(), 1);
  EXPECT_FALSE(l1.unit.retry_ready());  // one waiter left: the MSHR is not free
  EXPECT_EQ(l1.replay(), 4);
  ASSERT_TRUE(l1.unit.retry_ready());
  EXPECT_EQ(l1.unit.take_retry(), 2);
  EXPECT_EQ(l1.lookup(2, 11), Answer::kAllocated);
  EXPECT_FALSE(l1.unit.retry_ready());
  l1.fill(0);
  EXPECT_EQ(l1.replay(), 2);
  EXPECT_EQ(l1.unit.take_retry(), 3);
}

TEST(HeightL1, AnMshrIsFreeInTheCycleAfterItsLastReplay) {
  Bench l1(4, 1, 1);
  l1.lookup(1, 10);
  l1.fill(0);
  EXPECT_EQ(l1.unit.take_replay(), 1);
  EXPECT_EQ(l1.lookup(2, 11), Answer::kRefused);  // the cycle of the last replay
  EXPECT_EQ(l1.lookup(3, 12), Answer::kAllocated);
}

TEST(HeightL1, FillsAreReplayedInTheOrderOfLanding) {
  Bench l1(4, 1, 2);
  l1.lookup(1, 10);
  l1.lookup(2, 11);
  l1.fill(1);
  l1.fill(0);
  EXPECT_EQ(l1.replay(), 2);
  EXPECT_EQ(l1.replay(), 1);
}

}  // namespace
}  // namespace cuesta::twins
