#pragma once

#include <string>

#include "models/units/hit_queue/hit_queue.h"
#include "models/units/hit_sink.h"
#include "models/units/result_writer/result_writer.h"

namespace cuesta {

/// hit_queue, drained by result_writer, as the sink of a pipeline's completions.
class HitDrain final : public HitSink {
 public:
  HitDrain(HitQueue& queue, ResultWriter& writer) : queue_(queue), writer_(writer) {}

  bool has_room(Cycle cycle) override {
    writer_.advance(cycle);
    return !queue_.full();
  }
  Cycle next_room(Cycle limit) override {
    const Cycle popped = writer_.advance_to_pop(limit);
    return popped == kNever ? limit : popped + 1;
  }
  void take(uint32_t ray, Cycle cycle) override { queue_.push(ray, cycle); }
  std::string who_waits() const override {
    return "hit_queue: " + std::to_string(queue_.size()) +
           " records wait for result_writer; result_writer: " + std::to_string(writer_.filled()) +
           " records, " + std::to_string(writer_.unacknowledged()) + " bursts wait for dram";
  }

 private:
  HitQueue& queue_;
  ResultWriter& writer_;
};

}  // namespace cuesta
