#pragma once

#include "models/units/architecture.h"

namespace cuesta {

/// Throws usage_error for units in hardware, which `run_transaction` (sim/machine/machine.h) cannot run.
void check_loosely_timed(const Architecture& architecture);

}  // namespace cuesta
