#pragma once

#include <signal.h>

#include <string>
#include <vector>

namespace cuesta {

/// What a finished process left.
struct ProgramResult {
  int code = -1;    ///< exit code; 128 + signal when a signal ended it
  std::string out;  ///< stdout
  std::string err;  ///< stderr
};

/// When to send a signal: so long after this text has appeared on stderr.
struct Interrupt {
  std::string after_text;
  int milliseconds = 0;
  int signal = SIGINT;
};

/// Runs `program` with these arguments in `folder` and waits for its end.
ProgramResult run_program(const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& folder, const Interrupt* interrupt = nullptr);

}  // namespace cuesta
