#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "tests/twins/traverse_twin.h"

namespace cuesta::twins {
namespace {

/// Per ray and step, the lines that the step reads. A ray without steps is dead at set-up.
using Steps = std::vector<std::vector<std::vector<uint64_t>>>;

/// Rays whose steps are told.
class ToldRays final : public RayValues {
 public:
  explicit ToldRays(Steps lines) : lines_(std::move(lines)), done_(lines_.size()) {}
  Visit start(int ray) override { return lines_[ray].empty() ? Visit::kMiss : Visit::kContinue; }
  std::vector<uint64_t> addresses(int ray) const override {
    std::vector<uint64_t> all;
    for (const uint64_t line : lines_[ray][done_[ray]]) all.push_back(line * kLineBytes);
    return all;
  }
  int compute_slots(int ray) const override {
    const auto at = compute.find({ray, done_[ray]});
    return at == compute.end() ? 0 : at->second;
  }
  Visit step(int ray) override { return ++done_[ray] == lines_[ray].size() ? Visit::kHit : Visit::kContinue; }
  HitRecord record(int) const override { return {}; }

  static constexpr int kLineBytes = 16;
  std::map<std::pair<int, size_t>, int> compute;  ///< ray and step -> slots of arithmetic

 private:
  Steps lines_;
  std::vector<size_t> done_;
};

/// Each step reads one line.
Steps one_line_each(const std::vector<std::vector<uint64_t>>& rays) {
  Steps steps;
  for (const auto& ray : rays) {
    steps.emplace_back();
    for (const uint64_t line : ray) steps.back().push_back({line});
  }
  return steps;
}

/// A traverse between a ray_setup that offers one ray a cycle from cycle 2 on, an L1 that holds the lines below
/// `warm` (fills by hand), and a hit_queue (pops by hand).
struct Bench {
  Bench(int stages, int contexts, const std::vector<std::vector<uint64_t>>& lines, uint64_t warm,
        int mshrs = 4, int hit_depth = 8)
      : Bench(stages, contexts, std::make_unique<Steps>(one_line_each(lines)), warm, mshrs, hit_depth) {}
  Bench(int stages, int contexts, std::unique_ptr<Steps> lines, uint64_t warm, int mshrs = 4,
        int hit_depth = 8)
      : count(static_cast<int>(lines->size())),
        rays(std::move(*lines)),
        ray_setup({1, 1, 64}, 1, 0, stalls),
        l1({32 * ToldRays::kLineBytes, ToldRays::kLineBytes, 1, mshrs}, 0, stalls),
        hit_queue({hit_depth}),
        traverse(with(stages, contexts), ToldRays::kLineBytes, 0, stalls, rays) {
    for (uint64_t line = 0; line < warm; ++line) {
      l1.lookup(0, line);
      l1.evaluate_request(0);
      l1.commit();
      l1.land(0);
      l1.commit();
      l1.take_replay();
      l1.commit();
    }
  }

  static TraverseParameters with(int stages, int contexts) {
    TraverseParameters p;
    p.stages = stages;
    p.contexts = contexts;
    return p;
  }

  void run(Cycle cycles) {
    for (Cycle end = cycle + cycles; cycle < end; ++cycle) {
      if (cycle < count) ray_setup.receive(static_cast<int>(cycle), cycle);
      if (fills.count(cycle) > 0) l1.land(fills[cycle]);
      if (!hit_queue.empty() && pops_from <= cycle) hit_queue.pop();
      const auto event = traverse.evaluate(cycle, ray_setup, l1, hit_queue, false);
      if (event.completed >= 0) completed[event.completed] = cycle;
      kinds.push_back(event.kind);
      issued.push_back(event.issued);
      l1.evaluate_request(cycle);
      ray_setup.evaluate(cycle);
      for (auto commit : {+[](Bench& b) { b.ray_setup.commit(); }, +[](Bench& b) { b.l1.commit(); },
                          +[](Bench& b) { b.hit_queue.commit(); }, +[](Bench& b) { b.traverse.commit(); }}) {
        commit(*this);
      }
    }
  }

