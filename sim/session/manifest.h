#pragma once

#include <string>
#include <vector>

#include "reports/result.h"
#include "sim/config/architecture_file.h"
#include "sim/session/job.h"

namespace cuesta {

/// Begins a result: `command` is what made it ("run", "compare"), `command_line` how it was asked for; the manifest
/// holds version, compiler, libraries, this host and the time of day.
Result begin_result(const std::string& command, const std::string& command_line);

/// Takes over the files that a job has read, without repeating one, and its seeds.
void add_inputs(const Job& job, Result& result);

/// Takes over the files that the machines were read from, with their digests.
void add_inputs(const std::vector<ResolvedArchitecture>& machines, Result& result);

}  // namespace cuesta
