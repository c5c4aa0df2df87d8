#pragma once

#include "reports/study/study_times.h"
#include "sim/cli/command.h"

namespace cuesta {

/// One frame of the scene `default` on each preset and every level of fidelity, in SystemC, and with waves: wall times of
/// whole runs, the making of rays left out; each the median of three. Levels that this build has not are left out. Throws
/// Error(kMismatch) when levels find different hits.
StudyTimes measure_levels(const Session& session);

}  // namespace cuesta
