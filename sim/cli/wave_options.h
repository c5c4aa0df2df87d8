#pragma once

#include <string>

#include "sim/cli/options.h"
#include "sim/session/measure.h"

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
};

/// Runs the machine with waves of the wanted cycles: those given, or the ones from dispatch to completion of the rays
/// of a pixel, or the first thousand. A pixel's cycles are found by a run of the model before. Throws usage_error for
/// a pixel without rays.
CycleRunner wave_runner(const WaveOptions& options, bool quiet);

}  // namespace cuesta