  int count;
  PortStalls stalls;
  ToldRays rays;
  RaySetupTwin ray_setup;
  HeightL1Twin l1;
  HitQueueTwin hit_queue;
  TraverseTwin traverse;
  Cycle cycle = 0;
  Cycle pops_from = 0;
  std::map<Cycle, int> fills;  ///< cycle -> MSHR
  std::map<int, Cycle> completed;
  std::vector<TraverseCycle> kinds;
  std::vector<int> issued;
};

using Done = std::map<int, Cycle>;

TEST(Traverse, StepsOfARayAreStagesCyclesApartAndItsEndToo) {
  Bench b(4, 8, {{0, 1, 2}}, 3);  // enters in 2; steps in 2, 6, 10
  b.run(14);
  EXPECT_EQ(b.completed, Done{});
  b.run(1);
  EXPECT_EQ(b.completed, (Done{{0, 14}}));
  for (Cycle c = 0; c < 15; ++c) {
    EXPECT_EQ(b.kinds[c], c == 2 || c == 6 || c == 10 ? TraverseCycle::kStep : TraverseCycle::kNoRay) << c;
  }
}

TEST(Traverse, ADeadRayTakesOneSlotAndNoLookup) {
  Bench b(4, 8, std::vector<std::vector<uint64_t>>{{}}, 0);
  b.run(7);
  EXPECT_EQ(b.kinds[2], TraverseCycle::kDead);
  EXPECT_EQ(b.completed, (Done{{0, 6}}));
}

TEST(Traverse, AnEndedRaysSlotAndContextAreFreeInTheCycleOfItsTransfer) {
  Bench b(2, 2, {{0}, {0}, {0}}, 1);  // two slots, two contexts: 0 in 2, 1 in 3, 2 when 0 has gone
  b.run(7);
  EXPECT_EQ(b.completed, (Done{{0, 4}, {1, 5}, {2, 6}}));
  EXPECT_EQ(b.kinds[4], TraverseCycle::kStep);
}

TEST(Traverse, NoMoreRaysEnterThanThereAreContexts) {
  Bench b(4, 2, {{0}, {0}, {0}}, 1);
  b.run(12);
  EXPECT_EQ(b.kinds[4], TraverseCycle::kContextsFull);
  EXPECT_EQ(b.kinds[5], TraverseCycle::kContextsFull);
  EXPECT_EQ(b.completed, (Done{{0, 6}, {1, 7}, {2, 10}}));  // the third enters in 6
}

TEST(Traverse, HoldsItsHitWhileTheQueueIsFullAndEverythingElseStandsStill) {
  // Depth 1. Ray 0 ends in 6 and fills the queue until 20; ray 1, whose last step was in 3, waits at select; ray 2,
  // two steps in 4 and then in 8, is moved by the same cycles.
  Bench b(4, 8, {{0}, {0}, {0, 1}}, 2, 4, 1);
  b.pops_from = 20;  // popped in 20: room from 21 on
  b.run(40);
  EXPECT_EQ(b.completed, (Done{{0, 6}, {1, 21}, {2, 26}}));
  for (Cycle c = 7; c <= 20; ++c) EXPECT_EQ(b.kinds[c], TraverseCycle::kStalled) << c;
  EXPECT_EQ(b.kinds[22], TraverseCycle::kStep);
}

TEST(Traverse, AStepOfTwoLinesTakesTwoSlotsAndAKeptOneASlotWithoutALookup) {
  // Enters in 2: line 0 in 2, line 1 in 6 ends the step; kept in 10; line 2 in 14; the end in 18.
  Bench b(4, 8, std::make_unique<Steps>(Steps{{{0, 1}, {}, {2}}}), 3);
  b.run(20);
  EXPECT_EQ(b.completed, (Done{{0, 18}}));
  EXPECT_EQ(b.kinds[2], TraverseCycle::kPart);
  EXPECT_EQ(b.kinds[6], TraverseCycle::kStep);
  EXPECT_EQ(b.kinds[10], TraverseCycle::kStep);
  EXPECT_EQ(b.kinds[14], TraverseCycle::kStep);
}

TEST(Traverse, ArithmeticTakesSlotsBeforeTheLinesOfItsStep) {
  // Enters in 2: line 0. Two slots of arithmetic in 6 and 10, line 1 in 14 ends the step. A step of two slots of
  // arithmetic alone in 18 and 22; the end in 26.
  Bench b(4, 8, std::make_unique<Steps>(Steps{{{0}, {1}, {}}}), 2);
  b.rays.compute = {{{0, 1}, 2}, {{0, 2}, 2}};
  b.run(28);
  EXPECT_EQ(b.completed, (Done{{0, 26}}));
  for (const Cycle c : {6, 10, 18}) EXPECT_EQ(b.kinds[c], TraverseCycle::kCompute) << c;
  for (const Cycle c : {2, 14, 22}) EXPECT_EQ(b.kinds[c], TraverseCycle::kStep) << c;
}

TEST(Traverse, AMissOfAQuadsSecondLineIsReplayedForThatLineAlone) {
  // Line 0 is there: 2. Line 9 misses in 6, lands in 13, is replayed in 14 and ends the step; the end in 18.
  Bench b(4, 8, std::make_unique<Steps>(Steps{{{0, 9}}}), 1);
  b.fills[13] = 0;
  b.run(20);
  EXPECT_EQ(b.kinds[2], TraverseCycle::kPart);
  EXPECT_EQ(b.kinds[6], TraverseCycle::kMiss);
  EXPECT_EQ(b.kinds[14], TraverseCycle::kStep);
  EXPECT_EQ(b.completed, (Done{{0, 18}}));
}

TEST(Traverse, AMissParksItsRayAndLeavesTheSlotEmpty) {
  Bench b(4, 8, {{9}, {0, 0, 0}},
          1);  // ray 0 misses in 2; fill lands in 13, seen from 14, slot of 14 is empty
  b.fills[13] = 0;
  b.run(30);
  EXPECT_EQ(b.kinds[2], TraverseCycle::kMiss);
  EXPECT_EQ(b.kinds[6], TraverseCycle::kNoRay);
  EXPECT_EQ(b.issued[14], 0);
  EXPECT_EQ(b.completed, (Done{{0, 18}, {1, 15}}));
}

TEST(Traverse, AReplayWaitsForAnEmptySlot) {
  // One stage: ray 1 steps in every cycle from 3 to 7 and its slot is empty in 8, when it has gone.
  Bench b(1, 8, {{9}, {0, 0, 0, 0, 0}}, 1);
  b.fills[4] = 0;
  b.run(12);
  EXPECT_EQ(b.completed, (Done{{1, 8}, {0, 9}}));
  EXPECT_EQ(b.issued[8], 0);
}

TEST(Traverse, ReplayGoesBeforeRetryAndRetryBeforeANewRay) {
  // One stage, two MSHRs. 0 and 1 miss; 2 and 3 are refused in 4 and 5; fills land in 5 and 6.
  Bench b(1, 8, {{9}, {10}, {11}, {12}, {0}, {0}, {0}}, 1, 2);
  b.fills[5] = 0;
  b.fills[6] = 1;
  b.run(12);
  // 6: replay of 0 (MSHR 0 free from 7). 7: replay of 1, and the end of 0. 8: retry of 2, end of 1.
  // 9: retry of 3. 10: the first new ray.
  EXPECT_EQ(b.kinds[4], TraverseCycle::kRefused);
  EXPECT_EQ(b.kinds[5], TraverseCycle::kRefused);
  EXPECT_EQ((std::vector<int>(b.issued.begin() + 6, b.issued.begin() + 11)),
            (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(Traverse, ARetryThatFindsItsLineIsAStep) {
  // One MSHR: 0 misses line 9, 1 line 10; 2 waits for line 10 as well and finds it when it is looked up again.
  Bench b(1, 8, {{9}, {10}, {11}, {10}}, 0, 1);
  b.fills[6] = 0;   // line 9: replay of 0 in 7, MSHR free from 8: retry of 1 in 8, of 2 and 3 later
  b.fills[10] = 0;  // line 10: replay of 1 in 11, MSHR free from 12: retry of 2 in 12
  b.fills[14] = 0;  // line 11: replay of 2 in 15; retry of 3 in 16: a hit
  b.run(20);
  EXPECT_EQ(b.kinds[8], TraverseCycle::kMiss);
  EXPECT_EQ(b.kinds[12], TraverseCycle::kMiss);
  EXPECT_EQ(b.kinds[16], TraverseCycle::kStep);
  EXPECT_EQ(b.completed, (Done{{0, 8}, {1, 12}, {2, 16}, {3, 17}}));
}

}  // namespace
}  // namespace cuesta::twins
