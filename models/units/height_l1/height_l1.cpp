#include "models/units/height_l1/height_l1.h"

#include <algorithm>
#include <utility>

namespace cuesta {

HeightL1::Answer HeightL1::miss(uint32_t line, int context, uint32_t ray, Cycle cycle) {
  ++counts_.accesses;
  next_waiter_[static_cast<size_t>(context)] = -1;
  for (size_t four = 0; four < pending_lines_.size(); four += 4) {
    if (const unsigned equal = equal_of_four(&pending_lines_[four], line); equal != 0) {
      Mshr& mshr = mshrs_[four + static_cast<size_t>(std::countr_zero(equal))];
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
  pending_lines_[static_cast<size_t>(slot)] = line;
  const uint32_t first_way = sets_.first_way(line);
  uint32_t victim = first_way;
  Cycle least = used_[victim];
  for (uint32_t way = first_way + 1; way < first_way + sets_.ways_; ++way) {
    victim = used_[way] < least ? way : victim;
    least = std::min(least, used_[way]);
  }
  used_[victim] = cycle + 1;
  mshrs_[static_cast<size_t>(slot)] = {victim, context, context, cycle};
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
    size_t k = landings_.size();
    while (k > 0 && landings_[k - 1].cycle > lands) --k;
    return k > 0 && landings_[k - 1].cycle == lands;
  });
}

void HeightL1::respond(int slot, Cycle response) {
  const Cycle lands = earliest(response);
  landings_.push_back({lands, slot});
  for (size_t k = landings_.size() - 1; k > 0 && landings_[k - 1].cycle > lands; --k)
    std::swap(landings_[k - 1], landings_[k]);
  next_landing_ = landings_.front().cycle;
}

HeightL1::Counts HeightL1::counts_until(Cycle end) const {
  Counts counts = counts_;
  for (size_t slot = 0; slot < mshrs_.size(); ++slot) {
    if ((free_mshrs_ >> slot & 1) == 0) counts.mshr_cycles += end - 1 - mshrs_[slot].allocated;
  }
  return counts;
}

void HeightL1::land_one() {
  const int slot = landings_.front().slot;
  landings_.pop_front();
  next_landing_ = landings_.empty() ? kNever : landings_.front().cycle;
  uint32_t& line = lines_[mshrs_[static_cast<size_t>(slot)].victim_way];
  ++counts_.fills;
  counts_.fill_bytes += line_bytes_;
  counts_.evictions += line != kNoLine;
  line = std::exchange(pending_lines_[static_cast<size_t>(slot)], kNoLine);
  landed_.push_back(slot);
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
