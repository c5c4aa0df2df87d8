#pragma once

#include <deque>
#include <optional>

#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta::twins {

/// ray_setup with the queue in front of it. Rays enter in order, one per interval, while fewer than queue_depth
/// have entered and were not taken.
class RaySetupTwin {
 public:
  RaySetupTwin(const RaySetupParameters& parameters, int dispatch_latency, int pipeline,
               const PortStalls& stalls)
      : parameters_(parameters), dispatch_latency_(dispatch_latency), pipeline_(pipeline), stalls_(stalls) {}

  /// ray_dispatch sends a ray in `cycle`.
  void receive(int ray, Cycle cycle) { received_ = Waiting{ray, cycle + dispatch_latency_}; }

  /// True when a ray enters set-up in this cycle (and its credit goes back).
  bool evaluate(Cycle cycle) {
    enters_ = !queue_.empty() && cycle >= queue_.front().from && cycle >= next_entry_ &&
              static_cast<int>(entered_.size()) < parameters_.queue_depth &&
              !stalls_.blocked(Port::kDispatch, pipeline_, cycle);
    cycle_ = cycle;
    return enters_;
  }

  /// The ray that traverse may take in `cycle`.
  std::optional<int> offered(Cycle cycle) const {
    if (entered_.empty() || cycle < entered_.front().from) return {};
    return entered_.front().ray;
  }
  void take() { taken_ = true; }

  void commit() {
    if (taken_) entered_.pop_front();
    if (enters_) {
      entered_.push_back({queue_.front().ray, cycle_ + parameters_.latency_cycles});
      queue_.pop_front();
      next_entry_ = cycle_ + parameters_.interval_cycles;
    }
    if (received_) queue_.push_back(*received_);
    taken_ = enters_ = false;
    received_.reset();
  }

  /// No ray in the queue (on its way from ray_dispatch included) or in set-up, at the end of the cycle before.
  bool empty() const { return queue_.empty() && entered_.empty(); }

 private:
  struct Waiting {
    int ray;
    Cycle from;
  };

  RaySetupParameters parameters_;
  int dispatch_latency_;
  int pipeline_;
  const PortStalls& stalls_;
  std::deque<Waiting> queue_;    ///< sent, not entered; `from`: may enter
  std::deque<Waiting> entered_;  ///< entered, not taken; `from`: may be taken
  Cycle next_entry_ = 0;
  Cycle cycle_ = 0;
  std::optional<Waiting> received_;
  bool enters_ = false;
  bool taken_ = false;
};

}  // namespace cuesta::twins
