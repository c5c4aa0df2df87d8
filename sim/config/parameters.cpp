#include "sim/config/parameters.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "models/common/words.h"

namespace cuesta {
namespace {

/// A row of a unit's table as a parameter of the whole architecture.
template <auto Section, const auto& kTable, size_t Row>
Parameter of_architecture() {
  constexpr const auto& row = kTable[Row];
  return {{row.path, row.low, row.high, row.names, row.power_of_two, row.use, row.unit, row.meaning,
           row.source, [](const Architecture& a) { return kTable[Row].get(a.*Section); },
           [](Architecture& a, int64_t value) { kTable[Row].set(a.*Section, value); }, row.inert}};
}

template <auto Section, const auto& kTable>
void add(std::vector<Parameter>& all) {
  [&]<size_t... Row>(std::index_sequence<Row...>) {
    (all.push_back(of_architecture<Section, kTable, Row>()), ...);
  }
  (std::make_index_sequence<std::size(kTable)>());
}

/// The sections, along the data's way.
std::vector<Parameter> all_parameters() {
  using A = Architecture;
  std::vector<Parameter> all;
  add<&A::machine, parameter::kMachineParameters>(all);
  add<&A::ray_dispatch, parameter::kRayDispatchParameters>(all);
  add<&A::ray_setup, parameter::kRaySetupParameters>(all);
  add<&A::traverse, parameter::kTraverseParameters>(all);
  add<&A::height_l1, parameter::kHeightL1Parameters>(all);
  add<&A::hit_queue, parameter::kHitQueueParameters>(all);
  add<&A::result_writer, parameter::kResultWriterParameters>(all);
  add<&A::dram, parameter::kDramParameters>(all);
  add<&A::texels, parameter::kTexelParameters>(all);
  add<&A::units, parameter::kUnitParameters>(all);
  return all;
}

}  // namespace

std::string Parameter::accepted() const {
  if (!names.empty()) return "one of " + joined(names);
  const std::string range = " from " + std::to_string(low) + " to " + std::to_string(high);
  return (power_of_two ? "a power of two" : "a whole number") + range;
}

std::string Parameter::text(int64_t value) const {
  if (names.empty()) return std::to_string(value);
  return "\"" + std::string(names[static_cast<size_t>(value)]) + "\"";
}

std::span<const Parameter> parameters() {
  static const std::vector<Parameter> all = all_parameters();
  return all;
}

std::span<const std::string_view> parameter_sections() {
  static const std::vector<std::string_view> sections = [] {
    std::vector<std::string_view> names;
    for (const Parameter& parameter : parameters()) {
      if (names.empty() || names.back() != parameter.section()) names.push_back(parameter.section());
    }
    return names;
  }();
  return sections;
}

const Parameter* find_parameter(std::string_view path) {
  const auto found = std::find_if(parameters().begin(), parameters().end(),
                                  [&](const Parameter& parameter) { return parameter.path == path; });
  return found == parameters().end() ? nullptr : &*found;
}

}  // namespace cuesta
