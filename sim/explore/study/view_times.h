#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "sim/explore/study/study.h"

namespace cuesta {

/// Measures wall times of one view for each value of a plan's axis `algorithm`: the making of what the rays
/// read (level "map"), and whole runs, "functional" and "cycle" on mobile. `wanted`: axis and value, in the
/// order of the plan's axes but the last, which is `algorithm`; where the plan lacks a value its last one is
/// taken. Throws Error(kIncomplete) when `progress` says no.
StudyTimes view_times(const StudyData& plan,
                      const std::vector<std::pair<std::string_view, std::string_view>>& wanted,
                      const StudyProgress& progress);

}  // namespace cuesta
