#include "models/traversal/traverse_unit.h"

#include <algorithm>

#include "models/common/error.h"

namespace cuesta {

void TraverseUnit::advance(Cycle limit) {
  setup_.advance();
  while (cycle_ < limit) {
    l1_.land_before(cycle_);
    int& slot = slots_[static_cast<size_t>(slot_)];
    if (slot >= 0) {
      Context& ray = contexts_[static_cast<size_t>(slot)];
      if (ray.steps.next != ray.steps.end) {
        const HeightL1::Answer answer = access(ray, slot);
        if (answer == HeightL1::Answer::kHit) {
          step(ray);
        } else {
          park(slot, answer);
          slot = -1;
          --occupied_;
        }
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
  l1_.land_before(cycle_);
}

/// Issues a ray into the empty slot at select.
void TraverseUnit::issue(int context) {
  Context& ray = contexts_[static_cast<size_t>(context)];
  const HeightL1::Answer answer = access(ray, context);
  if (answer != HeightL1::Answer::kHit) return park(context, answer);
  step(ray);
  slots_[static_cast<size_t>(slot_)] = context;
  ++occupied_;
}

/// The lookup has missed.
void TraverseUnit::park(int context, HeightL1::Answer answer) {
  Context& ray = contexts_[static_cast<size_t>(context)];
  ++ray.other_slots;
  if (answer == HeightL1::Answer::kRefused) {
    ++counts_.refused_slots;
    l1_.push_retry(context);
    return;
  }
  ++counts_.miss_slots;
  ray.misses += answer == HeightL1::Answer::kAllocated;
}

/// What the ray asked for in this slot is there.
void TraverseUnit::step(Context& ray) {
  const uint32_t line = *ray.steps.next;
  ++ray.steps.next;
  if (line >= kKeptStep) [[unlikely]] {
    if (line != kKeptStep) {
      ++(line == kComputeSlot ? counts_.compute_slots : counts_.part_slots);
      ++ray.other_slots;
      watchdog_.last_progress = cycle_;
      return;
    }
    ++counts_.kept_steps;
  }
  ++counts_.steps;
  watchdog_.last_progress = cycle_;
}

/// The ray in the slot at select has ended. False: the pipe stands still, time has passed.
bool TraverseUnit::retire(int context, Cycle limit) {
  writer_.advance(cycle_);
  Cycle cycle = cycle_;
  if (hit_queue_.full()) {
    const Cycle popped = writer_.advance_to_pop(limit);
    cycle = popped == kNever ? limit : popped + 1;
  }
  cycle = PortStalls::free_from(stalls_, Port::kHitStream, pipeline_, std::max(cycle, hits_open_from_));
  cycle = std::min(cycle, limit);
  if (cycle > cycle_) {
    if (watchdog_.expired(cycle)) give_up();
    counts_.stalls += cycle - cycle_;
    cycle_ = cycle;
    return false;
  }
  Context& ray = contexts_[static_cast<size_t>(context)];
  hit_queue_.push(ray.ray, cycle_);
  hits_[ray.trace] = source_.hit(ray.ray);
  timing_[ray.trace] = {cycle_, static_cast<uint32_t>(cycle_ - ray.sent),
                        hits_[ray.trace].steps + ray.other_slots, ray.misses, source_.fetches(ray.ray)};
  source_.done(ray.ray);
  ++counts_.rays;
  counts_.hits += hits_[ray.trace].status == HitStatus::kHit;
  counts_.resident_cycles += cycle_ - ray.entered;
  watchdog_.last_progress = cycle_;
  if (completions_ != nullptr) completions_->push_back(ray.trace);
  if (log_ != nullptr) log_->hits.push_back({cycle_, ray.ray, hits_[ray.trace]});
  free_.push_back(context);
  slots_[static_cast<size_t>(slot_)] = -1;
  --occupied_;
  return true;
}

/// Replay, retry or new ray, in this order; false when there is none.
bool TraverseUnit::fill_empty_slot() {
  if (l1_.replay_waiting()) {
    const int context = l1_.replay(cycle_);
    Context& ray = contexts_[static_cast<size_t>(context)];
    ++counts_.replays;
    step(ray);
    slots_[static_cast<size_t>(slot_)] = context;
    ++occupied_;
    return true;
  }
  if (l1_.retry_possible()) {
    issue(l1_.pop_retry());
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
  ray.other_slots = 0;
  ray.misses = 0;
  ray.sent = next.sent;
  ray.entered = cycle_;
  ray.steps = source_.steps(next.ray);
  if (ray.steps.next != ray.steps.end) {
    issue(context);
  } else {
    ++ray.other_slots;
    ++counts_.dead_slots;
    watchdog_.last_progress = cycle_;
    slots_[static_cast<size_t>(slot_)] = context;
    ++occupied_;
  }
  setup_.advance();
  return true;
}

/// Nothing can take the slot: time passes to the next slot that holds a ray or the next thing to arrive.
void TraverseUnit::bubble(Cycle limit) {
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
  if (next >= kNever || (watchdog_.expired(next) && !starved())) give_up();
  add_bubbles(counts_, next - cycle_);
  slot_ = static_cast<int>((slot_ + next - cycle_) % stages_);
  cycle_ = next;
}

void TraverseUnit::give_up() const {
  throw Error(ExitCode::kNoProgress, "no step was finished for " + std::to_string(watchdog_.limit) +
                                         " cycles (machine.no_progress_cycles), since cycle " +
                                         std::to_string(watchdog_.last_progress) + ": " + who_waits());
}

void TraverseUnit::add_bubbles(Counts& counts, Cycle cycles) const {
  if (free_.empty()) {
    counts.contexts_full += cycles;
    return;
  }
  Cycle draining = 0;
  if (setup_.empty() && dispatch_.all_sent()) {
    draining = std::clamp<Cycle>(cycle_ + cycles - 1 - dispatch_.last_sent(), 0, cycles);
  }
  counts.drain += draining;
  counts.no_ray += cycles - draining;
}

TraverseUnit::Counts TraverseUnit::counts_until(Cycle end) const {
  Counts counts = counts_;
  add_bubbles(counts, end - cycle_);
  std::vector<bool> resident(contexts_.size(), true);
  for (const int context : free_) resident[static_cast<size_t>(context)] = false;
  for (size_t context = 0; context < contexts_.size(); ++context) {
    if (resident[context]) counts.resident_cycles += end - 1 - contexts_[context].entered;
  }
  return counts;
}

std::string TraverseUnit::who_waits() const {
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
