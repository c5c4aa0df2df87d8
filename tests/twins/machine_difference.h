#pragma once

#include <string>
#include <vector>

#include "models/common/statistics.h"
#include "tests/twins/random_machine.h"
#include "tests/twins/ticking_machine.h"

namespace cuesta::twins {

/// The ticking machine's run of a random machine, in the order of the trace.
struct TwinRun {
  std::vector<RayTimes> rays;
  std::vector<HitRecord> hits;
  Counters counters;          ///< every counter that the project defines for a cycle run
  std::vector<Plane> planes;  ///< likewise
};

TwinRun run_ticking(const RandomMachine& machine, std::vector<int> evaluation_order = {});

/// Runs both machines: the first difference as a text that names seed, configuration, ray and both values; empty
/// when there is none. Compares hits, per-ray times, slots and memory costs, every counter and plane.
std::string difference(const RandomMachine& machine);

}  // namespace cuesta::twins
