#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "models/common/ring.h"
#include "models/units/ports/port_stalls.h"
#include "models/units/ray_dispatch/counters.h"
#include "models/units/ray_dispatch/parameters.h"

namespace cuesta {

/// ray_dispatch: sends the rays of the trace, in the machine's order, to the pipelines, at most one a cycle.
///
/// Ports: trace in (head ray valid while rays remain), one ray port per pipeline with credits. Registered.
/// Timing: in cycle c the head ray goes to its target if that has a credit: `first_free` = the lowest pipeline
/// with one, `interleave` = tile number mod N (an empty credit there holds everything back). It may enter
/// ray_setup from c + latency_cycles on; a ray that enters in cycle e gives its credit back for use from
/// e + credit_latency_cycles on. At reset each pipeline has queue_depth credits. Rays are there from cycle 0, or
/// arrive while the machine runs; a ray is sent in the cycle of its arrival at the earliest.
class RayDispatch {
 public:
  struct Sent {
    uint32_t ray;  ///< position in the machine's order
    Cycle cycle;
  };

  RayDispatch(const RayDispatchParameters& parameters, int pipelines, const PortStalls* stalls)
      : interleave_(parameters.assign == DispatchAssign::kInterleave),
        credits_(static_cast<size_t>(pipelines), Ring<Cycle>(static_cast<size_t>(parameters.queue_depth))),
        queues_(static_cast<size_t>(pipelines), Ring<Sent>(static_cast<size_t>(parameters.queue_depth))),
        stalls_(stalls) {
    for (auto& credits : credits_) {
      for (int k = 0; k < parameters.queue_depth; ++k) credits.push_back(0);
    }
  }

  /// Takes so many rays that are there from cycle 0, before any other. `targets`: for interleave, the pipeline of
  /// each in the machine's order; empty for first_free.
  void trace_arrives(uint32_t rays, std::vector<uint16_t> targets) {
    rays_ = rays;
    targets_ = std::move(targets);
  }
  /// Says that more rays may come, until `close`.
  void open() { open_ = true; }
  /// Takes one more ray, which may be sent from `cycle` on, not below an earlier ray's; for interleave, its target.
  void arrive(Cycle cycle, uint16_t target) {
    if (interleave_) targets_.push_back(target);
    arrivals_.push_back({rays_++, cycle});
  }
  /// Learns in `cycle` that no ray follows.
  void close(Cycle cycle) {
    open_ = false;
    closed_ = cycle;
  }

  /// Says that credits which may be used before `limit` are all known: rays may be sent up to there.
  void set_horizon(Cycle limit) { horizon_ = limit; }

  /// Sends all rays whose cycle is below the horizon.
  void advance() {
    const Cycle limit = horizon_;
    while (next_ < rays_) {
      if (!arrivals_.empty() && arrivals_.front().ray == next_) {
        next_cycle_ = std::max(next_cycle_, arrivals_.front().cycle);
        arrivals_.pop_front();
      }
      size_t target = 0;
      Cycle cycle = next_cycle_;
      if (interleave_) {
        target = targets_[next_];
        cycle = std::max(cycle, available(target));
        cycle = PortStalls::free_from(stalls_, Port::kTrace, 0, cycle);
      } else {
        Cycle soonest = kNever;
        for (size_t p = 0; p < credits_.size(); ++p) soonest = std::min(soonest, available(p));
        cycle = std::max(cycle, soonest);
        if (cycle >= limit) return;
        cycle = PortStalls::free_from(stalls_, Port::kTrace, 0, cycle);
        while (available(target) > cycle) ++target;
      }
      if (cycle >= limit) return;
      credits_[target].pop_front();
      queues_[target].push_back({next_, cycle});
      last_sent_ = cycle;
      next_cycle_ = cycle + 1;
      ++next_;
    }
  }

  /// Gives back a credit of the pipeline that may be used from `cycle` on; called in order of cycles.
  void give_credit(int pipeline, Cycle cycle) { credits_[static_cast<size_t>(pipeline)].push_back(cycle); }

  Ring<Sent>& queue(int pipeline) { return queues_[static_cast<size_t>(pipeline)]; }
  /// Says whether no ray waits and none can come.
  bool all_sent() const { return next_ == rays_ && !open_; }
  /// Says whether no ray waits and more may come.
  bool starved() const { return next_ == rays_ && open_; }
  uint32_t sent() const { return next_; }
  RayDispatchCounts counts() const { return {next_}; }
  /// Returns the cycle of the last send, or of when it was known that none follows, if later; -1 before both.
  Cycle last_sent() const { return std::max(last_sent_, closed_); }
  /// Returns the cycle given to `close`; -1 without.
  Cycle closed() const { return closed_; }

 private:
  Cycle available(size_t p) const { return credits_[p].empty() ? kNever : credits_[p].front(); }

  uint32_t rays_ = 0;
  bool interleave_;
  bool open_ = false;
  Cycle closed_ = -1;
  std::deque<Sent> arrivals_;  ///< of rays that were not there from cycle 0, until they are sent
  std::vector<uint16_t> targets_;
  std::vector<Ring<Cycle>> credits_;  ///< per pipeline: when each credit may be used
  std::vector<Ring<Sent>> queues_;    ///< per pipeline: sent, not yet in ray_setup
  uint32_t next_ = 0;
  Cycle next_cycle_ = 0;
  Cycle horizon_ = 0;
  Cycle last_sent_ = -1;
  const PortStalls* stalls_;
};

}  // namespace cuesta
