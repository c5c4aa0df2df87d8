#include "models/memory/height_l1.h"

#include <algorithm>

namespace cuesta {

HeightL1::Answer HeightL1::miss(uint32_t line, uint32_t first_way, int context, uint32_t ray, Cycle cycle) {
  next_waiter_[static_cast<size_t>(context)] = -1;
  for (uint64_t bits = pending_; bits != 0; bits &= bits - 1) {
    Mshr& mshr = mshrs_[static_cast<size_t>(std::countr_zero(bits))];
    if (mshr.line == line) {
      next_waiter_[static_cast<size_t>(mshr.last_waiter)] = context;
      mshr.last_waiter = context;
      ++counts_.merges;
      return Answer::kMerged;
    }
  }
  if (free_mshrs_ == 0) {
    ++counts_.refused;
    return Answer::kRefused;
  }
  const int slot = std::countr_zero(free_mshrs_);
  free_mshrs_ &= ~(uint64_t{1} << slot);
  pending_ |= uint64_t{1} << slot;
  uint32_t victim = first_way;
  for (uint32_t way = first_way + 1; way < first_way + ways_; ++way) {
    if (used_[way] < used_[victim]) victim = way;
  }
  used_[victim] = cycle + 1;
  mshrs_[static_cast<size_t>(slot)] = {line, victim, context, context, kNever, cycle};
  ++counts_.misses;
  uint64_t& word = seen_[line / 64];
  counts_.unique_lines += static_cast<int64_t>(~word >> (line % 64) & 1);
  word |= uint64_t{1} << (line % 64);
  last_leave_ =
      PortStalls::free_from(stalls_, Port::kMemoryRequest, pipeline_, std::max(cycle, last_leave_ + 1));
  memory_.send({last_leave_, pipeline_, false, slot, ray, line_bytes_,
                static_cast<uint64_t>(line) << line_shift_, this});
  if (log_ != nullptr) log_->requests.push_back({last_leave_, slot, uint64_t{line} << line_shift_, ray});
  return Answer::kAllocated;
}

Cycle HeightL1::earliest(Cycle response) const {
  return first_free_landing(response, stalls_, pipeline_, [&](Cycle lands) {
    for (uint64_t bits = pending_; bits != 0; bits &= bits - 1) {
      if (mshrs_[static_cast<size_t>(std::countr_zero(bits))].lands == lands) return true;
    }
    return false;
  });
}

void HeightL1::respond(int slot, Cycle response) {
  const Cycle lands = earliest(response);
  mshrs_[static_cast<size_t>(slot)].lands = lands;
  next_landing_ = std::min(next_landing_, lands);
}

HeightL1::Counts HeightL1::counts_until(Cycle end) const {
  Counts counts = counts_;
  for (size_t slot = 0; slot < mshrs_.size(); ++slot) {
    if ((free_mshrs_ >> slot & 1) == 0) counts.mshr_cycles += end - 1 - mshrs_[slot].allocated;
  }
  return counts;
}

void HeightL1::land_one() {
  int slot = 0;
  for (uint64_t bits = pending_; bits != 0; bits &= bits - 1) {
    slot = std::countr_zero(bits);
    if (mshrs_[static_cast<size_t>(slot)].lands == next_landing_) break;
  }
  const Mshr& mshr = mshrs_[static_cast<size_t>(slot)];
  pending_ &= ~(uint64_t{1} << slot);
  ++counts_.fills;
  counts_.evictions += lines_[mshr.victim_way] != kNoLine;
  lines_[mshr.victim_way] = mshr.line;
  landed_.push_back(slot);
  next_landing_ = kNever;
  for (uint64_t bits = pending_; bits != 0; bits &= bits - 1) {
    next_landing_ = std::min(next_landing_, mshrs_[static_cast<size_t>(std::countr_zero(bits))].lands);
  }
}

int HeightL1::replay(Cycle cycle) {
  const int slot = landed_.front();
  Mshr& mshr = mshrs_[static_cast<size_t>(slot)];
  const int context = mshr.first_waiter;
  mshr.first_waiter = next_waiter_[static_cast<size_t>(context)];
  if (mshr.first_waiter < 0) {
    landed_.pop_front();
    counts_.mshr_cycles += cycle - mshr.allocated;
    free_mshrs_ |= uint64_t{1} << slot;
  }
  return context;
}

}  // namespace cuesta
