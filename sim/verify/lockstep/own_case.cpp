#include "sim/verify/lockstep/own_case.h"

#include <fmt/core.h>

#include <utility>

#include "models/common/error.h"
#include "sim/config/on_architecture.h"

namespace cuesta {

void check_hardware_algorithm(const Algorithm& algorithm) {
  if (algorithm.exact()) return;
  throw usage_error("The hardware has exact algorithms, and " + algorithm.id +
                    " is a search; accepted by `cuesta verify rtl` are exact algorithms and schedules.");
}

void check_hardware_stalls(const PortStalls& stalls, HardwareUnit unit, const std::string& option) {
  if (unit != HardwareUnit::kHmtTop || stalls.per_mille[static_cast<int>(Port::kSetup)] == 0) return;
  throw usage_error(
      option +
      ": the third port, setup, is inside hmt_top, where nothing can hold it back; accepted is 0 "
      "there, or --unit traverse.");
}

LockstepCase own_case(Job job, const Algorithm& algorithm, const LockstepMachine& machine) {
  check_hardware_algorithm(algorithm);
  LockstepCase one;
  one.machine = machine;
  one.machine.schedule = algorithm_on(algorithm, machine.architecture.traverse).schedule;
  if (one.machine.schedule.stop_level > job.map.root_level) {
    throw usage_error(
        fmt::format("Algorithm {} stops at level {}, above the root of the map; accepted are levels 0 to {}.",
                    algorithm.id, one.machine.schedule.stop_level, job.map.root_level));
  }
  one.address_mode = job.map.address_mode;
  one.width = job.trace.width;
  one.height = job.trace.height;
  one.rays = std::move(job.trace.rays);
  one.pyramid = std::make_shared<Pyramid>(std::move(job.pyramid));
  return one;
}

}  // namespace cuesta
