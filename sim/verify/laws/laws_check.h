#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/config/architecture_file.h"
#include "sim/session/progress.h"

namespace cuesta {

/// Over what the conservation laws of the accounting are held.
struct LawsRequest {
  std::vector<std::string> scenes;  ///< names or files
  std::vector<ResolvedArchitecture> machines;
  int size = 64;  ///< pixels on a side of the frame of every scene that has a camera
};

/// What was run.
struct LawsCounts {
  uint64_t runs = 0;
  uint64_t planned = 0;  ///< runs in all
  uint64_t rays = 0;     ///< of all runs
  bool stopped = false;  ///< the observer ended it before its end
};

/// Runs every published algorithm on every machine over every scene at functional, cycle and transaction fidelity. Each
/// run checks its own laws, and all three must find the same hits and steps. Throws Error(kMismatch) for the first that
/// does not, and what making a scene ready throws.
LawsCounts check_laws(const LawsRequest& request, Observer& observer);

}  // namespace cuesta
