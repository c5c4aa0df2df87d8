#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "models/architecture.h"
#include "models/common/port_stalls.h"
#include "tests/twins/height_l1_twin.h"
#include "tests/twins/hit_queue_twin.h"
#include "tests/twins/ray_setup_twin.h"
#include "tests/twins/ray_values.h"

namespace cuesta::twins {

/// traverse: a rigid pipe of `stages` slots that go round; every cycle ends as exactly one TraverseCycle.
enum class TraverseCycle : uint8_t {
  kStep,
  kMiss,
  kRefused,
  kDead,
  kContextsFull,
  kNoRay,
  kDrain,
  kStalled,
};
inline constexpr int kTraverseCycleKinds = 8;

class TraverseTwin {
 public:
  /// What happened in one cycle, for the accounting.
  struct Event {
    TraverseCycle kind;
    int issued = -1;     ///< ray that used the issue slot
    int completed = -1;  ///< ray that went to hit_queue
    std::optional<HeightL1Twin::Answer> lookup;
    bool replayed = false;
    bool retried = false;
  };

  TraverseTwin(const TraverseParameters& parameters, int line_bytes, int pipeline, const PortStalls& stalls,
               RayValues& values)
      : contexts_(parameters.contexts),
        line_bytes_(static_cast<uint64_t>(line_bytes)),
        pipeline_(pipeline),
        stalls_(stalls),
        values_(values),
        slots_(static_cast<size_t>(parameters.stages)) {}

  /// `no_more`: all rays are sent, and none is left in this pipeline's ray_setup or its queue.
  Event evaluate(Cycle cycle, RaySetupTwin& ray_setup, HeightL1Twin& l1, HitQueueTwin& hit_queue,
                 bool no_more) {
    next_ = Next{};
    next_.resident = resident_;
    Event event{};
    const Slot& slot = slots_[at_select_];
    if (slot.ray >= 0 && slot.ended) {
      if (hit_queue.full() || stalls_.blocked(Port::kHitStream, pipeline_, cycle)) {
        next_.moves = false;
        event.kind = TraverseCycle::kStalled;
        return event;
      }
      hit_queue.push(slot.ray);
      event.completed = slot.ray;
      --next_.resident;
    } else if (slot.ray >= 0) {
      look_up(slot.ray, l1, event);
      return event;
    }
    if (l1.replay_ready()) {
      event.replayed = true;
      step(l1.take_replay(), event);
    } else if (l1.retry_ready()) {
      event.retried = true;
      look_up(l1.take_retry(), l1, event);
    } else if (const std::optional<int> ray = offered(ray_setup, cycle); ray && next_.resident < contexts_) {
      ray_setup.take();
      ++next_.resident;
      if (values_.start(*ray) == Visit::kMiss) {
        next_.slot = {*ray, true};
        event.kind = TraverseCycle::kDead;
        event.issued = *ray;
      } else {
        look_up(*ray, l1, event);
      }
    } else {
      event.kind = next_.resident == contexts_ ? TraverseCycle::kContextsFull
                   : no_more                   ? TraverseCycle::kDrain
                                               : TraverseCycle::kNoRay;
    }
    return event;
  }

  void commit() {
    resident_ = next_.resident;
    resident_cycles_ += resident_;
    if (!next_.moves) return;
    slots_[at_select_] = next_.slot;
    at_select_ = (at_select_ + 1) % slots_.size();
  }

  bool empty() const { return resident_ == 0; }
  int64_t resident_cycles() const { return resident_cycles_; }  ///< sum over cycles of rays at their end

 private:
  struct Slot {
    int ray = -1;
    bool ended = false;
  };
  struct Next {
    Slot slot;  ///< what the slot at select holds when it is at select again
    int resident = 0;
    bool moves = true;
  };

  std::optional<int> offered(const RaySetupTwin& ray_setup, Cycle cycle) const {
    if (stalls_.blocked(Port::kSetup, pipeline_, cycle)) return {};
    return ray_setup.offered(cycle);
  }

  void step(int ray, Event& event) {
    next_.slot = {ray, values_.step(ray) != Visit::kContinue};
    event.kind = TraverseCycle::kStep;
    event.issued = ray;
  }

  void look_up(int ray, HeightL1Twin& l1, Event& event) {
    const HeightL1Twin::Answer answer = l1.lookup(ray, values_.address(ray) / line_bytes_);
    event.lookup = answer;
    if (answer == HeightL1Twin::Answer::kHit) return step(ray, event);
    event.kind = answer == HeightL1Twin::Answer::kRefused ? TraverseCycle::kRefused : TraverseCycle::kMiss;
    event.issued = ray;  // parked: the slot comes round empty
  }

  int contexts_;
  uint64_t line_bytes_;
  int pipeline_;
  const PortStalls& stalls_;
  RayValues& values_;
  std::vector<Slot> slots_;
  size_t at_select_ = 0;
  int resident_ = 0;
  int64_t resident_cycles_ = 0;
  Next next_;
};

}  // namespace cuesta::twins
