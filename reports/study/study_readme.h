#pragma once

#include <string>

#include "reports/study/study_data.h"

namespace cuesta {

/// Writes the note beside a study's files: question, answer in a sentence, what each file is, the command
/// that makes them. `timed`: wall times are among them.
std::string study_readme(const StudyData& data, const std::string& headline, bool timed = false);

}  // namespace cuesta
