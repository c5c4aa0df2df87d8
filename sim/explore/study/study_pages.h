#pragma once

#include <string>

#include "reports/study/study_data.h"
#include "reports/study/study_times.h"

namespace cuesta {

// Each page is one self-contained HTML file made from the data alone; each headline the sentence on its top. Every
// number on them is computed from the data or printed in the literature, and says which.

std::string accuracy_headline(const StudyData& data);
std::string accuracy_page(const StudyData& data);
/// With wall times, measured apart.
std::string accuracy_timed_page(const StudyData& data, const StudyTimes& times);

std::string iterations_headline(const StudyData& data);
std::string iterations_page(const StudyData& data);

std::string precision_headline(const StudyData& data);
std::string precision_page(const StudyData& data);

std::string bandwidth_headline(const StudyData& data);
std::string bandwidth_page(const StudyData& data);

std::string fidelity_headline(const StudyData& data);
std::string fidelity_page(const StudyData& data);
/// With wall times, measured apart.
std::string fidelity_timed_page(const StudyData& data, const StudyTimes& times);

std::string stability_headline(const StudyData& data);
std::string stability_page(const StudyData& data);
/// With wall times, measured apart.
std::string stability_timed_page(const StudyData& data, const StudyTimes& times);

}  // namespace cuesta
