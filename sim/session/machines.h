#pragma once

#include <span>
#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "sim/config/architecture_file.h"
#include "sim/session/fidelity.h"

namespace cuesta {

/// Finds the machines of these names (presets or files), in order, each changed by `settings` ("height_l1.ways=8"), and
/// made ready for the fidelity: rtl puts the hardware into its units. Throws usage_error as resolve_architecture does,
/// for two machines of one name, and for a machine that the fidelity cannot run.
std::vector<ResolvedArchitecture> resolve_machines(std::span<const std::string> names,
                                                   const std::vector<std::string>& settings,
                                                   Fidelity fidelity);

/// Throws usage_error where a search cannot go: into hardware, or under a [traverse] section that speaks of a schedule.
void check_searches(std::span<const Algorithm> algorithms, std::span<const ResolvedArchitecture> machines);

/// Gives the pipelines of the machine that has most; 1 without a machine.
int most_pipelines(std::span<const ResolvedArchitecture> machines);

}  // namespace cuesta
