#pragma once

#include <algorithm>
#include <cstdint>

#include "models/common/ring.h"
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
    ++pushes_;
    max_fill_ = std::max(max_fill_, size());
  }
  void pop(Cycle cycle) {
    waited_cycles_ += cycle - front().pushed;
    entries_.pop_front();
    ++pops_;
  }

  int64_t pushes() const { return pushes_; }
  int64_t pops() const { return pops_; }
  /// Sum over records of the cycles from push to pop.
  int64_t waited_cycles() const { return waited_cycles_; }
  /// Most records met by a push, itself included; pops of the same cycle not yet counted.
  size_t max_fill() const { return max_fill_; }

 private:
  size_t depth_;
  Ring<Entry> entries_;
  size_t max_fill_ = 0;
  int64_t pushes_ = 0, pops_ = 0, waited_cycles_ = 0;
};

}  // namespace cuesta
