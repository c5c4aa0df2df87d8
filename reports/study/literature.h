#pragma once

#include <string>
#include <vector>

#include "reports/study/study_data.h"

namespace cuesta::html {

/// A statement from the literature that a page sets beside our number.
struct Statement {
  const char* source;
  const char*
      mark;  ///< "printed", "reconstructed" (from what is printed), "prototype" (an earlier program of ours)
  const char* says;
  std::string (*ours)(const StudyTable& table);  ///< computed from the data; markup
  const char* why;                               ///< why they differ, or what to mind
};

/// Makes an article of each statement, with what the data say beside it.
std::string statements(const std::vector<Statement>& all, const StudyTable& table);

}  // namespace cuesta::html
