#pragma once

#include <string>

#include "sim/explore/study/study.h"

namespace cuesta {

/// Asks what robustness is worth: exact traversals beside the codes as printed, in float with their faults.
Study stability_study();

// Its page, for the plan's file and for tests.
std::string stability_page(const StudyData& data);
std::string stability_timed_page(const StudyData& data, const StudyTimes& times);
std::string stability_headline(const StudyData& data);

}  // namespace cuesta
