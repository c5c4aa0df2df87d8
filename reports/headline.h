#pragma once

#include <string>

#include "reports/result.h"

namespace cuesta {

/// The sentence to take away: which run needed the fewest cycles (steps, where there is no time), and how it
/// compares with oh2006; for a single run what it took. Partial runs are named and not compared.
std::string headline(const Result& result);

/// (value - baseline) / baseline of a ratio or quantity; nothing where either is missing or partial, or where
/// `run` is the baseline.
std::optional<double> against_baseline(const Result& result, const RunEntry& run, std::string_view name);

}  // namespace cuesta
