#include "models/units/traverse/run_ahead_traverse.h"

#include <algorithm>
#include <bit>

namespace cuesta {

RunAheadTraverse::RunAheadTraverse(const HmtSite& site, RaySetupUnit& setup, HeightL1& l1)
    : TraverseUnit(site, setup, l1), empty_from_(slots_.size()) {
  const uint64_t size = std::bit_ceil(std::max<uint64_t>(64, slots_.size() * (kMostAhead + 2)));
  wheel_.assign(size / 64, 0);
  wheel_mask_ = size - 1;
  for (size_t slot = 0; slot < slots_.size(); ++slot) empty_from_[slot] = static_cast<Cycle>(slot);
}

void RunAheadTraverse::advance(Cycle limit) {
  setup_.advance();
  while (!finished()) {
    const Event event = next_event();
    if (watchdog_.expired(std::min(event.cycle, limit)) && !starved()) give_up();
    if (event.cycle >= limit) break;
    cycle_ = event.cycle;
    slot_ = event.slot;
    l1_.land_before(cycle_);
    select(limit);
  }
  l1_.land_before(cycle_);
}

/// The first slot that holds a ray that asks for something.
RunAheadTraverse::Event RunAheadTraverse::next_busy() const {
  if (occupied_ == 0) return {kNever, 0};
  const auto now = static_cast<uint64_t>(pipe_time()) & wheel_mask_;
  const uint64_t words = wheel_.size();
  uint64_t word = now / 64;
  uint64_t bits = wheel_[word] >> now % 64 << now % 64;
  while (bits == 0) {
    word = (word + 1) & (words - 1);
    bits = wheel_[word];
  }
  const uint64_t place = word * 64 + static_cast<uint64_t>(std::countr_zero(bits));
  const auto ahead = static_cast<Cycle>((place - now) & wheel_mask_);
  return {cycle_ + ahead, slot_after(ahead)};
}

/// What happens next: the first slot that has something to do at select.
RunAheadTraverse::Event RunAheadTraverse::next_event() const {
  const Event busy = next_busy();
  if (occupied_ == stages_) return busy;
  Cycle at = next_work();
  if (at >= busy.cycle) return busy;
  int slot = slot_after(at - cycle_);
  for (; at < busy.cycle; ++at) {
    if (slots_[static_cast<size_t>(slot)] < 0) return {at, slot};
    slot = slot + 1 == stages_ ? 0 : slot + 1;
  }
  return busy;
}

/// The first cycle from now on in which an empty slot could take something.
Cycle RunAheadTraverse::next_work() const {
  if (l1_.replay_waiting() || l1_.retry_possible()) return cycle_;
  Cycle next = l1_.next_landing() + 1;
  if (!free_.empty()) next = std::min(next, setup_.next_ready());
  return std::max(next, cycle_);
}

/// What happens in `cycle_`, with slot_ at select.
void RunAheadTraverse::select(Cycle limit) {
  const Cycle now = pipe_time();
  const int context = slots_[static_cast<size_t>(slot_)];
  Cycle& empty_from = empty_from_[static_cast<size_t>(slot_)];
  if (context >= 0) {
    const auto place = static_cast<uint64_t>(now) & wheel_mask_;
    wheel_[place / 64] &= ~(uint64_t{1} << place % 64);
    Context& ray = contexts_[static_cast<size_t>(context)];
    if (ray.steps.next != ray.steps.end) {
      const HeightL1::Answer answer = access(ray, context);
      if (answer == HeightL1::Answer::kHit) {
        step(ray);
        run_ahead(context);
      } else {
        park(context, answer);
        take_out();
        empty_from = now + stages_;
      }
      return next_slot();
    }
    if (!retire(context, limit)) return wait_until(now);  // the pipe stands still
    empty_from = now;
    if (finished()) return;
  }
  count_bubbles(now);
  if (fill_empty_slot()) {
    const int taken = slots_[static_cast<size_t>(slot_)];
    if (taken >= 0)
      run_ahead(taken);
    else
      empty_from = now + stages_;
  }
  next_slot();
}

/// The ray has had this cycle's slot: its next steps, until something but time decides.
void RunAheadTraverse::run_ahead(int context) {
  Context& ray = contexts_[static_cast<size_t>(context)];
  const uint32_t* next = ray.steps.next;
  const uint32_t* const end = ray.steps.end - next > kMostAhead ? next + kMostAhead : ray.steps.end;
  Cycle at = cycle_ + stages_;
  for (; next != end; ++next, at += stages_) {
    const uint32_t line = *next;
    if ((line & kKeptStep) == 0) {
      if (!l1_.touch(line & kLineMask, at)) break;
      l1_.count_hits(1);
    }
    if (line < kKeptStep) [[likely]]
      continue;
    if (line == kKeptStep) {
      ++counts_.kept_steps;
      continue;
    }
    ++(line == kComputeSlot ? counts_.compute_slots : counts_.part_slots);
    ++ray.other_slots;
    --counts_.steps;
  }
  counts_.steps += next - ray.steps.next;
  ray.steps.next = next;
  watchdog_.last_progress = std::max(watchdog_.last_progress, at - stages_);
  wait_until(at - counts_.stalls);
}

/// Those of slot_, which is empty, before pipe time `until`.
void RunAheadTraverse::count_bubbles(Cycle until) {
  Cycle& from = empty_from_[static_cast<size_t>(slot_)];
  if (from >= until) return;
  const Cycle bubbles = (until - from + stages_ - 1) / stages_;
  from += bubbles * stages_;
  if (free_.empty())
    counts_.contexts_full += bubbles;
  else if (setup_.empty() && dispatch_.all_sent())
    counts_.drain += bubbles;
  else
    counts_.no_ray += bubbles;
}

void RunAheadTraverse::drain_until(Cycle end) {
  record_rays_inside();
  for (slot_ = 0; slot_ < stages_; ++slot_) {
    if (slots_[static_cast<size_t>(slot_)] < 0) count_bubbles(end - counts_.stalls);
  }
  cycle_ = end;
}

}  // namespace cuesta
