#pragma once

#include <string>
#include <vector>

#include "reports/study/study_data.h"

namespace cuesta::html {

/// A statement from the literature beside our number.
struct Statement {
  const char* source;
  const char*
      mark;  ///< "printed", "reconstructed" (from what is printed) or "prototype" (an earlier program of ours)
  const char* says;
  std::string (*ours)(const StudyTable& table);  ///< computed from the data; markup
  const char* why;                               ///< why they differ, or what to mind
};

std::string statements(const std::vector<Statement>& all, const StudyTable& table);

/// What the literature says of steps, and of cycles and bytes.
const std::vector<Statement>& statements_on_steps();
const std::vector<Statement>& statements_on_cycles();

}  // namespace cuesta::html
