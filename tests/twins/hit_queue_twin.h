#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>

#include "models/units/architecture.h"

// Ticking twins: one class per unit, evaluated in every cycle. What a unit shows is its state at the end of the
// cycle before; what a cycle changes is noted and takes effect in commit(), at the cycle's end.

namespace cuesta::twins {

/// hit_queue: a FIFO of rays that have ended; at most one push and one pop in a cycle.
class HitQueueTwin {
 public:
  explicit HitQueueTwin(const HitQueueParameters& parameters) : depth_(parameters.depth) {}

  bool full() const { return static_cast<int>(rays_.size()) == depth_; }
  bool empty() const { return rays_.empty(); }
  int head() const { return rays_.front(); }

  void push(int ray) { pushed_ = ray; }
  void pop() { popped_ = true; }
  void commit() {
    if (pushed_) most_ = std::max(most_, static_cast<int64_t>(rays_.size()) + 1);
    if (popped_) rays_.pop_front();
    if (pushed_) rays_.push_back(*pushed_);
    pushes_ += pushed_ ? 1 : 0;
    pops_ += popped_ ? 1 : 0;
    popped_ = false;
    pushed_.reset();
    record_cycles_ += static_cast<int64_t>(rays_.size());
  }

  int64_t pushes() const { return pushes_; }
  int64_t pops() const { return pops_; }
  int64_t record_cycles() const { return record_cycles_; }  ///< sum over cycles of the rays at their end
  int64_t most() const {
    return most_;
  }  ///< what a push met and itself, at most; a pop of its cycle not seen

 private:
  int depth_;
  std::deque<int> rays_;
  std::optional<int> pushed_;
  bool popped_ = false;
  int64_t pushes_ = 0, pops_ = 0, record_cycles_ = 0, most_ = 0;
};

}  // namespace cuesta::twins
