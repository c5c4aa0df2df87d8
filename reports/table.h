#pragma once

#include <string>

#include "reports/result.h"

namespace cuesta {

/// The result as a table of fixed width for the terminal, one block per scene, the headline last. Columns that
/// no run has are left out. Plain ASCII.
std::string print_table(const Result& result);

}  // namespace cuesta
