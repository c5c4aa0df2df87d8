#include <gtest/gtest.h>

#include <vector>

#include "tests/twins/result_writer_twin.h"

namespace cuesta::twins {
namespace {

/// A writer behind a hit_queue; rays are pushed in given cycles, one a cycle.
struct Bench {
  Bench(int burst_bytes, int outstanding) : writer({burst_bytes, outstanding}, 0, stalls) {}

  /// One cycle; the number of records in the burst that leaves, 0: none leaves.
  int tick(int pushed, bool last = false, int acknowledged = 0) {
    for (int left = acknowledged; left > 0; --left) writer.acknowledge();
    const auto burst = writer.evaluate(cycle, queue, last && queue.empty());
    if (pushed >= 0) queue.push(pushed);
    queue.commit();
    writer.commit();
    ++cycle;
    if (burst) bursts.push_back(*burst);
    return burst ? burst->records : 0;
  }

  PortStalls stalls;
  HitQueueTwin queue{{8}};
  ResultWriterTwin writer;
  Cycle cycle = 0;
  std::vector<ResultWriterTwin::Burst> bursts;
};

TEST(ResultWriter, ARecordTravelsQueueBufferBurstInThreeCycles) {
  Bench b(32, 4);            // one record a burst
  EXPECT_EQ(b.tick(5), 0);   // pushed
  EXPECT_EQ(b.tick(-1), 0);  // taken
  EXPECT_EQ(b.tick(-1), 1);  // sent
}

TEST(ResultWriter, ABurstLeavesWhenItsBufferIsFullAndTakesNothingMeanwhile) {
  Bench b(64, 4);
  EXPECT_EQ(b.tick(0), 0);
  EXPECT_EQ(b.tick(1), 0);   // takes 0
  EXPECT_EQ(b.tick(2), 0);   // takes 1: full
  EXPECT_EQ(b.tick(3), 2);   // sends 0, 1; takes nothing: full at the end of the cycle before
  EXPECT_EQ(b.tick(-1), 0);  // takes 2
  EXPECT_EQ(b.tick(-1), 0);  // takes 3
  EXPECT_EQ(b.tick(-1), 2);
  ASSERT_EQ(b.bursts.size(), 2u);
  EXPECT_EQ(b.bursts[0].owner, 0);
  EXPECT_EQ(b.bursts[1].owner, 2);
  EXPECT_EQ(b.bursts[1].number, 1);
}

TEST(ResultWriter, TheLastBurstMayBePartial) {
  Bench b(128, 4);
  b.tick(0);
  b.tick(1, true);
  EXPECT_EQ(b.tick(-1, true), 0);  // takes 1: the queue was not empty
  EXPECT_EQ(b.tick(-1, true), 2);
  EXPECT_EQ(b.tick(-1, true), 0);
  EXPECT_FALSE(b.writer.idle());
  b.tick(-1, true, 1);
  EXPECT_TRUE(b.writer.idle());
}

TEST(ResultWriter, NothingIsSentWithoutRecords) {
  Bench b(64, 4);
  EXPECT_EQ(b.tick(-1, true), 0);
  EXPECT_EQ(b.tick(-1, true), 0);
  EXPECT_TRUE(b.writer.idle());
}

TEST(ResultWriter, APlaceAmongTheOutstandingIsFreeInTheCycleAfterItsAcknowledgement) {
  Bench b(32, 1);
  b.tick(0);
  b.tick(1);                 // takes 0
  EXPECT_EQ(b.tick(-1), 1);  // sends 0
  EXPECT_EQ(b.tick(-1), 0);  // takes 1
  EXPECT_EQ(b.tick(-1), 0);  // full, but one is outstanding
  EXPECT_EQ(b.tick(-1, false, 1), 0);
  EXPECT_EQ(b.tick(-1), 1);
}

TEST(HitQueue, IsFullWithDepthRaysAndTakesOneMoreInTheCycleAfterAPop) {
  HitQueueTwin queue({2});
  queue.push(1);
  EXPECT_TRUE(queue.empty());  // pushed in c: seen from c + 1
  queue.commit();
  EXPECT_FALSE(queue.empty());
  EXPECT_FALSE(queue.full());
  queue.push(2);
  queue.commit();
  EXPECT_TRUE(queue.full());
  queue.pop();
  EXPECT_TRUE(queue.full());
  queue.commit();
  EXPECT_FALSE(queue.full());
  EXPECT_EQ(queue.head(), 2);
}

}  // namespace
}  // namespace cuesta::twins
