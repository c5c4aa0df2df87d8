#pragma once

#include "sim/verify/oracle/oracle_check.h"

namespace cuesta {

/// Prints the counts of one part on stdout, and its first failure decoded; nothing where no ray was asked for.
void print_oracle_part(const OracleCounts& counts, OraclePart part);

}  // namespace cuesta
