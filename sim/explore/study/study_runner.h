#pragma once

#include <cstdint>
#include <vector>

#include "sim/explore/study/study.h"

namespace cuesta {

/// Lists every planned place, the last axis fastest.
std::vector<StudyPlace> planned_places(const Study& study, const StudyData& plan);

/// Runs every planned case on `workers` threads (1 to 64). The data do not depend on their number. Ended
/// early, it holds the finished cases. Cases that `earlier` holds are taken over and not run. Throws what a
/// case throws, once all workers have stopped; usage_error when `earlier` is another study, or one with other
/// conditions or counters.
StudyData run_study(const Study& study, bool quick, int workers, const StudyProgress& progress = {},
                    const StudyData* earlier = nullptr);

/// Runs the given places of a plan, in order, on one thread: what a test compares with published cases.
std::vector<StudyCase> run_cases(const Study& study, const StudyData& plan,
                                 const std::vector<StudyPlace>& places);

}  // namespace cuesta
