#pragma once

#include <memory>
#include <span>

#include "sim/explore/study/study.h"

namespace cuesta {

/// How wrong is each algorithm, and what does being right cost in steps, cycles and bytes?
StudyData accuracy_plan(bool quick);
std::unique_ptr<StudyBench> make_accuracy_bench(const StudyData& plan,
                                                std::span<const uint16_t> size_and_map);

/// One view of the study for each value of its axis `algorithm`: the making of what the rays read, and the run,
/// functional and cycle by cycle on mobile. Throws Error(kIncomplete) when `progress` says no.
StudyTimes accuracy_times(bool quick, const StudyProgress& progress);

}  // namespace cuesta
