#pragma once

#include <functional>

#include "sim/verify/lockstep/lockstep_case.h"

namespace cuesta {

/// Whether a case still shows what it is kept for. May throw Error for a case that cannot be run: then it does not.
using CaseFails = std::function<bool(const LockstepCase&)>;

struct ShrunkCase {
  LockstepCase smallest;
  int runs = 0;           ///< cases tried
  bool complete = false;  ///< no single step makes it smaller; false: `most_runs` were done
};

/// Makes a failing case smaller for as long as it still fails: at first only rays about the `completed`-th, by which
/// the difference was met; then rays by delta debugging (Zeller & Hildebrandt 2002: halves, quarters ... single
/// ones), one pipeline, ports without stalls, the machine's own dram in the place of the one outside, a quarter of
/// the map, no stop level, from the root; again from the start until nothing helps.
ShrunkCase shrink(const LockstepCase& failing, const CaseFails& fails, uint64_t completed,
                  int most_runs = 2000);

}  // namespace cuesta
