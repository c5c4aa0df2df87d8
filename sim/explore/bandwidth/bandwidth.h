#pragma once

#include <string>
#include <vector>

#include "reports/study/literature.h"
#include "sim/explore/study/study.h"

namespace cuesta {

/// Asks how many bytes and cycles the steps cost on a machine; cycle by cycle.
Study bandwidth_study();

// Its page, for the plan's file and for tests.
std::string bandwidth_page(const StudyData& data);
std::string bandwidth_headline(const StudyData& data);

namespace html {
/// Lists what the literature says of cycles and bytes.
const std::vector<Statement>& statements_on_cycles();
}  // namespace html

}  // namespace cuesta
