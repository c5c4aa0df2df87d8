#pragma once

#include "sim/explore/study/study.h"

namespace cuesta {

/// What does each level of fidelity get wrong? Transaction and functional against cycle, unit by unit.
StudyData fidelity_plan(bool quick);
bool fidelity_planned(const StudyData& plan, const StudyPlace& place);
std::unique_ptr<StudyBench> make_fidelity_bench(const StudyData& plan,
                                                std::span<const uint16_t> size_and_map);

/// One frame of the scene `default` on each preset and every level of fidelity, in SystemC, and with waves. Levels that
/// this build has not are left out. Throws Error(kMismatch) when levels find different hits, Error(kIncomplete) when
/// `progress` says no.
StudyTimes fidelity_times(bool quick, const StudyProgress& progress);

}  // namespace cuesta
