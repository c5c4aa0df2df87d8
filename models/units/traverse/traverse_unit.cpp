#include "models/units/traverse/traverse_unit.h"

#include <algorithm>
#include <bit>

#include "models/common/error.h"

namespace cuesta {

void TraverseUnit::advance(Cycle limit) {
  setup_.advance();
  while (cycle_ < limit) {
    l1_.land_before(cycle_);
    const int context = slots_[static_cast<size_t>(slot_)];
    if (context >= 0) {
      const Context& ray = contexts_[static_cast<size_t>(context)];
      if (ray.steps.next != ray.steps.end) {
        go_on(limit);
        continue;
      }
      if (!retire(context, limit)) continue;
    }
    if (finished()) return;
    if (fill_empty_slot())
      next_slot();
    else
      bubble(limit);
  }
  l1_.land_before(cycle_);
}

/// The ray in the slot at select and those in the slots after it, as long as each goes on with a step of one line that
/// is there, then what comes instead; no fill lands meanwhile.
inline void TraverseUnit::go_on(Cycle limit) {
  const HeightL1::Sets sets = l1_.sets();
  const int* const slots = slots_.data();
  Context* const contexts = contexts_.data();
  const int stages = stages_;
  const Cycle first = cycle_, end = std::min(limit, l1_.next_landing() + 1);
  Cycle cycle = first;
  int slot = slot_, context = slots[slot];
  do {
    RaySteps& steps = contexts[context].steps;
    if (steps.next == steps.end || *steps.next >= kKeptStep || !sets.touch(*steps.next, cycle)) break;
    ++steps.next;
    ++cycle;
    if (++slot == stages) slot = 0;
    context = slots[slot];
  } while (cycle < end && context >= 0);
  cycle_ = cycle;
  slot_ = slot;
  if (cycle > first) {
    counts_.steps += cycle - first;
    l1_.count_hits(cycle - first);
    watchdog_.last_progress = cycle - 1;
  }
  if (cycle == end || context < 0) return;
  Context& ray = contexts[context];
  if (ray.steps.next == ray.steps.end) return;
  const HeightL1::Answer answer = access(ray, context);
  if (answer == HeightL1::Answer::kHit) {
    step(ray);
  } else {
    park(context, answer);
    take_out();
  }
  next_slot();
}

/// Issues a ray into the empty slot at select.
void TraverseUnit::issue(int context) {
  Context& ray = contexts_[static_cast<size_t>(context)];
  const HeightL1::Answer answer = access(ray, context);
  if (answer != HeightL1::Answer::kHit) return park(context, answer);
  step(ray);
  put(context);
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
  Cycle cycle = sink_.has_room(cycle_) ? cycle_ : sink_.next_room(limit);
  cycle = PortStalls::free_from(stalls_, Port::kHitStream, pipeline_, std::max(cycle, hits_open_from_));
  cycle = std::min(cycle, limit);
  if (cycle > cycle_) {
    if (watchdog_.expired(cycle)) give_up();
    counts_.stalls += cycle - cycle_;
    cycle_ = cycle;
    return false;
  }
  Context& ray = contexts_[static_cast<size_t>(context)];
  sink_.take(ray.ray, cycle_);
  HitRecord& hit = hits_[ray.trace];
  const FetchCounts fetches = source_.finish(ray.ray, hit);
  timing_[ray.trace] = {cycle_, static_cast<uint32_t>(cycle_ - ray.sent), hit.steps + ray.other_slots,
                        ray.misses, fetches};
  ++counts_.rays;
  counts_.hits += hit.status == HitStatus::kHit;
  counts_.resident_cycles += cycle_ - ray.entered;
  watchdog_.last_progress = cycle_;
  if (completions_ != nullptr) completions_->push_back(ray.trace);
  if (log_ != nullptr) log_->hits.push_back({cycle_, ray.ray, hit});
  free_.push_back(context);
  take_out();
  return true;
}

/// Replay, retry or new ray, in this order; false when there is none.
bool TraverseUnit::fill_empty_slot() {
  if (l1_.replay_waiting()) {
    const int context = l1_.replay(cycle_);
    Context& ray = contexts_[static_cast<size_t>(context)];
    ++counts_.replays;
    step(ray);
    put(context);
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
    put(context);
  }
  setup_.advance();
  return true;
}

/// From the empty slot at select to the next that holds a ray.
Cycle TraverseUnit::slots_to_next() const {
  const auto from = static_cast<size_t>(slot_);
  size_t word = from / 64;
  uint64_t bits = busy_[word] >> from % 64 << from % 64;
  while (bits == 0) {
    word = word + 1 == busy_.size() ? 0 : word + 1;
    bits = busy_[word];
  }
  const Cycle ahead = static_cast<Cycle>(word) * 64 + std::countr_zero(bits) - slot_;
  return ahead > 0 ? ahead : ahead + stages_;
}

/// Nothing can take the slot: time passes to the next slot that holds a ray or the next thing to arrive.
void TraverseUnit::bubble(Cycle limit) {
  Cycle next = limit;
  if (occupied_ > 0) next = std::min(next, cycle_ + slots_to_next());
  if (l1_.next_landing() != kNever) next = std::min(next, l1_.next_landing() + 1);
  if (!free_.empty()) next = std::min(next, std::max(setup_.next_ready(), cycle_ + 1));
  next = std::max(next, cycle_ + 1);
  if (next >= kNever || (watchdog_.expired(next) && !starved())) give_up();
  add_bubbles(counts_, next - cycle_);
  const Cycle slots = next - cycle_;
  slot_ += static_cast<int>(slots < stages_ ? slots : slots % stages_);
  if (slot_ >= stages_) slot_ -= stages_;
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
  for (const Context* ray : residents()) counts.resident_cycles += end - 1 - ray->entered;
  return counts;
}

std::vector<const TraverseUnit::Context*> TraverseUnit::residents() const {
  std::vector<bool> inside(contexts_.size(), true);
  for (const int context : free_) inside[static_cast<size_t>(context)] = false;
  std::vector<const Context*> rays;
  for (size_t context = 0; context < contexts_.size(); ++context) {
    if (inside[context]) rays.push_back(&contexts_[context]);
  }
  return rays;
}

void TraverseUnit::record_rays_inside() {
  for (const Context* ray : residents()) timing_[ray->trace].misses = ray->misses;
}

std::string TraverseUnit::who_waits() const {
  auto n = [](auto value) { return std::to_string(value); };
  return "traverse[" + n(pipeline_) + "] holds " + n(resident()) + " of " + n(contexts_.size()) + " rays, " +
         n(occupied_) + " in the pipe, the others wait for height_l1; height_l1: " + n(l1_.mshrs_taken()) +
         " MSHRs taken, wait for dram, " + n(l1_.retry_fill()) +
         " rays wait for an MSHR; ray_setup: " + n(setup_.queued()) + " rays queued, " + n(setup_.waiting()) +
         " in set-up; " + sink_.who_waits() + "; ray_dispatch: " + n(dispatch_.sent()) + " rays sent";
}

}  // namespace cuesta
