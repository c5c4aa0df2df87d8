#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "models/architecture.h"
#include "models/common/error.h"
#include "models/common/port_stalls.h"
#include "models/heightmap/texel_layout.h"
#include "models/memory/height_l1.h"
#include "models/output/hit_queue.h"
#include "models/output/result_writer.h"
#include "models/traversal/ray_setup_unit.h"
#include "models/traversal/traversal.h"

namespace cuesta {

/// What the machine knows of a ray in time; the value is in its hit record.
struct RayTiming {
  Cycle completed = -1;      ///< transfer on the hit stream; -1: not finished
  uint32_t latency = 0;      ///< dispatch to completion, cycles
  uint32_t issue_slots = 0;  ///< slots of the traverse pipe that the ray used
  uint32_t misses = 0;       ///< lines fetched for it: misses that it allocated
};

/// When something last moved, for the whole machine.
struct Watchdog {
  Cycle limit = kNever;  ///< cycles without a finished step that are too many
  Cycle last_progress = 0;

  bool expired(Cycle now) const { return now - last_progress > limit; }
};

/// traverse: one step of one ray per cycle.
///
/// Ports: rays from ray_setup, lookups to height_l1, replays from height_l1, hit stream to hit_queue. All but the
/// choice within a cycle are registered.
/// Timing: a rigid pipe of `stages` slots that go round. Each enabled cycle one slot is at select. A ray that has
/// ended leaves by the hit stream (with hit_queue full the whole pipe stands still) and its context is free at
/// once; a ray that goes on is issued; an empty slot takes the first that can: a replay of height_l1, a retry,
/// a new ray while fewer than `contexts` are resident; else it is a bubble. An issued ray's step is done when the
/// slot is at select again, `stages` enabled cycles later; one whose lookup misses is parked and leaves the slot
/// empty. A ray dead at set-up takes a slot for one round, without a lookup.
/// Pipe time and real time are kept apart: only real time passes while the pipe stands still.
template <class A, class G>
class TraverseUnit {
 public:
  /// Cycles by what the pipe did; they add up to all cycles.
  struct Counts {
    int64_t steps = 0;          ///< slots: a node visit
    int64_t miss_slots = 0;     ///< slots: a lookup that missed and parked the ray on an MSHR
    int64_t refused_slots = 0;  ///< slots: a lookup that missed and found no free MSHR
    int64_t dead_slots = 0;     ///< slots: a ray dead at set-up
    int64_t contexts_full = 0;  ///< bubbles: every context waits for memory
    int64_t no_ray = 0;         ///< bubbles: no ray to take, some still to come
    int64_t drain = 0;          ///< bubbles: no ray left for this pipeline
    int64_t stalls = 0;         ///< pipe stands still: hit_queue is full
    int64_t replays = 0;        ///< of the steps: replayed after a miss
    int64_t rays = 0;           ///< completed
    int64_t hits = 0;
    int64_t resident_cycles = 0;  ///< sum over rays of cycles in a context
    int64_t total() const {
      return steps + miss_slots + refused_slots + dead_slots + contexts_full + no_ray + drain + stalls;
    }
  };

  TraverseUnit(const TraverseParameters& parameters, const Walk<A, G>& walk, const Pyramid& pyramid,
               const TexelLayout& layout, std::span<const MachineRay> rays, std::span<const uint32_t> order,
               int pipeline, RayDispatch& dispatch, RaySetupUnit& setup, HeightL1& l1, HitQueue& hit_queue,
               ResultWriter& writer, std::span<HitRecord> hits, std::span<RayTiming> timing,
               Watchdog& watchdog, const PortStalls* stalls)
      : walk_(walk),
        layout_(layout),
        rays_(rays),
        order_(order),
        pipeline_(pipeline),
        dispatch_(dispatch),
        setup_(setup),
        l1_(l1),
        hit_queue_(hit_queue),
        writer_(writer),
        hits_(hits),
        timing_(timing),
        watchdog_(watchdog),
        stalls_(stalls),
        stages_(parameters.stages),
        contexts_(static_cast<size_t>(parameters.contexts)),
        slots_(static_cast<size_t>(parameters.stages), -1) {
    for (int context = parameters.contexts - 1; context >= 0; --context) free_.push_back(context);
    for (int level = 0; level <= pyramid.root_level(); ++level) {
      levels_.push_back({pyramid.level(level), pyramid.width(level)});
    }
  }

  /// Everything that happens in cycles below `limit`. Throws Error(kNoProgress).
  void advance(Cycle limit);

  /// No ray here, none to come.
  bool finished() const { return resident() == 0 && setup_.empty() && dispatch_.all_sent(); }
  Cycle cycle() const { return cycle_; }
  int resident() const { return static_cast<int>(contexts_.size() - free_.size()); }
  /// The cycles from where the unit stopped to the machine's last one.
  void drain_until(Cycle end) {
    counts_.drain += end - cycle_;
    cycle_ = end;
  }
  const Counts& counts() const { return counts_; }
  /// Fill of every queue and who waits for whom, for the watchdog's message.
  std::string who_waits() const;

