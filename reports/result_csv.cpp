#include "reports/result_csv.h"

#include <fmt/format.h>

#include <set>

#include "models/units/statistics.h"
#include "reports/quantities.h"

namespace cuesta {
namespace {

std::string cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string names_of(const RunEntry& run) {
  return cell(run.scene) + "," + cell(run.algorithm) + "," + cell(run.architecture) + "," +
         cell(run.fidelity);
}

template <typename Number>
std::string row(const RunEntry& run, std::string_view kind, std::string_view name, Number value,
                std::string_view unit) {
  return fmt::format("{},{},{},{},{}\n", names_of(run), kind, cell(name), value, cell(unit));
}

std::set<std::string> counter_names(const Result& result) {
  std::set<std::string> names;
  for (const RunEntry& run : result.runs) {
    for (const auto& [path, value] : run.measurements.counters.all()) names.insert(without_index(path));
  }
  return names;
}

}  // namespace

std::string result_csv(const Result& result) {
  std::string csv = "scene,algorithm,architecture,fidelity,kind,name,value,unit\n";
  for (const RunEntry& run : result.runs) {
    for (const auto& [path, value] : run.measurements.counters.all()) {
      csv += row(run, "counter", path, value, definition_of(path).unit);
    }
    for (const DerivedQuantity& derived : derived_quantities()) {
      if (const auto value = quantity(run, derived.name))
        csv += row(run, "derived", derived.name, *value, derived.unit);
    }
    for (const Ratio& ratio : ratios_of(run)) {
      csv += row(run, "ratio", ratio.definition->name, ratio.value, ratio.definition->unit);
    }
  }
  return csv;
}

std::string summary_csv(const Result& result) {
  const std::set<std::string> counters = counter_names(result);
  std::string csv = "scene,algorithm,architecture,fidelity,rays_finished,rays";
  for (const std::string& name : counters) csv += "," + cell(name);
  for (const DerivedQuantity& derived : derived_quantities()) csv += "," + cell(derived.name);
  for (const RatioDefinition& definition : ratio_definitions()) csv += "," + cell(definition.name);
  csv += "\n";
  for (const RunEntry& run : result.runs) {
    csv += names_of(run) + fmt::format(",{},{}", run.finished_rays, run.all_rays);
    for (const std::string& name : counters) {
      const auto total = counter_total(run.measurements.counters, name);
      csv += total ? fmt::format(",{}", *total) : ",";
    }
    for (const DerivedQuantity& derived : derived_quantities()) {
      const auto value = quantity(run, derived.name);
      csv += value ? fmt::format(",{}", *value) : ",";
    }
    for (const RatioDefinition& definition : ratio_definitions()) {
      const auto value = ratio(run, definition);
      csv += value ? fmt::format(",{}", value->value) : ",";
    }
    csv += "\n";
  }
  return csv;
}

}  // namespace cuesta
