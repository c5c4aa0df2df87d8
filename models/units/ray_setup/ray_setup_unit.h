#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "models/common/ring.h"
#include "models/units/ports/port_log.h"
#include "models/units/ports/port_stalls.h"
#include "models/units/ray_dispatch/ray_dispatch.h"
#include "models/units/ray_setup/counters.h"
#include "models/units/ray_setup/parameters.h"

namespace cuesta {

/// ray_setup: clip, reciprocals, start cell and level; when a ray that was dispatched may be taken by traverse.
/// The value is computed by `start` (traversal.h) when traverse takes the ray.
///
/// Ports: rays from ray_dispatch's queue, rays to traverse; both registered, both in order.
/// Timing: ray k enters in the first cycle e_k with e_k >= sent + dispatch latency, e_k >= e_(k-1) +
/// interval_cycles and, at the end of e_k - 1, fewer than queue_depth rays entered and not yet taken; traverse
/// may take it from e_k + latency_cycles on.
class RaySetupUnit {
 public:
  struct Ready {
    uint32_t ray;  ///< position in the machine's order
    Cycle sent;
    Cycle cycle;  ///< may be taken from this cycle on
  };

  RaySetupUnit(const RaySetupParameters& parameters, const RayDispatchParameters& dispatch, int pipeline,
               RayDispatch& source, const PortStalls* stalls)
      : parameters_(parameters),
        dispatch_(dispatch),
        pipeline_(pipeline),
        source_(source),
        stalls_(stalls),
        ready_(static_cast<size_t>(parameters.queue_depth)),
        queue_depth_(static_cast<size_t>(parameters.queue_depth)),
        taken_(std::bit_ceil(queue_depth_), -1) {}

  /// Adds entering rays to `log` from now on.
  void log_ports(PortLog* log) { log_ = log; }

  /// Moves rays from the dispatch queue into set-up as far as is known.
  void advance() {
    auto& queue = source_.queue(pipeline_);
    while (ready_.size() < queue_depth_) {
      if (queue.empty()) source_.advance();
      if (queue.empty()) return;
      const RayDispatch::Sent next = queue.front();
      Cycle enters =
          std::max(next.cycle + dispatch_.latency_cycles, last_entered_ + parameters_.interval_cycles);
      enters = std::max(enters, taken_at(entered_ - queue_depth_) + 1);
      enters = PortStalls::free_from(stalls_, Port::kDispatch, pipeline_, enters);
      queue.pop_front();
      last_entered_ = enters;
      ready_.push_back({next.ray, next.cycle, enters + parameters_.latency_cycles});
      source_.give_credit(pipeline_, enters + dispatch_.credit_latency_cycles);
      ++entered_;
      if (log_ != nullptr) log_->entries.push_back({enters, next.ray});
    }
  }

  /// Returns the first cycle in which the next ray may be taken; kNever when none is known.
  Cycle next_ready() const { return ready_.empty() ? kNever : ready_.front().cycle; }

  /// Returns the position of the next ray in the machine's order.
  uint32_t next_ray() const { return ready_.front().ray; }

  Ready take(Cycle cycle) {
    const Ready taken = ready_.front();
    taken_at(entered_ - ready_.size()) = cycle;
    ready_.pop_front();
    return taken;
  }

  /// Says whether no ray is here nor in the queue before.
  bool empty() const { return ready_.empty() && source_.queue(pipeline_).empty(); }
  RaySetupCounts counts() const { return {static_cast<int64_t>(entered_)}; }
  size_t waiting() const { return ready_.size(); }
  size_t queued() const { return source_.queue(pipeline_).size(); }

 private:
  /// Returns when ray k, counted from 0 by entering, was taken: of those that are not yet forgotten.
  Cycle& taken_at(size_t k) { return taken_[k & (taken_.size() - 1)]; }

  RaySetupParameters parameters_;
  RayDispatchParameters dispatch_;
  int pipeline_;
  RayDispatch& source_;
  const PortStalls* stalls_;
  PortLog* log_ = nullptr;
  Ring<Ready> ready_;  ///< entered, not yet taken
  Cycle last_entered_ = INT32_MIN;
  size_t queue_depth_;
  std::vector<Cycle> taken_;  ///< ring of a power of two: when each ray was taken; -1 at reset
  size_t entered_ = 0;
};

}  // namespace cuesta
