#pragma once

#include "sim/explore/study/study.h"

namespace cuesta {

/// How many bytes and cycles do the steps cost on a machine? Cycle by cycle.
StudyData bandwidth_plan(bool quick);
bool bandwidth_planned(const StudyData& plan, const StudyPlace& place);
std::unique_ptr<StudyBench> make_bandwidth_bench(const StudyData& plan,
                                                 std::span<const uint16_t> size_and_map);

}  // namespace cuesta
