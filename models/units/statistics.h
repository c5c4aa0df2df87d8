#pragma once

#include <span>
#include <string_view>

#include "models/common/statistics.h"

namespace cuesta {

/// Returns every statistic there is: counters, planes and histograms; sorted by name.
std::span<const StatisticDefinition> statistic_definitions();

/// Returns the definition of a counter's path, plane or histogram. Throws (internal error) for a name that no table
/// has.
const StatisticDefinition& definition_of(std::string_view path);

}  // namespace cuesta
