#pragma once

#include <string>
#include <vector>

#include "sim/cli/run_options.h"
#include "sim/measure.h"

namespace cuesta {

/// What runs the machines of a command; empty for the direct host. `vcd`: a file for the waves of the one run;
/// empty: none. Throws usage_error for waves without the systemc host.
CycleRunner make_cycle_runner(const Session& session, Host host, const std::string& vcd,
                              const std::vector<ResolvedArchitecture>& machines);

}  // namespace cuesta
