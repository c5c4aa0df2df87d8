#pragma once

#include <string>
#include <vector>

#include "reports/study/literature.h"
#include "sim/explore/study/study.h"

namespace cuesta {

/// Asks how many steps, and how unlike each other, each schedule takes; functional, without time.
Study iterations_study();

// Its page, for the plan's file and for tests.
std::string iterations_page(const StudyData& data);
std::string iterations_headline(const StudyData& data);

namespace html {
/// Lists what the literature says of steps.
const std::vector<Statement>& statements_on_steps();
}  // namespace html

}  // namespace cuesta
