#pragma once

#include <vector>

#include "models/common/port_stalls.h"
#include "models/memory/memory_port.h"
#include "models/traversal/traverse_unit.h"
#include "sim/machine.h"

namespace cuesta {

/// What tests turn that no architecture has.
struct CycleHooks {
  const PortStalls* stalls = nullptr;  ///< back-pressure on the ports
  bool counters_only = false;  ///< no histograms, planes and digests: what a benchmark of the machine times
  bool reverse_construction = false;  ///< build the pipelines last to first: must change nothing
};

/// Per ray, in the order of the trace.
struct CycleDetail {
  std::vector<RayTiming> timing;
  std::vector<MemoryCost> memory;
};

/// `run_cycle` with hooks; `detail` may be nullptr.
Outcome run_cycle_detailed(const Workload& work, const Architecture& architecture, const Progress& progress,
                           const CycleHooks& hooks, CycleDetail* detail);

}  // namespace cuesta
