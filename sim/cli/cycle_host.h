#pragma once

#include <string>
#include <vector>

#include "sim/cli/run_options.h"
#include "sim/cli/wave_options.h"
#include "sim/session/measure.h"

namespace cuesta {

/// What runs the machines of a command; empty for the direct host. `vcd`: a file for the waves of the one run;
/// empty: none. Throws usage_error for a vcd without the systemc host, and for hardware waves with it.
CycleRunner make_cycle_runner(const Session& session, Host host, const std::string& vcd,
                              const WaveOptions& waves, const std::vector<ResolvedArchitecture>& machines);

}  // namespace cuesta
