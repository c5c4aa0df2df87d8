#include "models/units/memory/memory_port.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>
#include <vector>

#include "models/common/random.h"
#include "models/units/height_l1/height_l1.h"

// The contract MemoryLevel: in which order a level is asked, when it learns that nothing earlier comes, and that its
// answers may come later and in any order.

namespace cuesta {
namespace {

/// A level that answers when it is told to settle, the last request first: as a controller that reorders may.
class LastFirst final : public MemoryLevel {
 public:
  explicit LastFirst(Cycle latency) : latency_(latency) {}

  void request(const MemoryRequest& request) override {
    asked.push_back(request);
    waiting_.push_back(request);
  }
  void settle(Cycle limit) override {
    settled.push_back(limit);
    Cycle response = limit + latency_;
    for (; !waiting_.empty(); waiting_.pop_back()) {
      const MemoryRequest& last = waiting_.back();
      if (last.client != nullptr) last.client->respond(last.slot, response++);
    }
  }
  size_t in_flight() const override { return waiting_.size(); }

  std::vector<MemoryRequest> asked;
  std::vector<Cycle> settled;

 private:
  Cycle latency_;
  std::vector<MemoryRequest> waiting_;
};

MemoryRequest request_of(Cycle leaves, int pipeline, bool write) {
  return {leaves, pipeline, write, 0, 0, 64, 0, nullptr};
}

TEST(MemoryPort, AsksTheLevelInTheOrderOfArrivalAndOnlyBelowTheLimit) {
  Random random(3);
  LastFirst level(10);
  MemoryPort port(level, false);
  constexpr int kRequests = 200;
  constexpr Cycle kLimit = 30, kAll = 60;
  std::set<std::tuple<Cycle, int, bool>> sent;
  for (int k = 0; k < kRequests; ++k) {
    const MemoryRequest one =
        request_of(random.between(0, kAll - 1), static_cast<int>(random.below(4)), random.below(2) == 1);
    if (sent.emplace(one.leaves, one.pipeline, one.write).second) port.send(one);
  }
  EXPECT_TRUE(level.asked.empty());
  port.serve_until(kLimit);
  ASSERT_EQ(level.settled, std::vector<Cycle>{kLimit});
  for (const MemoryRequest& one : level.asked) EXPECT_LT(one.leaves, kLimit);
  port.serve_until(kAll);
  ASSERT_EQ(level.asked.size(), sent.size());
  auto expected = sent.begin();  // a set of (cycle, pipeline, read before write) is in that order
  for (const MemoryRequest& one : level.asked) {
    EXPECT_EQ(std::tuple(one.leaves, one.pipeline, one.write), *expected++);
  }
}

TEST(MemoryPort, AtOnceLetsTheWriterCatchUpBeforeARead) {
  struct Writer final : MemoryClient {
    void respond(int, Cycle) override {}
    void catch_up(Cycle limit) override { caught_up.push_back(limit); }
    std::vector<Cycle> caught_up;
  } writer;
  LastFirst level(10);
  MemoryPort port(level, true);
  port.set_writer(&writer);
  port.send(request_of(5, 0, true));
  port.send(request_of(7, 0, false));
  EXPECT_EQ(level.asked.size(), 2u);
  EXPECT_EQ(writer.caught_up, std::vector<Cycle>{7});
}

TEST(MemoryLevel, MayAnswerInAnotherOrderThanItWasAsked) {
  constexpr int kMisses = 4;
  LastFirst level(20);
  MemoryPort port(level, false);
  HeightL1 l1(HeightL1Parameters{}, kMisses, 1 << 16, 0, port, nullptr);
  for (int k = 0; k < kMisses; ++k) {
    ASSERT_EQ(l1.lookup(static_cast<uint32_t>(k), k, static_cast<uint32_t>(k), k),
              HeightL1::Answer::kAllocated);
  }
  port.serve_until(kMisses);
  EXPECT_EQ(level.in_flight(), 0u);
  std::vector<int> contexts;
  for (Cycle cycle = kMisses; contexts.size() < kMisses; ++cycle) {
    ASSERT_LT(cycle, 1000);
    l1.land_before(cycle);
    if (l1.replay_waiting()) contexts.push_back(l1.replay(cycle));
  }
  EXPECT_EQ(contexts, (std::vector<int>{3, 2, 1, 0}));
  EXPECT_EQ(l1.counts().fills, kMisses);
  EXPECT_EQ(l1.counts().fill_bytes, int64_t{kMisses} * HeightL1Parameters{}.line_bytes);
}

}  // namespace
}  // namespace cuesta
