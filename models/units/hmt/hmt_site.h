#pragma once

#include <cstdint>
#include <vector>

#include "models/units/architecture.h"
#include "models/units/hit_sink.h"
#include "models/units/memory/memory_port.h"
#include "models/units/ports/port_log.h"
#include "models/units/ports/port_stalls.h"
#include "models/units/ray_dispatch/ray_dispatch.h"
#include "models/work/step_source.h"

namespace cuesta {

/// What the machine knows of a ray in time; the value is in its hit record.
struct RayTiming {
  Cycle completed = -1;      ///< transfer on the hit stream; -1: not finished
  uint32_t latency = 0;      ///< dispatch to completion, cycles
  uint32_t issue_slots = 0;  ///< slots of the traverse pipe that the ray used
  uint32_t misses = 0;       ///< lines fetched for it: misses that it allocated
  FetchCounts fetches;       ///< what its steps read
};

/// When something last moved, for the whole machine.
struct Watchdog {
  Cycle limit = kNever;  ///< cycles without a finished step that are too many
  Cycle last_progress = 0;

  bool expired(Cycle now) const { return now - last_progress > limit; }
};

/// What surrounds the heightmap traversal hardware of one pipeline. References outlive the unit.
struct HmtSite {
  const Architecture& architecture;
  int pipeline;
  uint64_t image_bytes;                ///< of the pyramid image
  const std::vector<uint32_t>& order;  ///< machine's order -> position in the trace
  StepSource& source;
  RayDispatch& dispatch;
  MemoryPort& memory;
  HitSink& sink;  ///< of rays that have ended
  std::vector<HitRecord>& hits;
  std::vector<RayTiming>& timing;
  Watchdog& watchdog;
  const PortStalls* stalls;  ///< nullptr: none
  PortLog* log;              ///< gets what passes the ports; nullptr: not asked for
};

}  // namespace cuesta
