#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "models/architecture.h"

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
    if (popped_) rays_.pop_front();
    if (pushed_) rays_.push_back(*pushed_);
    popped_ = false;
    pushed_.reset();
    most_ = rays_.size() > most_ ? rays_.size() : most_;
  }

  int64_t most() const { return static_cast<int64_t>(most_); }  ///< rays at the end of a cycle, at most

 private:
  int depth_;
  std::deque<int> rays_;
  std::optional<int> pushed_;
  bool popped_ = false;
  size_t most_ = 0;
};

}  // namespace cuesta::twins
