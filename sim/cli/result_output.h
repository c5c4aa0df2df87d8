#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "reports/result.h"
#include "reports/result_folder.h"
#include "sim/cli/run_options.h"
#include "sim/session/measure.h"

namespace cuesta {

/// The folder that -o names, or the next free `results/<stem>-NNN`. Made at the start, so that a folder which may
/// not be written is found before the work and not after it.
ResultFolder open_result_folder(const RunOptions& options, const std::string& stem);

/// Starts a result: version, compiler, libraries, host, command line, time of day.
Result begin_result(const std::string& command, const Session& session);

/// Takes over what a job has read, without repeating an input.
void add_inputs(const Job& job, Result& result);
void add_inputs(const std::vector<ResolvedArchitecture>& machines, Result& result);

/// How long the maps took that searches read: into the manifest, and on stderr where it was long.
void add_preprocessing(const Session& session, const Measurer& measurer, Result& result);

/// Says on stderr what is about to run: rays, heights, and what a file gives that no run uses.
void remark_inputs(const Session& session, const Job& job, const std::vector<ResolvedArchitecture>& machines);

/// Writes everything into the folder, puts it under its name, prints the table or the JSON and where it lies.
/// kIncomplete with a remark when a run is partial or `planned` runs were not all done.
ExitCode finish_result(Result& result, size_t planned, const std::vector<ResolvedArchitecture>& machines,
                       Fidelity fidelity, ResultFolder& folder, const RunOptions& options,
                       std::chrono::steady_clock::time_point start);

}  // namespace cuesta
