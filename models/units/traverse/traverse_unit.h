#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/units/height_l1/height_l1.h"
#include "models/units/hmt/hmt_site.h"
#include "models/units/ray_setup/ray_setup_unit.h"
#include "models/units/traverse/counters.h"

namespace cuesta {

/// traverse: one step of one ray per cycle. What a step is, its StepSource says: a node visit, or a step of an
/// approximate search.
///
/// Ports: rays from ray_setup, lookups to height_l1, replays from height_l1, hit stream to a HitSink (hit_queue). All
/// but the choice within a cycle are registered.
/// Timing: a rigid pipe of `stages` slots that go round. Each enabled cycle one slot is at select. A ray that has
/// ended leaves by the hit stream (with hit_queue full the whole pipe stands still) and its context is free at
/// once; a ray that goes on is issued; an empty slot takes the first that can: a replay of height_l1, a retry,
/// a new ray while fewer than `contexts` are resident; else it is a bubble. An issued ray's step is done when the
/// slot is at select again, `stages` enabled cycles later; one whose lookup misses is parked and leaves the slot
/// empty. A ray dead at set-up takes a slot for one round, without a lookup.
/// Pipe time and real time are kept apart: only real time passes while the pipe stands still.
///
/// With FetchRule::kQuad a step reads the lines of 2 x 2 siblings, one after the other: each line access takes one slot
/// with one lookup, the next when the slot is at select again, and the step is done with the last of them; a miss
/// parks and replays the ray for that line alone. A step whose siblings the ray has kept takes one slot without a
/// lookup. (Our rule: one cache port and one step's worth of wires per slot.)
///
/// A step of a search reads the lines of its sample alike, one a slot. Arithmetic that does not fit between two
/// samples, a division say, takes slots of its own before them: kComputeSlot, without a lookup. (Ours.)
///
/// The value, which lines a ray reads and where it ends, comes from a StepSource.
class TraverseUnit {
 public:
  using Counts = TraverseCounts;

  TraverseUnit(const HmtSite& site, RaySetupUnit& setup, HeightL1& l1)
      : source_(site.source),
        order_(site.order),
        pipeline_(site.pipeline),
        dispatch_(site.dispatch),
        setup_(setup),
        l1_(l1),
        sink_(site.sink),
        hits_(site.hits),
        timing_(site.timing),
        watchdog_(site.watchdog),
        stalls_(site.stalls),
        log_(site.log),
        stages_(site.architecture.traverse.stages),
        contexts_(static_cast<size_t>(site.architecture.traverse.contexts)),
        slots_(static_cast<size_t>(stages_), -1),
        busy_(slots_.size() / 64 + 1, 0) {
    for (int context = site.architecture.traverse.contexts - 1; context >= 0; --context)
      free_.push_back(context);
  }

  /// Holds the hit stream back until `cycle`, as a hit_queue that is full does.
  void hold_hits_until(Cycle cycle) { hits_open_from_ = cycle; }
  /// Adds, from now on, the positions in the trace of rays that complete to `rays`, in order.
  void log_completions(std::vector<uint32_t>* rays) { completions_ = rays; }

  /// Does everything that happens in cycles below `limit`. Throws Error(kNoProgress).
  void advance(Cycle limit);

  /// Says whether no ray is here and none can come.
  bool finished() const { return resident() == 0 && setup_.empty() && dispatch_.all_sent(); }
  Cycle cycle() const { return cycle_; }
  /// Says whether it has nothing to do but to wait for rays from outside.
  bool starved() const { return resident() == 0 && setup_.empty() && dispatch_.starved(); }
  int resident() const { return static_cast<int>(contexts_.size() - free_.size()); }
  /// Counts the cycles from where the unit stopped to the machine's last one, `end` - 1.
  void drain_until(Cycle end) {
    record_rays_inside();
    add_bubbles(counts_, end - cycle_);
    cycle_ = end;
  }
  const Counts& counts() const { return counts_; }
  /// At the end of cycle `end` - 1, with the cycles so far of rays that are resident; a unit that is finished stops
  /// earlier.
  Counts counts_until(Cycle end) const;
  /// Says how full every queue is and who waits for whom, for the watchdog's message.
  std::string who_waits() const;

 protected:
  /// Records, in a run that was stopped, the misses so far of rays that have not ended.
  void record_rays_inside();

  struct Context {
    RaySteps steps;        ///< still to do
    uint32_t ray;          ///< position in the machine's order
    uint32_t trace;        ///< position in the trace
    uint32_t other_slots;  ///< issue slots that did not end a step
    uint32_t misses;
    Cycle sent;
    Cycle entered;
  };
  std::vector<const Context*> residents() const;

  /// Does the step's next line access; kHit where nothing is to be read.
  HeightL1::Answer access(const Context& ray, int context) {
    const uint32_t line = *ray.steps.next;
    if ((line & kKeptStep) != 0) [[unlikely]]
      return HeightL1::Answer::kHit;
    return l1_.lookup(line & kLineMask, context, ray.ray, cycle_);
  }
  void go_on(Cycle limit);
  void put(int context) {
    slots_[static_cast<size_t>(slot_)] = context;
    busy_[static_cast<size_t>(slot_) / 64] |= uint64_t{1} << slot_ % 64;
    ++occupied_;
  }
  void take_out() {
    slots_[static_cast<size_t>(slot_)] = -1;
    busy_[static_cast<size_t>(slot_) / 64] &= ~(uint64_t{1} << slot_ % 64);
    --occupied_;
  }
  Cycle slots_to_next() const;
  void issue(int context);
  void park(int context, HeightL1::Answer answer);
  void step(Context& ray);
  bool retire(int context, Cycle limit);
  bool fill_empty_slot();
  void bubble(Cycle limit);
  void add_bubbles(Counts& counts, Cycle cycles) const;
  [[noreturn]] void give_up() const;
  void next_slot() {
    if (++slot_ == stages_) slot_ = 0;
    ++cycle_;
  }

  StepSource& source_;
  const std::vector<uint32_t>& order_;
  int pipeline_;
  RayDispatch& dispatch_;
  RaySetupUnit& setup_;
  HeightL1& l1_;
  HitSink& sink_;
  std::vector<HitRecord>& hits_;
  std::vector<RayTiming>& timing_;
  Watchdog& watchdog_;
  const PortStalls* stalls_;
  std::vector<uint32_t>* completions_ = nullptr;
  PortLog* log_;
  Cycle hits_open_from_ = 0;
  int stages_;
  std::vector<Context> contexts_;
  std::vector<int> free_;       ///< contexts
  std::vector<int> slots_;      ///< context in each slot, or -1
  std::vector<uint64_t> busy_;  ///< bit set: the slot holds a ray
  int occupied_ = 0;            ///< slots that hold a ray
  int slot_ = 0;                ///< at select
  Cycle cycle_ = 0;             ///< the next to happen
  Counts counts_;
};

}  // namespace cuesta
