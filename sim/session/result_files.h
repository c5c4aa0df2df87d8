#pragma once

#include <chrono>
#include <string>

#include "reports/result.h"
#include "reports/result_folder.h"
#include "sim/session/measure_scenes.h"

namespace cuesta {

/// How much of what was planned is there.
struct Completion {
  size_t whole = 0;    ///< runs that were not ended early
  size_t planned = 0;  ///< runs in all

  bool complete() const { return whole == planned; }
};

/// Makes the folder of that name, or without a name the next free `results/<stem>-NNN`. To be called before the work,
/// so that a folder which may not be written is found before it and not after. Throws as ResultFolder::create does.
ResultFolder open_result_folder(const std::string& name, const std::string& stem, bool overwrite);

/// Ends a result and puts it under its name: times of day and how much is whole into the manifest, the machines'
/// configurations, result.json with everything that is made from it, and the planes. `start`: when the work began.
/// Throws Error(kIncomplete) for a result without a run, and keeps nothing then.
Completion finish_result(const RunRequest& wanted, std::chrono::steady_clock::time_point start,
                         Result& result, ResultFolder& folder);

}  // namespace cuesta
