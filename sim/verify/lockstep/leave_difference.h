#pragma once

#include <array>
#include <string>

#include "reports/result_folder.h"
#include "sim/session/progress.h"
#include "sim/verify/lockstep/campaign.h"
#include "sim/verify/lockstep/shrink.h"

namespace cuesta {

/// Describes the first difference of a failing case and what differs in the same cycle, decoded.
std::string first_difference(const LockstepResult& result, const std::array<LockstepSide, 2>& sides);

/// The smallest workload that was found to differ as well.
struct SmallestDifference {
  ShrunkCase shrunk;
  LockstepResult result;  ///< of the smallest case
};

/// Makes the failing case of a report that differs smaller for as long as it still differs; the observer may end it.
SmallestDifference shrink_difference(const LockstepReport& report, const std::array<LockstepSide, 2>& sides,
                                     Observer& observer);

/// Leaves the smallest case in `folder` as files that the program reads, with the hardware's waves around the
/// difference and difference.txt, and commits the folder. Gives the text about the smallest case: how it was found,
/// the machine, the difference, and the command that shows it again. Throws what the writers throw.
std::string leave_difference(const LockstepReport& report, const SmallestDifference& smallest,
                             const std::array<LockstepSide, 2>& sides, HardwareUnit unit,
                             ResultFolder& folder);

}  // namespace cuesta
