#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/result.h"

namespace cuesta {

/// A number that follows from counters and the machine's parameters, not counted itself.
struct DerivedQuantity {
  std::string_view name;  ///< "dram.peak_bytes"
  std::string_view unit;
  std::string_view sentence;
};

/// A quotient of two quantities.
struct RatioDefinition {
  std::string_view name;       ///< "steps_per_ray"
  std::string_view heading;    ///< short, for tables and plots
  std::string_view unit;       ///< "fraction" is shown in per cent
  std::string_view numerator;  ///< a counter (summed over the instances of its unit) or a derived quantity
  std::string_view denominator;
  int better;  ///< -1: less is better, +1: more is better, 0: neither
  std::string_view sentence;
};

std::span<const DerivedQuantity> derived_quantities();
std::span<const RatioDefinition> ratio_definitions();

/// nullptr when nothing has that name. The statistics' index in brackets is ignored.
const RatioDefinition* find_ratio(std::string_view name);
const StatisticDefinition* find_statistic(std::string_view path);

/// "height_l1[3].misses" -> "height_l1.misses".
std::string without_index(std::string_view path);

/// Value of a counter, summed over the instances of its unit ("height_l1.misses"), or of a derived quantity;
/// nothing where this run did not count it.
std::optional<double> quantity(const RunEntry& run, std::string_view name);

/// Exact sum of a counter over the instances of its unit; nothing where this run did not count it.
std::optional<int64_t> counter_total(const Counters& counters, std::string_view name);

struct Ratio {
  const RatioDefinition* definition;
  double numerator;
  double denominator;
  double value;
};

/// Nothing where a part was not counted or the denominator is 0.
std::optional<Ratio> ratio(const RunEntry& run, const RatioDefinition& definition);
std::optional<double> ratio(const RunEntry& run, std::string_view name);
/// Whether a run may be the best of several: one that is partial, or leaves rays without an answer, has done less than
/// the others.
bool competes(const RunEntry& run);

/// Every ratio that this run has, in the order of the definitions.
std::vector<Ratio> ratios_of(const RunEntry& run);

}  // namespace cuesta
