#pragma once

#include <memory>
#include <span>

#include "sim/explore/study/study.h"

namespace cuesta {

/// What is robustness worth? Exact traversals beside the codes as printed, in float with their faults.
StudyData stability_plan(bool quick);
std::unique_ptr<StudyBench> make_stability_bench(const StudyData& plan,
                                                 std::span<const uint16_t> size_and_map);
/// Wall times of the same view for every algorithm: what robustness costs the simulator itself.
StudyTimes stability_times(bool quick, const StudyProgress& progress);

}  // namespace cuesta
