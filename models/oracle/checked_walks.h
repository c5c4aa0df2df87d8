#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "models/oracle/random_cases.h"
#include "models/rays/hit.h"

// What the checks of traversals share.

namespace cuesta {

/// One line each, for a failure's report.
std::string describe(const HitRecord& record);
std::string describe(const Schedule& schedule);

/// Hit, cell, t and face; not the steps.
bool same_answer(const HitRecord& a, const HitRecord& b);

/// `dda` first, then every named schedule; with `all_combinations` also 3 starts x 4 downs x 8 ups.
std::vector<Schedule> checked_schedules(bool all_combinations, int stop_level);

}  // namespace cuesta
