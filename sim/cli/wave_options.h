#pragma once

#include <string>

#include "sim/cli/options.h"
#include "sim/session/waves.h"

namespace cuesta {

/// Options for the signals of hardware.
struct WaveOptions {
  std::string file;    ///< empty: none
  std::string cycles;  ///< "1000:1200"
  std::string pixel;   ///< "17,33"
  int pipeline = 0;
  Option pipeline_option;

  void declare(Options& options);
  bool wanted() const { return !file.empty(); }
  /// Throws usage_error for options that do not go together or cannot be read, and for a file that is there.
  void check() const;
  /// Gives what was asked for. Throws as `check`.
  WaveRequest request() const;
};

}  // namespace cuesta
