#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include "models/units/dram/dram.h"
#include "models/units/dram/dram_level.h"
#include "models/units/height_l1/height_l1.h"
#include "models/units/hit_queue/hit_queue.h"
#include "models/units/memory/memory_port.h"
#include "models/units/ray_dispatch/dispatch_order.h"
#include "models/units/ray_dispatch/ray_dispatch.h"
#include "models/units/ray_setup/ray_setup_unit.h"
#include "models/units/result_writer/result_writer.h"
#include "tests/twins/dram_twin.h"
#include "tests/twins/height_l1_twin.h"
#include "tests/twins/hit_queue_twin.h"
#include "tests/twins/random_machine.h"
#include "tests/twins/ray_dispatch_twin.h"
#include "tests/twins/ray_setup_twin.h"
#include "tests/twins/result_writer_twin.h"

// Units of the machine, each driven alone, cycle by cycle, beside its twin: random parameters, random work, random
// stalls. traverse needs all of its neighbours; it is compared in the whole machine.

namespace cuesta::twins {
namespace {

constexpr uint64_t kSeeds = 300;

Cycle response(Dram& dram, Cycle sent, uint64_t address, int request_latency) {
  return dram.serve(sent + request_latency, address, 64, false).response;
}

TEST(FastDram, GivesTheHandWorkedTimes) {
  DramParameters p;
  p.clock_num = p.clock_den = 1;
  {
    Dram dram(p, 64);
    EXPECT_EQ(response(dram, 0, 0, 10), 50);        // activate 10, column 21, data 32 to 40
    EXPECT_EQ(response(dram, 1, 64, 10), 58);       // row hit: column 29, data 40 to 48
    EXPECT_EQ(response(dram, 100, 2047, 10), 139);  // late row hit
  }
  {
    Dram dram(p, 64);
    EXPECT_EQ(response(dram, 0, 0, 10), 50);
    EXPECT_EQ(response(dram, 1, 16384, 10),
              89);  // conflict: precharge 38, activate 49, column 60, data 71 to 79
    EXPECT_EQ(response(dram, 2, 2048, 10), 97);  // another bank, behind it on the bus
  }
  p.clock_num = 8;
  p.clock_den = 5;
  Dram dram(p, 64);
  EXPECT_EQ(response(dram, 0, 0, 10), 39);
}

TEST(UnitEqualsTwin, Dram) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Architecture a = random_machine(seed, 1).architecture;
    const int line = a.height_l1.line_bytes, burst = a.result_writer.burst_bytes;
    Random random(seed);
    const int requests = 60;
    const PortStalls no_stalls;
    // A pipeline for each request: no two answers meet at a port.
    DramTwin twin(a.dram, line, burst, requests, no_stalls);
    Dram fast(a.dram, std::max(line, burst));
    std::vector<Cycle> sent(requests), expected(requests), landed(requests, -1);
    std::vector<DramTwin::Request> what;
    Cycle at = 0;
    const int64_t pause = random.between(0, 60);
    for (int r = 0; r < requests; ++r) {
      at += random.chance(0.5) ? 0 : random.between(0, pause);
      sent[r] = at;
      const bool write = random.chance(0.3);
      what.push_back({r, write, r, random.below(random.chance(0.5) ? 4096 : 1 << 20), 0});
      expected[r] =
          fast.serve(at + a.dram.request_latency_cycles, what[r].address, write ? burst : line, write)
              .response;
    }
    const Cycle end = *std::max_element(expected.begin(), expected.end()) + 5;
    size_t next = 0;
    for (Cycle cycle = 0; cycle < end; ++cycle) {
      for (int r = 0; r < requests; ++r) {
        if (twin.landing_read(r, cycle) || twin.landing_writes(r, cycle) > 0) landed[r] = cycle;
      }
      for (; next < what.size() && sent[next] == cycle; ++next) twin.send(what[next], cycle);
      twin.evaluate(cycle);
    }
    ASSERT_EQ(landed, expected) << "seed " << seed;
    EXPECT_EQ(twin.counts().row_conflicts, fast.counts().row_conflicts) << "seed " << seed;
    EXPECT_EQ(twin.counts().row_hits, fast.counts().row_hits) << "seed " << seed;
    EXPECT_EQ(twin.counts().bus_clocks, fast.counts().bus_clocks) << "seed " << seed;
  }
}

HeightL1Twin::Answer as_twin(HeightL1::Answer answer) {
  switch (answer) {
    case HeightL1::Answer::kHit:
      return HeightL1Twin::Answer::kHit;
    case HeightL1::Answer::kAllocated:
      return HeightL1Twin::Answer::kAllocated;
    case HeightL1::Answer::kMerged:
      return HeightL1Twin::Answer::kMerged;
    case HeightL1::Answer::kRefused:
      break;
  }
  return HeightL1Twin::Answer::kRefused;
}