 private:
  struct Context {
    RayState<A, G> state;
    uint32_t ray;    ///< position in the machine's order
    uint32_t trace;  ///< position in the trace
    uint32_t issue_slots;
    uint32_t misses;
    Cycle sent;
    Cycle entered;
    Visit visit;
  };
  struct LevelView {
    const uint16_t* texels;
    int width;
  };

  void lookup(int context);
  void step(Context& ray, int i, int j);
  bool retire(int context, Cycle limit);
  bool fill_empty_slot();
  void bubble(Cycle limit);
  void count_bubbles(Cycle cycles);
  [[noreturn]] void give_up() const;
  void next_slot(Cycle cycles = 1) {
    slot_ = static_cast<int>((slot_ + cycles) % stages_);
    cycle_ += cycles;
  }

  const Walk<A, G>& walk_;
  const TexelLayout& layout_;
  std::span<const MachineRay> rays_;
  std::span<const uint32_t> order_;
  int pipeline_;
  RayDispatch& dispatch_;
  RaySetupUnit& setup_;
  HeightL1& l1_;
  HitQueue& hit_queue_;
  ResultWriter& writer_;
  std::span<HitRecord> hits_;
  std::span<RayTiming> timing_;
  Watchdog& watchdog_;
  const PortStalls* stalls_;
  int stages_;
  std::vector<Context> contexts_;
  std::vector<int> free_;   ///< contexts
  std::vector<int> slots_;  ///< context in each slot, or -1
  int occupied_ = 0;        ///< slots that hold a ray
  int slot_ = 0;            ///< at select
  Cycle cycle_ = 0;         ///< the next to happen
  std::vector<LevelView> levels_;
  Counts counts_;
};

template <class A, class G>
void TraverseUnit<A, G>::advance(Cycle limit) {
  setup_.advance();
  while (cycle_ < limit) {
    l1_.land_before(cycle_);
    int& slot = slots_[static_cast<size_t>(slot_)];
    if (slot >= 0) {
      if (contexts_[static_cast<size_t>(slot)].visit == Visit::kContinue) {
        lookup(slot);
        next_slot();
        continue;
      }
      if (!retire(slot, limit)) continue;
    }
    if (finished()) return;
    if (fill_empty_slot())
      next_slot();
    else
      bubble(limit);
  }
}

template <class A, class G>
void TraverseUnit<A, G>::lookup(int context) {
  Context& ray = contexts_[static_cast<size_t>(context)];
  const int level = ray.state.level;
  const int i = static_cast<int>(ray.state.gx.fetch_index(walk_.x, level));
  const int j = static_cast<int>(ray.state.gy.fetch_index(walk_.y, level));
  ++ray.issue_slots;
  int& slot = slots_[static_cast<size_t>(slot_)];
  switch (l1_.lookup(layout_.offset(level, i, j), context, ray.ray, cycle_)) {
    case HeightL1::Answer::kHit:
      step(ray, i, j);
      occupied_ += slot < 0;
      slot = context;
      return;
    case HeightL1::Answer::kAllocated:
      ++ray.misses;
      [[fallthrough]];
    case HeightL1::Answer::kMerged:
      ++counts_.miss_slots;
      break;
    case HeightL1::Answer::kRefused:
      ++counts_.refused_slots;
      l1_.push_retry(context);
      break;
  }
  occupied_ -= slot >= 0;
  slot = -1;
}

template <class A, class G>
void TraverseUnit<A, G>::step(Context& ray, int i, int j) {
  const LevelView& view = levels_[static_cast<size_t>(ray.state.level)];
  ray.visit =
      visit(walk_, ray.state,
            view.texels[static_cast<size_t>(j) * static_cast<size_t>(view.width) + static_cast<size_t>(i)]);
  ++counts_.steps;
  watchdog_.last_progress = cycle_;
}

/// The ray in the slot at select has ended. False: the pipe stands still, time has passed.
template <class A, class G>
bool TraverseUnit<A, G>::retire(int context, Cycle limit) {
  writer_.advance(cycle_);
  Cycle cycle = cycle_;
  if (hit_queue_.full()) {
    const Cycle popped = writer_.advance_to_pop(limit);
    cycle = popped == kNever ? limit : popped + 1;
  }
  cycle = PortStalls::free_from(stalls_, Port::kHitStream, pipeline_, cycle);
  cycle = std::min(cycle, limit);
  if (cycle > cycle_) {
    if (watchdog_.expired(cycle)) give_up();
    counts_.stalls += cycle - cycle_;
    cycle_ = cycle;
    return false;
  }
  Context& ray = contexts_[static_cast<size_t>(context)];
  hit_queue_.push(ray.ray, cycle_);
  hits_[ray.trace] = hit_record(walk_, ray.state, rays_[ray.trace].id, ray.visit);
  timing_[ray.trace] = {cycle_, static_cast<uint32_t>(cycle_ - ray.sent), ray.issue_slots, ray.misses};
  ++counts_.rays;
  counts_.hits += ray.visit == Visit::kHit;
  counts_.resident_cycles += cycle_ - ray.entered;
  watchdog_.last_progress = cycle_;
  free_.push_back(context);
  slots_[static_cast<size_t>(slot_)] = -1;
  --occupied_;
  return true;
}

/// Replay, retry or new ray, in this order; false when there is none.
template <class A, class G>
bool TraverseUnit<A, G>::fill_empty_slot() {
  if (l1_.replay_waiting()) {
    const int context = l1_.replay(cycle_);
    Context& ray = contexts_[static_cast<size_t>(context)];
    ++ray.issue_slots;
    ++counts_.replays;
    step(ray, static_cast<int>(ray.state.gx.fetch_index(walk_.x, ray.state.level)),
         static_cast<int>(ray.state.gy.fetch_index(walk_.y, ray.state.level)));
    slots_[static_cast<size_t>(slot_)] = context;
    ++occupied_;
    return true;
  }
  if (l1_.retry_possible()) {
    lookup(l1_.pop_retry());
    return true;
  }
  if (free_.empty()) return false;
  if (setup_.next_ready() > cycle_ ||
      (stalls_ != nullptr && stalls_->blocked(Port::kSetup, pipeline_, cycle_))) {
    return false;
  }
  const RaySetupUnit::Ready next = setup_.take(cycle_);
  const int context = free_.back();
  free_.pop_back();
  Context& ray = contexts_[static_cast<size_t>(context)];
  ray.ray = next.ray;
  ray.trace = order_[next.ray];
  ray.issue_slots = 0;
  ray.misses = 0;
  ray.sent = next.sent;
  ray.entered = cycle_;
  ray.visit = start(walk_, rays_[ray.trace], ray.state);
  if (ray.visit == Visit::kContinue) {
    lookup(context);
  } else {
    ++ray.issue_slots;
    ++counts_.dead_slots;
    watchdog_.last_progress = cycle_;
    slots_[static_cast<size_t>(slot_)] = context;
    ++occupied_;
  }
  setup_.advance();
  return true;
}

/// Nothing can take the slot: time passes to the next slot that holds a ray or the next thing to arrive.
template <class A, class G>
void TraverseUnit<A, G>::bubble(Cycle limit) {
  Cycle next = limit;
  if (occupied_ > 0) {
    Cycle ahead = 1;
    for (int s = slot_ + 1;; ++s, ++ahead) {
      if (slots_[static_cast<size_t>(s >= stages_ ? s - stages_ : s)] >= 0) break;
    }
    next = std::min(next, cycle_ + ahead);
  }
  if (l1_.next_landing() != kNever) next = std::min(next, l1_.next_landing() + 1);
  if (!free_.empty()) next = std::min(next, std::max(setup_.next_ready(), cycle_ + 1));
  next = std::max(next, cycle_ + 1);
  if (next >= kNever || watchdog_.expired(next)) give_up();
  count_bubbles(next - cycle_);
  next_slot(next - cycle_);
}

template <class A, class G>
void TraverseUnit<A, G>::give_up() const {
  throw Error(ExitCode::kNoProgress, "no step was finished for " + std::to_string(watchdog_.limit) +
                                         " cycles (machine.no_progress_cycles), since cycle " +
                                         std::to_string(watchdog_.last_progress) + ": " + who_waits());
}

template <class A, class G>
void TraverseUnit<A, G>::count_bubbles(Cycle cycles) {
  if (free_.empty()) {
    counts_.contexts_full += cycles;
    return;
  }
  Cycle draining = 0;
  if (setup_.empty() && dispatch_.all_sent()) {
    draining = std::clamp<Cycle>(cycle_ + cycles - 1 - dispatch_.last_sent(), 0, cycles);
  }
  counts_.drain += draining;
  counts_.no_ray += cycles - draining;
}

template <class A, class G>
std::string TraverseUnit<A, G>::who_waits() const {
  auto n = [](auto value) { return std::to_string(value); };
  return "traverse[" + n(pipeline_) + "] holds " + n(resident()) + " of " + n(contexts_.size()) + " rays, " +
         n(occupied_) + " in the pipe, the others wait for height_l1; height_l1: " + n(l1_.mshrs_taken()) +
         " MSHRs taken, wait for dram, " + n(l1_.retry_fill()) +
         " rays wait for an MSHR; ray_setup: " + n(setup_.queued()) + " rays queued, " + n(setup_.waiting()) +
         " in set-up; hit_queue: " + n(hit_queue_.size()) +
         " records wait for result_writer; result_writer: " + n(writer_.filled()) + " records, " +
         n(writer_.unacknowledged()) + " bursts wait for dram; ray_dispatch: " + n(dispatch_.sent()) +
         " rays sent";
}

}  // namespace cuesta
