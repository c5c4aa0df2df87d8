#pragma once

#include <string>

#include "reports/result.h"

namespace cuesta {

/// Makes report.html, one page that holds all it needs, asks the network for nothing, and reads on a phone.
/// Shows what was counted and leaves out what was not. Throws usage_error for a result without runs.
std::string html_page(const Result& result);

}  // namespace cuesta