TEST(UnitEqualsTwin, HeightL1) {
  constexpr int kContexts = 24;
  constexpr uint64_t kLines = 96;
  constexpr Cycle kCycles = 3000;
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const RandomMachine machine = random_machine(seed, 1);
    const Architecture& a = machine.architecture;
    const PortStalls* stalls = machine.stalled ? &machine.stalls : nullptr;
    const int line_bytes = a.height_l1.line_bytes;
    std::vector<MemoryCost> costs(kContexts);
    DramLevel level(a.dram, line_bytes, costs);
    MemoryPort memory(level, false);
    HeightL1 fast(a.height_l1, kContexts, kLines * static_cast<uint64_t>(line_bytes), 0, memory, stalls);
    DramTwin dram_twin(a.dram, line_bytes, line_bytes, 1, machine.stalls);
    HeightL1Twin twin(a.height_l1, 0, machine.stalls);

    Random random(seed);
    const uint64_t lines = static_cast<uint64_t>(random.between(1, kLines));
    std::vector<uint64_t> line_of(kContexts);
    std::vector<int> idle(kContexts);
    for (int c = 0; c < kContexts; ++c) idle[c] = c;
    auto look_up = [&](int context, Cycle cycle) {
      const auto expected = twin.lookup(context, line_of[context]);
      const auto answer = as_twin(fast.lookup(static_cast<uint32_t>(line_of[context]), context, 0, cycle));
      if (answer == HeightL1Twin::Answer::kRefused) fast.push_retry(context);
      if (answer == HeightL1Twin::Answer::kHit) idle.push_back(context);
      return answer == expected;
    };
    for (Cycle cycle = 0; cycle < kCycles; ++cycle) {
      const auto where = [&] { return testing::Message() << "seed " << seed << ", cycle " << cycle; };
      fast.land_before(cycle);
      if (const auto mshr = dram_twin.landing_read(0, cycle)) twin.land(*mshr);
      ASSERT_EQ(fast.replay_waiting(), twin.replay_ready()) << where();
      ASSERT_EQ(fast.retry_possible(), twin.retry_ready()) << where();
      const bool slot_taken = random.chance(0.3);
      if (!slot_taken && twin.replay_ready()) {
        const int context = fast.replay(cycle);
        ASSERT_EQ(context, twin.take_replay()) << where();
        idle.push_back(context);
      } else if (!slot_taken && twin.retry_ready()) {
        const int context = fast.pop_retry();
        ASSERT_EQ(context, twin.take_retry()) << where();
        ASSERT_TRUE(look_up(context, cycle)) << where();
      } else if (!idle.empty() && random.chance(0.8)) {
        const int context = idle.back();
        idle.pop_back();
        line_of[context] = random.below(lines);
        ASSERT_TRUE(look_up(context, cycle)) << where();
      }
      memory.serve_until(cycle + 1);
      if (const auto request = twin.evaluate_request(cycle)) {
        dram_twin.send({0, false, request->mshr, request->line * static_cast<uint64_t>(line_bytes), 0},
                       cycle);
      }
      dram_twin.evaluate(cycle);
      twin.commit();
    }
    fast.land_before(kCycles);
    EXPECT_EQ(fast.counts().evictions, twin.evictions()) << "seed " << seed;
    EXPECT_EQ(fast.counts().unique_lines, twin.unique_lines()) << "seed " << seed;
  }
}

