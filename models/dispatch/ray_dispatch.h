#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "models/architecture.h"
#include "models/common/port_stalls.h"

namespace cuesta {

/// ray_dispatch: sends the rays of the trace, in the machine's order, to the pipelines, at most one a cycle.
///
/// Ports: trace in (head ray valid while rays remain), one ray port per pipeline with credits. Registered.
/// Timing: in cycle c the head ray goes to its target if that has a credit: `first_free` = the lowest pipeline
/// with one, `interleave` = tile number mod N (an empty credit there holds everything back). It may enter
/// ray_setup from c + latency_cycles on; a ray that enters in cycle e gives its credit back for use from
/// e + credit_latency_cycles on. At reset each pipeline has queue_depth credits.
class RayDispatch {
 public:
  struct Sent {
    uint32_t ray;  ///< position in the machine's order
    Cycle cycle;
  };

  /// `targets`: for interleave, the pipeline of each ray in the machine's order; empty for first_free.
  RayDispatch(const RayDispatchParameters& parameters, int pipelines, uint32_t rays,
              std::vector<uint16_t> targets, const PortStalls* stalls)
      : rays_(rays),
        targets_(std::move(targets)),
        credits_(static_cast<size_t>(pipelines)),
        queues_(static_cast<size_t>(pipelines)),
        stalls_(stalls) {
    for (auto& credits : credits_) credits.assign(static_cast<size_t>(parameters.queue_depth), 0);
  }

  /// Credits that may be used before `limit` are all known: rays may be sent up to there.
  void set_horizon(Cycle limit) { horizon_ = limit; }

  /// Sends all rays whose cycle is below the horizon.
  void advance() {
    const Cycle limit = horizon_;
    while (next_ < rays_) {
      size_t target = 0;
      Cycle cycle = next_cycle_;
      if (!targets_.empty()) {
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

  /// A credit of pipeline p that may be used from `cycle` on; called in order of cycles.
  void give_credit(int pipeline, Cycle cycle) { credits_[static_cast<size_t>(pipeline)].push_back(cycle); }

  std::deque<Sent>& queue(int pipeline) { return queues_[static_cast<size_t>(pipeline)]; }
  bool all_sent() const { return next_ == rays_; }
  uint32_t sent() const { return next_; }
  /// Cycle of the last send; -1 before the first.
  Cycle last_sent() const { return last_sent_; }

 private:
  Cycle available(size_t p) const { return credits_[p].empty() ? kNever : credits_[p].front(); }

  uint32_t rays_;
  std::vector<uint16_t> targets_;
  std::vector<std::deque<Cycle>> credits_;  ///< per pipeline: when each credit may be used
  std::vector<std::deque<Sent>> queues_;    ///< per pipeline: sent, not yet in ray_setup
  uint32_t next_ = 0;
  Cycle next_cycle_ = 0;
  Cycle horizon_ = 0;
  Cycle last_sent_ = -1;
  const PortStalls* stalls_;
};

}  // namespace cuesta
