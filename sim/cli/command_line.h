#pragma once

namespace cuesta {

/// Parses the command line and runs the verb; returns the program's exit code. Throws cuesta::Error for wrong
/// usage, and whatever the verb throws.
int run_command_line(int count, const char* const* arguments);

}  // namespace cuesta
