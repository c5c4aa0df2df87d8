#pragma once

#include <algorithm>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta::twins {

/// ray_dispatch: sends the head ray when its pipeline has a credit; one ray a cycle.
class RayDispatchTwin {
 public:
  struct Sent {
    int ray;
    int pipeline;
  };

  /// `pixels`: y * width + x of each ray in the machine's order.
  RayDispatchTwin(const RayDispatchParameters& parameters, int pipelines, std::span<const uint32_t> pixels,
                  int width, const PortStalls& stalls)
      : parameters_(parameters), pixels_(pixels), width_(width), stalls_(stalls), pipelines_(pipelines) {
    for (Pipeline& pipeline : pipelines_) pipeline.credits = parameters.queue_depth;
  }

  std::optional<Sent> evaluate(Cycle cycle) {
    for (Pipeline& pipeline : pipelines_) pipeline.usable = usable(pipeline, cycle);
    if (all_sent() || stalls_.blocked(Port::kTrace, 0, cycle)) return {};
    const int target = target_of_head();
    if (target < 0 || pipelines_[target].usable == 0) return {};
    sent_ = Sent{next_ray_, target};
    sent_in_ = cycle;
    return sent_;
  }

  /// A ray of the pipeline enters set-up in `cycle`: its place may be used credit_latency_cycles later.
  void give_back(int pipeline, Cycle cycle) {
    pipelines_[pipeline].given_back.push_back(cycle + parameters_.credit_latency_cycles);
  }

  void commit() {
    if (!sent_) return;
    Pipeline& pipeline = pipelines_[sent_->pipeline];
    if (pipeline.credits > 0)
      --pipeline.credits;
    else
      pipeline.given_back.pop_front();
    ++next_ray_;
    if (all_sent()) last_sent_ = sent_in_;
    sent_.reset();
  }

  /// At the end of the cycle before.
  bool all_sent() const { return next_ray_ == static_cast<int>(pixels_.size()); }
  /// The cycle of the last ray's sending, once all are sent; kNever before.
  Cycle last_sent() const { return last_sent_; }

 private:
  struct Pipeline {
    int credits = 0;               ///< never spent since reset
    std::deque<Cycle> given_back;  ///< from which cycle each may be used
    int usable = 0;                ///< in this cycle
  };

  static int usable(const Pipeline& pipeline, Cycle cycle) {
    return pipeline.credits +
           static_cast<int>(std::count_if(pipeline.given_back.begin(), pipeline.given_back.end(),
                                          [&](Cycle from) { return from <= cycle; }));
  }

  int target_of_head() const {
    const int count = static_cast<int>(pipelines_.size());
    if (parameters_.assign == DispatchAssign::kFirstFree) {
      for (int p = 0; p < count; ++p) {
        if (pipelines_[p].usable > 0) return p;
      }
      return -1;
    }
    const int size = parameters_.tile_size;
    const int x = static_cast<int>(pixels_[next_ray_] % static_cast<uint32_t>(width_));
    const int y = static_cast<int>(pixels_[next_ray_] / static_cast<uint32_t>(width_));
    const int tiles_across = (width_ + size - 1) / size;
    return (y / size * tiles_across + x / size) % count;
  }

  RayDispatchParameters parameters_;
  std::span<const uint32_t> pixels_;
  int width_;
  const PortStalls& stalls_;
  std::vector<Pipeline> pipelines_;
  int next_ray_ = 0;
  std::optional<Sent> sent_;
  Cycle sent_in_ = kNever;
  Cycle last_sent_ = kNever;
};

}  // namespace cuesta::twins
