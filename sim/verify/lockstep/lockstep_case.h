#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "models/heightmap/pyramid.h"
#include "models/rays/traced_ray.h"
#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"
#include "sim/verify/lockstep/random_memory.h"

namespace cuesta {

/// A machine and what it meets in time.
struct LockstepMachine {
  Architecture architecture;
  Schedule schedule;
  PortStalls stalls;      ///< no chance above 0: none
  int register_seed = 0;  ///< hardware: of what registers without a reset begin with; 0: zeros
  std::optional<MemoryTiming>
      memory;  ///< rays and memory from outside; none: all rays at once, the machine's own dram
};

/// One workload on one machine: what two versions of the machine are held against each other with.
struct LockstepCase {
  uint64_t seed = 0;  ///< that it was drawn from; 0: a user's own
  LockstepMachine machine;
  std::shared_ptr<const Pyramid> pyramid;  ///< max, whole
  AddressMode address_mode = AddressMode::kWrap;
  int width = 1, height = 1;    ///< pixels of the frame
  std::vector<TracedRay> rays;  ///< each with its pixel

  MapShape map() const {
    return {pyramid->width(0), pyramid->height(0), pyramid->root_level(), pyramid->bits(), address_mode};
  }
};

/// One of the two versions.
struct LockstepSide {
  std::string name;                                   ///< "model", "RTL"
  std::function<void(LockstepMachine&)> change = {};  ///< what it has of its own; empty: nothing
};

/// Every parameter, the stalls and the memory, one per line.
std::string describe(const LockstepCase& one);

/// "SEED:p,p,p,p,p,p,p,p": chances per mille in the order of Port.
std::string text_of(const PortStalls& stalls);
/// "SEED:LEAST,MOST,GAP", in cycles.
std::string text_of(const MemoryTiming& timing);

}  // namespace cuesta
