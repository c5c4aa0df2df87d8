#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "sim/hardware/rtl_set.h"
#include "sim/session/progress.h"
#include "sim/verify/lockstep/lockstep.h"
#include "sim/verify/lockstep/rtl_sides.h"

namespace cuesta {

/// Random machines with random rays, on which the model is held against the hardware.
struct LockstepCampaign {
  std::vector<rtl::RtlSet> sets;  ///< compiled ones, taken in turn
  HardwareUnit unit = HardwareUnit::kHmtTop;
  uint64_t seed = 1;                  ///< of the first machine; the next has the next
  int workers = 1;                    ///< machines at a time; what is found does not depend on it
  std::optional<uint64_t> ray_count;  ///< ends at so many rays, or, without it,
  int64_t seconds = 20;               ///< after so long
};

/// What came of comparisons of the model with the hardware.
struct LockstepReport {
  uint64_t machines = 0, rays = 0, cycles = 0, requests = 0;
  bool stopped = false;  ///< the observer ended it before its end
  std::optional<LockstepCase>
      failing;          ///< on which the two differ, or both alike stand still; none: all are equal
  LockstepResult last;  ///< of the failing case

  bool differs() const { return failing && !last.equal(); }
  void add(const LockstepCase& one, LockstepResult result);
};

/// Holds the model against the hardware on one case; `sides` of rtl_sides. Throws as run_lockstep.
LockstepReport compare_case(const LockstepCase& one, const std::array<LockstepSide, 2>& sides,
                            Observer& observer);

/// Draws machines and holds the model against the hardware on each, until the campaign is over, the observer ends it,
/// or a case fails; the first failing one, in the order of seeds, is kept. Throws as run_lockstep.
LockstepReport run_campaign(const LockstepCampaign& campaign, const std::array<LockstepSide, 2>& sides,
                            Observer& observer);

}  // namespace cuesta
