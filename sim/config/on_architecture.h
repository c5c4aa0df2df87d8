#pragma once

#include <span>
#include <vector>

#include "models/algorithms/schedule.h"
#include "models/units/architecture.h"
#include "models/work/workload.h"

// What an architecture's [traverse] section makes of an algorithm and of a map's numbers.

namespace cuesta {

/// Returns the algorithm with what the architecture's [traverse] section says of its schedule; its id is the
/// canonical name.
/// Throws usage_error where that section speaks of a schedule and the algorithm is a search.
Algorithm algorithm_on(const Algorithm& algorithm, const TraverseParameters& traverse);
/// Does the same with several, in order; those that have become the same schedule as an earlier one are left out.
std::vector<Algorithm> distinct_on(const Architecture& architecture, std::span<const Algorithm> algorithms);

/// Returns the widths that the section gives on this map (mantissa 0 = height bits + 4). Throws usage_error for widths
/// that make times or cell indices too long, and for a bilinear surface that they cannot hold.
NumberFormat number_format(const TraverseParameters& traverse, const MapShape& map);

/// Gives the workload the section's arithmetic and number format, for `work.map`. Throws as number_format.
void set_numbers(Workload& work, const Architecture& architecture);

}  // namespace cuesta
