#pragma once

#include <string>

#include "sim/session/job.h"
#include "sim/verify/lockstep/lockstep_case.h"
#include "sim/verify/lockstep/rtl_sides.h"

namespace cuesta {

/// Throws usage_error for a search: the hardware has exact algorithms.
void check_hardware_algorithm(const Algorithm& algorithm);

/// Throws usage_error for stalls at a port that is inside the unit; `option` is for its sentence: "--stalls
/// 5:0,0,9,...".
void check_hardware_stalls(const PortStalls& stalls, HardwareUnit unit, const std::string& option);

/// Makes a case of a user's own rays: those of `job`, under the algorithm, on the machine, which meets what `machine`
/// says of stalls, memory and registers. Throws usage_error for a search, and for a stop level above the map's root.
LockstepCase own_case(Job job, const Algorithm& algorithm, const LockstepMachine& machine);

}  // namespace cuesta
