#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "sim/verify/lockstep/difference.h"
#include "sim/verify/lockstep/lockstep_case.h"

namespace cuesta {

/// What came of two machines that ran side by side.
struct LockstepResult {
  uint64_t rays = 0;                    ///< completed by both
  uint64_t requests = 0;                ///< memory requests compared
  Cycle cycles = 0;                     ///< run through by each
  std::vector<Difference> differences;  ///< all of the first cycle with one, causes first; empty: equal
  bool stopped = false;                 ///< by `watch`, before the end
  std::optional<Error> stuck;  ///< both alike moved no more, or did what no machine may: the words of `left`

  bool equal() const { return differences.empty(); }
};

/// How much is to be known of a difference.
enum class LockstepDepth : uint8_t {
  kWhether,    ///< that there is one: the cycle is known up to a block of cycles
  kFirstCycle  ///< the first cycle in which any port, counter or fill differs
};

/// Hears of rays completed, now and then; false: stop.
using LockstepWatch = std::function<bool(uint64_t rays)>;

/// Runs the case on both sides and compares every port (rays into ray_setup, memory requests, hit records, with their
/// cycles), every counter and every fill block of cycles by block, and at the end what each ray took. After the first
/// difference both run again from reset up to the block, and then cycle by cycle.
/// Throws input_error for a ray that does not fit the machine's numbers, and what a machine's construction throws.
LockstepResult run_lockstep(const LockstepCase& one, const LockstepSide& left, const LockstepSide& right,
                            LockstepDepth depth = LockstepDepth::kFirstCycle,
                            const LockstepWatch& watch = {});

}  // namespace cuesta
