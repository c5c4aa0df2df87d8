#pragma once

#include <algorithm>
#include <cstdint>

#include "models/common/ring.h"
#include "models/units/hit_queue/counters.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// hit_queue: results on their way to result_writer; a FIFO of `depth` records.
///
/// Ports: hit stream from traverse, records to result_writer; both registered.
/// Timing: a record pushed in c may be popped from c + 1 on. In c the queue is full when it held `depth` records
/// at the end of c - 1; a pop in c makes room that is seen from c + 1.
class HitQueue {
 public:
  struct Entry {
    uint32_t ray;
    Cycle pushed;
  };

  explicit HitQueue(int depth) : depth_(static_cast<size_t>(depth)), entries_(depth_) {}

  bool empty() const { return entries_.empty(); }
  bool full() const { return size() == depth_; }
  size_t size() const { return entries_.size(); }
  const Entry& front() const { return entries_.front(); }

  void push(uint32_t ray, Cycle cycle) {
    entries_.push_back({ray, cycle});
    ++counts_.pushes;
    counts_.max_fill = std::max(counts_.max_fill, static_cast<int64_t>(size()));
  }
  void pop(Cycle cycle) {
    counts_.waited_cycles += cycle - front().pushed;
    entries_.pop_front();
    ++counts_.pops;
  }

  const HitQueueCounts& counts() const { return counts_; }

 private:
  size_t depth_;
  Ring<Entry> entries_;
  HitQueueCounts counts_;
};

}  // namespace cuesta
