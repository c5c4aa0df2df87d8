#include "reports/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reports/headline.h"
#include "reports/numbers.h"
#include "reports/quantities.h"

namespace cuesta {
namespace {

struct TextColumn {
  const char* name;
  const char* heading;
  const char* unit;          ///< second line of the heading
  const char* against;       ///< not "": the change of that number against the baseline
  const char* absent = "-";  ///< for runs without the number, where others have it
};

constexpr TextColumn kTextColumns[] = {
    {"wrong_rays", "wrong", "rays", "", "exact"}, {"nan_rays", "NaN", "rays", ""},
    {"endless_rays", "endless", "rays", ""},      {"steps_per_ray", "steps", "/ray", ""},
    {"", "", "vs oh2006", "steps_per_ray"},       {"machine.cycles", "cycles", "", ""},
    {"", "", "vs oh2006", "machine.cycles"},      {"rays_per_second", "rays", "/s", ""},
    {"frames_per_second", "frames", "/s", ""},    {"step_utilisation", "slots", "stepping", ""},
    {"l1_hit_rate", "L1", "hit rate", ""},        {"dram.bytes", "DRAM", "bytes", ""},
    {"dram_bytes_per_ray", "bytes", "/ray", ""},  {"dram_utilisation", "DRAM", "peak used", ""},
};

std::string text_of(const Result& result, const RunEntry& run, const TextColumn& column) {
  if (column.against[0] != '\0') {
    const auto change = against_baseline(result, run, column.against);
    return change ? signed_percent(*change) : "";
  }
  const RatioDefinition* definition = find_ratio(column.name);
  const auto value = definition != nullptr ? ratio(run, column.name) : quantity(run, column.name);
  if (!value) return "";
  if (definition == nullptr) {
    const bool bytes = std::string_view(column.unit) == "bytes";
    return bytes ? readable(*value, "bytes") : grouped(static_cast<int64_t>(*value));
  }
  if (definition->unit == "fraction") return readable(*value, "fraction");
  return definition->unit == "rays/s" ? with_prefix(*value, "") : significant(*value, 3);
}

std::string trimmed(std::string line) {
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line + "\n";
}

std::string block(const Result& result, const RunGroup& group) {
  const RunEntry& first = result.runs[group.runs.front()];
  const std::string baseline = baseline_name(result, group);
  std::vector<std::vector<std::string>> columns = {{"", "algorithm"}};
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    columns[0].push_back(label_of(result, run) + (run.partial() ? " (partial)" : ""));
  }
  for (const TextColumn& column : kTextColumns) {
    std::vector<std::string> cells = {column.heading, column.unit};
    if (column.against[0] != '\0' && !baseline.empty()) cells[1] = "vs " + baseline;
    bool some = false;
    for (size_t index : group.runs) {
      cells.push_back(text_of(result, result.runs[index], column));
      some = some || !cells.back().empty();
      if (cells.back().empty()) cells.back() = column.absent;
    }
    if (some) columns.push_back(cells);
  }
  const bool same_machine = std::all_of(group.runs.begin(), group.runs.end(), [&](size_t index) {
    return result.runs[index].architecture == first.architecture;
  });
  std::string text =
      fmt::format("{}: {} rays, {}, {}\n", first.scene, grouped(static_cast<int64_t>(first.all_rays)),
                  same_machine ? first.architecture : "several architectures", first.fidelity);
  for (size_t row = 0; row < columns[0].size(); ++row) {
    std::string line, rule;
    for (size_t c = 0; c < columns.size(); ++c) {
      size_t width = 0;
      for (const std::string& cell : columns[c]) width = std::max(width, cell.size());
      line += c == 0 ? fmt::format("{:<{}}", columns[c][row], width)
                     : fmt::format("  {:>{}}", columns[c][row], width);
      rule += c == 0 ? std::string(width, '-') : "  " + std::string(width, '-');
    }
    text += trimmed(line);
    if (row == 1) text += rule + "\n";
  }
  return text;
}

}  // namespace

std::string print_table(const Result& result) {
  std::string text;
  for (const RunGroup& group : group_by_scene(result)) text += block(result, group) + "\n";
  return result.runs.empty() ? "Nothing ran.\n" : text + headline(result) + "\n";
}

}  // namespace cuesta
