#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/units/height_l1/counters.h"
#include "models/units/ports/port_stalls.h"
#include "models/units/ray_setup/counters.h"
#include "models/units/traverse/counters.h"

namespace cuesta {

/// The heightmap traversal hardware of one pipeline: ray_setup, traverse and height_l1, between ray_dispatch's
/// queue and hit_queue. Either the model's units, or Verilated RTL in the place of some or all of them.
class HmtUnit {
 public:
  /// Says how full the units are at the end of a cycle.
  struct Fill {
    int rays_before_traverse = 0;  ///< sent by ray_dispatch, not yet in a context
    int contexts = 0;              ///< rays resident in traverse
    int mshrs = 0;                 ///< taken
    int retries = 0;               ///< rays that wait for an MSHR
  };
  struct Counts {
    RaySetupCounts ray_setup;
    TraverseCounts traverse;
    HeightL1Counts height_l1;
  };

  virtual ~HmtUnit() = default;

  /// Does everything that happens in cycles below `limit`. Throws Error(kNoProgress).
  virtual void advance(Cycle limit) = 0;
  /// Returns the next cycle to happen.
  virtual Cycle cycle() const = 0;
  /// Says whether no ray is here and none can come.
  virtual bool finished() const = 0;
  /// Says whether it has nothing to do but to wait for rays from outside.
  virtual bool starved() const = 0;
  /// Counts the cycles from where the unit stopped to the machine's last one, `end` - 1.
  virtual void drain_until(Cycle end) = 0;

  /// Holds the hit stream back until `cycle`, as a hit_queue that is full does.
  virtual void hold_hits_until(Cycle cycle) = 0;
  /// Adds, from now on, the positions in the trace of rays that complete to `rays`, in order.
  virtual void log_completions(std::vector<uint32_t>* rays) = 0;

  /// Returns how many rays have left by the hit stream.
  virtual int64_t completed() const = 0;
  /// As at the end of cycle `end` - 1, which is not below cycle() - 1: a unit that is finished stops earlier. In the
  /// middle of a run ray_setup.rays may be ahead.
  virtual Counts counts(Cycle end) = 0;
  virtual Fill fill() const = 0;
  /// Says how full every queue is and who waits for whom, for the watchdog's message.
  virtual std::string who_waits() const = 0;
};

}  // namespace cuesta
