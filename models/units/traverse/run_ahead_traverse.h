#pragma once

#include <vector>

#include "models/units/traverse/traverse_unit.h"

namespace cuesta {

/// traverse, loosely timed: TraverseUnit with rays that run ahead of time.
///
/// A ray that has had its slot looks up its next lines at once, one after the other, until one is not in height_l1, the
/// ray has ended, or it is kMostAhead steps ahead; each of these steps takes `stages` cycles. One event, in the place
/// of one a slot, stands for the whole run: the slot is busy until there. That is exact, since no other ray can take
/// it and nothing but a standing pipe can delay it, which delays all slots alike. What misses is looked up again when
/// its cycle has come; if the line has landed meanwhile, the ray goes on.
///
/// So everything that bounds the throughput keeps its law: slots, contexts, MSHRs, fills, replays, set-up, hit stream.
/// What is not exact is the order of lookups: the cache sees runs in the order in which they begin. A ray ahead still
/// finds a line that a fill will have evicted by then, and its lines count as used too early. With one ray in the
/// unit at a time nothing differs. Bubbles are counted by the reason that holds when they end.
///
/// Not ray by ray: rays that are in the unit together wait for a line together, and in the order of dispatch alone each
/// of them would find the cache as the rays before it have left it: more lines are read than in time, most of all by
/// long walks (dda), and bounds on top of such a traffic inherit its error. The price is an event for each miss, each
/// replay and each ray: what is saved is the slots of steps that hit, which is little where many lookups miss.
class RunAheadTraverse final : public TraverseUnit {
 public:
  RunAheadTraverse(const HmtSite& site, RaySetupUnit& setup, HeightL1& l1);

  void advance(Cycle limit);
  void drain_until(Cycle end);
  /// Of a unit that is finished and drained.
  Counts counts_until(Cycle) const { return counts(); }

 private:
  /// Steps of a run; a ray of hundreds of steps would otherwise be thousands of cycles ahead of the others.
  static constexpr int kMostAhead = 32;

  struct Event {
    Cycle cycle;
    int slot;
  };

  Cycle pipe_time() const { return cycle_ - counts_.stalls; }
  void wait_until(Cycle pipe_time) {
    const auto place = static_cast<uint64_t>(pipe_time) & wheel_mask_;
    wheel_[place / 64] |= uint64_t{1} << place % 64;
  }
  int slot_after(Cycle cycles) const {
    const Cycle slot = slot_ + (cycles < stages_ ? cycles : cycles % stages_);
    return static_cast<int>(slot < stages_ ? slot : slot - stages_);
  }
  Event next_busy() const;
  Event next_event() const;
  Cycle next_work() const;
  void select(Cycle limit);
  void run_ahead(int context);
  void count_bubbles(Cycle until);

  std::vector<uint64_t>
      wheel_;  ///< bit t mod its size: at pipe time t, the slot at select holds a ray that asks for something
  uint64_t wheel_mask_;
  std::vector<Cycle>
      empty_from_;  ///< per empty slot: its first time at select, pipe time, that is not counted yet
};

}  // namespace cuesta
