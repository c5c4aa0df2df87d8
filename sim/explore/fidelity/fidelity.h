#pragma once

#include <string>

#include "sim/explore/study/study.h"

namespace cuesta {

/// Asks what each level of fidelity gets wrong: transaction and functional against cycle, unit by unit.
Study fidelity_study();

// Its page, for the plan's file and for tests.
std::string fidelity_page(const StudyData& data);
std::string fidelity_timed_page(const StudyData& data, const StudyTimes& times);
std::string fidelity_headline(const StudyData& data);

/// How many cycles of one pipeline "rtl with waves" writes down.
inline constexpr int64_t kFidelityWaveCycles = 20'000;
/// Times one frame of the scene `default` on each preset and every level of fidelity, in SystemC, and with
/// waves. Levels that this build has not are left out. Throws Error(kMismatch) when levels find different
/// hits, Error(kIncomplete) when `progress` says no.
StudyTimes fidelity_times(bool quick, const StudyProgress& progress);

}  // namespace cuesta
