#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "models/heightmap/pyramid.h"
#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"
#include "sim/machine/machine.h"

namespace cuesta::twins {

/// A random machine with random work.
struct RandomMachine {
  uint64_t seed = 0;
  Architecture architecture;
  PortStalls stalls;
  bool stalled = false;  ///< false: no stalls at all
  Pyramid pyramid;
  MapShape map;
  Schedule schedule;
  std::optional<Search> search;             ///< in the place of the schedule
  std::shared_ptr<const Pyramid> searched;  ///< `pyramid`, in a place that does not change
  std::shared_ptr<const SearchMap> search_map;
  double depth = 0.1;  ///< of the slab, in tile widths, for the search
  std::vector<MachineRay> rays;
  std::vector<uint32_t> pixels;
  int width = 1, height = 1;

  Workload work() const;
};

/// Everything follows from the seed: 1 to 4 pipelines; queues, caches and limits down to 1; clock ratios; any
/// schedule or search, arithmetic, order and layout; a map of at most 64 x 64; at most `most_rays` rays, now
/// and then 12 times as many, now and then none.
RandomMachine random_machine(uint64_t seed, int most_rays);

/// Every parameter, one per line, and the stalls.
std::string describe(const RandomMachine& machine);

}  // namespace cuesta::twins
