#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"
#include "tests/twins/height_l1_twin.h"
#include "tests/twins/hit_queue_twin.h"
#include "tests/twins/ray_setup_twin.h"
#include "tests/twins/ray_values.h"

namespace cuesta::twins {

/// traverse: a rigid pipe of `stages` slots that go round; every cycle ends as exactly one TraverseCycle. A step reads
/// the different lines of its texels one after the other, one a slot, and is done with the last; a step whose texels
/// the ray has kept is done in one slot without a lookup. Slots of arithmetic come before a step's first line; a step
/// without a line has its last one as the slot that does it.
enum class TraverseCycle : uint8_t {
  kStep,
  kPart,     ///< a line of a quad or sample, others of the step are to come
  kCompute,  ///< arithmetic before the lines of a step
  kMiss,
  kRefused,
  kDead,
  kContextsFull,
  kNoRay,
  kDrain,
  kStalled,
};
inline constexpr int kTraverseCycleKinds = 10;

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
    bool kept = false;  ///< a step without a lookup
    int texels = 0;     ///< that a fetch begun in this cycle brings
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
      read(l1.take_replay(), event);
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

  /// What the ray's step has still to do.
  struct Rest {
    int compute = 0;  ///< slots
    std::deque<uint64_t> lines;
  };

  /// Of the ray's step; that of a new one is asked for.
  Rest& rest_of(int ray, Event& event) {
    const auto [at, begins] = steps_.try_emplace(ray);
    Rest& rest = at->second;
    if (!begins) return rest;
    const std::vector<uint64_t> addresses = values_.addresses(ray);
    event.texels = static_cast<int>(addresses.size());
    for (const uint64_t address : addresses) {
      const uint64_t line = address / line_bytes_;
      if (std::find(rest.lines.begin(), rest.lines.end(), line) == rest.lines.end())
        rest.lines.push_back(line);
    }
    rest.compute = values_.compute_slots(ray);
    if (rest.lines.empty() && rest.compute > 0) --rest.compute;
    return rest;
  }

  /// The first of the step's lines is there.
  void read(int ray, Event& event) {
    std::deque<uint64_t>& lines = steps_.at(ray).lines;
    lines.pop_front();
    if (lines.empty()) return step(ray, event);
    next_.slot = {ray, false};
    event.kind = TraverseCycle::kPart;
    event.issued = ray;
  }

  void step(int ray, Event& event) {
    steps_.erase(ray);
    next_.slot = {ray, values_.step(ray) != Visit::kContinue};
    event.kind = TraverseCycle::kStep;
    event.issued = ray;
  }

  void look_up(int ray, HeightL1Twin& l1, Event& event) {
    Rest& rest = rest_of(ray, event);
    if (rest.compute > 0) {
      --rest.compute;
      next_.slot = {ray, false};
      event.kind = TraverseCycle::kCompute;
      event.issued = ray;
      return;
    }
    if (rest.lines.empty()) {
      event.kept = true;
      return step(ray, event);
    }
    const HeightL1Twin::Answer answer = l1.lookup(ray, rest.lines.front());
    event.lookup = answer;
    if (answer == HeightL1Twin::Answer::kHit) return read(ray, event);
    event.kind = answer == HeightL1Twin::Answer::kRefused ? TraverseCycle::kRefused : TraverseCycle::kMiss;
    event.issued = ray;  // parked: the slot comes round empty
  }

  int contexts_;
  uint64_t line_bytes_;
  int pipeline_;
  const PortStalls& stalls_;
  RayValues& values_;
  std::vector<Slot> slots_;
  std::map<int, Rest> steps_;  ///< per ray
  size_t at_select_ = 0;
  int resident_ = 0;
  int64_t resident_cycles_ = 0;
  Next next_;
};

}  // namespace cuesta::twins
