#pragma once

#include <string>

#include "sim/cli/command.h"
#include "sim/cli/run_options.h"
#include "sim/session/result_files.h"

namespace cuesta {

/// Loads what the planes are written with, so that what cannot be loaded is found before the work, and makes the
/// folder that -o names, or the next free one of that stem.
ResultFolder open_folder(const RunOptions& options, const std::string& stem);

/// Prints a finished result's table or JSON, and where it lies; gives the verb's exit code: kIncomplete, with a
/// sentence on stderr, when not every planned run is whole.
ExitCode print_result(const Result& result, const Completion& done, const ResultFolder& folder, bool json);

}  // namespace cuesta