TEST(UnitEqualsTwin, RayDispatchAndRaySetup) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const RandomMachine machine = random_machine(seed, 200);
    const Architecture& a = machine.architecture;
    const PortStalls* stalls = machine.stalled ? &machine.stalls : nullptr;
    const int pipelines = a.machine.pipelines;
    const auto rays = static_cast<uint32_t>(machine.pixels.size());
    std::vector<uint16_t> targets;
    if (a.ray_dispatch.assign == DispatchAssign::kInterleave) {
      for (const uint32_t pixel : machine.pixels) {
        targets.push_back(static_cast<uint16_t>(tile_number(pixel, machine.width, a.ray_dispatch.tile_size) %
                                                static_cast<uint32_t>(pipelines)));
      }
    }
    RayDispatch fast(a.ray_dispatch, pipelines, stalls);
    fast.trace_arrives(rays, targets);
    RayDispatchTwin twin(a.ray_dispatch, pipelines, machine.pixels, machine.width, machine.stalls);
    std::vector<RaySetupUnit> fast_setups;
    std::vector<RaySetupTwin> setups;
    for (int p = 0; p < pipelines; ++p) {
      fast_setups.emplace_back(a.ray_setup, a.ray_dispatch, p, fast, stalls);
      setups.emplace_back(a.ray_setup, a.ray_dispatch.latency_cycles, p, machine.stalls);
    }
    Random random(seed);
    const double eagerness = random.unit();
    uint32_t taken = 0;
    for (Cycle cycle = 0; taken < rays; ++cycle) {
      ASSERT_LT(cycle, 1'000'000) << "seed " << seed;
      const auto sent = twin.evaluate(cycle);
      fast.set_horizon(cycle + 1);
      fast.advance();
      for (int p = 0; p < pipelines; ++p) {
        fast_setups[p].advance();
        const auto offered = setups[p].offered(cycle);
        ASSERT_EQ(fast_setups[p].next_ready() <= cycle, offered.has_value())
            << "seed " << seed << ", pipeline " << p << ", cycle " << cycle;
        if (offered && random.chance(eagerness)) {
          const RaySetupUnit::Ready ready = fast_setups[p].take(cycle);
          ASSERT_EQ(static_cast<int>(ready.ray), *offered) << "seed " << seed << ", cycle " << cycle;
          setups[p].take();
          ++taken;
        }
        if (setups[p].evaluate(cycle)) twin.give_back(p, cycle);
      }
      if (sent) setups[sent->pipeline].receive(sent->ray, cycle);
      ASSERT_EQ(fast.sent() > 0 && fast.last_sent() == cycle, sent.has_value())
          << "seed " << seed << ", cycle " << cycle;
      twin.commit();
      for (RaySetupTwin& setup : setups) setup.commit();
    }
    EXPECT_EQ(fast.last_sent(), rays == 0 ? -1 : twin.last_sent()) << "seed " << seed;
  }
}

TEST(UnitEqualsTwin, HitQueueAndResultWriter) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const RandomMachine machine = random_machine(seed, 1);
    const Architecture& a = machine.architecture;
    const PortStalls* stalls = machine.stalled ? &machine.stalls : nullptr;
    const int burst_bytes = a.result_writer.burst_bytes;
    constexpr int kRecords = 150;
    std::vector<MemoryCost> costs(kRecords);
    DramLevel level(a.dram, burst_bytes, costs);
    MemoryPort memory(level, false);
    HitQueue fast_queue(a.hit_queue.depth);
    ResultWriter fast(a.result_writer, 0, 1, 0, fast_queue, memory, stalls);
    DramTwin dram_twin(a.dram, burst_bytes, burst_bytes, 1, machine.stalls);
    HitQueueTwin queue(a.hit_queue);
    ResultWriterTwin twin(a.result_writer, 0, machine.stalls);

    Random random(seed);
    const double eagerness = random.unit();
    int pushed = 0;
    Cycle last_push = kNever, last_acknowledged = -1;
    for (Cycle cycle = 0; pushed < kRecords || !queue.empty() || !twin.idle(); ++cycle) {
      ASSERT_LT(cycle, 1'000'000) << "seed " << seed;
      if (pushed == kRecords) fast.finish(last_push + 1);
      fast.advance(cycle);
      memory.serve_until(cycle);
      ASSERT_EQ(fast_queue.full(), queue.full()) << "seed " << seed << ", cycle " << cycle;
      ASSERT_EQ(fast_queue.empty(), queue.empty()) << "seed " << seed << ", cycle " << cycle;
      ASSERT_EQ(fast.counts().bursts, twin.bursts()) << "seed " << seed << ", cycle " << cycle;
      for (int left = dram_twin.landing_writes(0, cycle); left > 0; --left) {
        twin.acknowledge();
        last_acknowledged = cycle;
      }
      const auto burst = twin.evaluate(cycle, queue, pushed == kRecords && queue.empty());
      if (burst) {
        const uint64_t address = static_cast<uint64_t>(burst->number) * static_cast<uint64_t>(burst_bytes);
        dram_twin.send({0, true, 0, address, burst->owner}, cycle);
      }
      dram_twin.evaluate(cycle);
      if (pushed < kRecords && !queue.full() && random.chance(eagerness)) {
        fast_queue.push(static_cast<uint32_t>(pushed), cycle);
        queue.push(pushed++);
        last_push = cycle;
      }
      queue.commit();
      twin.commit();
    }
    EXPECT_EQ(fast.counts().records, kRecords) << "seed " << seed;
    EXPECT_EQ(fast.counts().last_acknowledged, last_acknowledged) << "seed " << seed;
    EXPECT_TRUE(fast.idle()) << "seed " << seed;
    EXPECT_EQ(static_cast<size_t>(fast_queue.counts().max_fill), queue.most()) << "seed " << seed;
    EXPECT_EQ(fast_queue.counts().waited_cycles, queue.record_cycles()) << "seed " << seed;
  }
}

}  // namespace
}  // namespace cuesta::twins
