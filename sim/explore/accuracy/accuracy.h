#pragma once

#include <string>

#include "sim/explore/study/study.h"

namespace cuesta {

/// Asks how wrong each algorithm is, and what being right costs in steps, cycles and bytes.
Study accuracy_study();

// Its page, for the plan's file and for tests.
std::string accuracy_page(const StudyData& data);
std::string accuracy_timed_page(const StudyData& data, const StudyTimes& times);
std::string accuracy_headline(const StudyData& data);

}  // namespace cuesta
