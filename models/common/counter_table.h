#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "models/common/statistics.h"

namespace cuesta {

/// A counter as one statement: its name, what it means, and where a unit keeps it. Beside each unit a table of these is
/// what definitions, collection, registers of the hardware, `cuesta list statistics` and the documentation are made
/// from.
template <class Counts>
struct CounterRow {
  StatisticDefinition definition;
  int64_t Counts::*field = nullptr;                    ///< nullptr: `derived`
  int64_t (*derived)(const Counts& counts) = nullptr;  ///< from other fields
  int rtl_register = -1;  ///< number of the register of hmt_top that counts it in hardware; -1: none

  constexpr CounterRow(std::string_view name, std::string_view unit, std::string_view sentence,
                       int64_t Counts::*counted, int number = -1)
      : definition{name, unit, sentence}, field(counted), rtl_register(number) {}
  constexpr CounterRow(std::string_view name, std::string_view unit, std::string_view sentence,
                       int64_t (*from)(const Counts&))
      : definition{name, unit, sentence}, derived(from) {}

  int64_t value(const Counts& counts) const { return field != nullptr ? counts.*field : derived(counts); }
};

/// Stands for the instance of a unit of which there is one alone: its counters' paths are their names.
inline constexpr int kNoInstance = -1;

/// Sets the counters of a table from what a unit has counted. `instance`: of the unit, as in `height_l1[0].misses`.
template <class Counts, size_t N>
void collect(const CounterRow<Counts> (&table)[N], const Counts& counts, int instance, Counters& into) {
  for (const CounterRow<Counts>& row : table) {
    std::string path(row.definition.name);
    if (instance >= 0) path.insert(path.find('.'), "[" + std::to_string(instance) + "]");
    into.set(path, row.value(counts));
  }
}

}  // namespace cuesta
