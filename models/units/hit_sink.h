#pragma once

#include <cstdint>
#include <string>

#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// The contract of what takes the completions of a pipeline's rays: today hit_queue with result_writer behind it; a
/// unit that shades stands in the same place.
///
/// A pipeline asks `has_room` in each cycle in which a ray could leave; without room its pipe stands still, and nothing
/// else is asked of the sink until there is.
class HitSink {
 public:
  HitSink() = default;
  virtual ~HitSink() = default;
  HitSink(const HitSink&) = delete;
  HitSink& operator=(const HitSink&) = delete;

  /// Says whether a completion can be taken in `cycle`; cycles do not go down.
  virtual bool has_room(Cycle cycle) = 0;
  /// Returns the first cycle in which there is room again, or `limit` where that is not below it. The sink is full.
  virtual Cycle next_room(Cycle limit) = 0;
  /// Takes the completion of a ray (position in the machine's order) in `cycle`, in which there is room.
  virtual void take(uint32_t ray, Cycle cycle) = 0;
  /// Says what waits for whom, for the watchdog's message.
  virtual std::string who_waits() const = 0;
};

}  // namespace cuesta
