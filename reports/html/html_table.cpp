#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "reports/headline.h"
#include "reports/html/html_sections.h"
#include "reports/html/html_text.h"
#include "reports/numbers.h"
#include "reports/quantities.h"

namespace cuesta::html {
namespace {

struct HtmlColumn {
  const char* group;
  const char* name;  ///< ratio, counter or derived quantity
  const char* heading;
  int better;    ///< -1, 0, +1
  bool compare;  ///< with the baseline, in small print
};

constexpr HtmlColumn kHtmlColumns[] = {
    {"Work", "steps_per_ray", "steps / ray", -1, true},
    {"Work", "rays_hit", "rays that hit", 0, false},
    {"Work", "wrong_rays", "rays wrong", -1, false},
    {"Work", "nan_rays", "at NaN", -1, false},
    {"Work", "endless_rays", "endless", -1, false},
    {"Time", "machine.cycles", "cycles", -1, true},
    {"Time", "cycles_per_ray", "cycles / ray", -1, false},
    {"Time", "rays_per_second", "rays / s", 1, false},
    {"Time", "frames_per_second", "frames / s", 1, false},
    {"Time", "step_utilisation", "slots that step", 0, false},
    {"L1", "l1_hit_rate", "hit rate", 1, false},
    {"L1", "height_l1.unique_lines", "unique lines", -1, false},
    {"L1", "refetch_factor", "fills / compulsory", -1, false},
    {"Memory", "dram.bytes", "DRAM bytes", -1, true},
    {"Memory", "dram_bytes_per_ray", "bytes / ray", -1, false},
    {"Memory", "machine.texel_bytes", "bytes without cache", -1, false},
    {"Memory", "dram_utilisation", "peak used", 0, false},
};

std::optional<double> ratio_or_quantity(const RunEntry& run, const char* name) {
  const auto found = ratio(run, name);
  return found ? found : quantity(run, name);
}

std::string unit_of(const char* name) {
  if (const RatioDefinition* definition = find_ratio(name)) return std::string(definition->unit);
  if (const StatisticDefinition* definition = find_statistic(name)) return std::string(definition->unit);
  return "bytes";
}

std::string cell_text(double value, const char* name) {
  if (const RatioDefinition* definition = find_ratio(name)) {
    const std::string unit(definition->unit);
    if (unit == "fraction") return readable(value, unit);
    if (unit == "rays/s") return with_prefix(value, "");
    return significant(value, 3);
  }
  if (unit_of(name) == "bytes") return readable(value, "bytes");
  return grouped(static_cast<int64_t>(value));
}

std::vector<HtmlColumn> columns_with_values(const Result& result, const RunGroup& group) {
  std::vector<HtmlColumn> columns;
  for (const HtmlColumn& column : kHtmlColumns) {
    for (size_t index : group.runs) {
      if (!ratio_or_quantity(result.runs[index], column.name)) continue;
      columns.push_back(column);
      break;
    }
  }
  return columns;
}

std::string table_head(const std::vector<HtmlColumn>& columns, ShownNames& shown) {
  std::string groups = "<tr><td></td>", names = "<tr><th scope=\"col\">algorithm</th>";
  for (size_t k = 0; k < columns.size();) {
    size_t end = k;
    while (end < columns.size() && std::string_view(columns[end].group) == columns[k].group) ++end;
    groups += fmt::format("<th class=\"group\" colspan=\"{}\">{}</th>", end - k, columns[k].group);
    k = end;
  }
  for (const HtmlColumn& column : columns) {
    names += "<th scope=\"col\">" + defined(column.name, column.heading, shown) + "</th>";
  }
  return "<thead>" + groups + "</tr>" + names + "</tr></thead>";
}

/// The best value among runs that compete, where more than one has it and they differ.
std::optional<double> best_of(const Result& result, const RunGroup& group, const HtmlColumn& column) {
  std::optional<double> best;
  bool differ = false;
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    const auto value = ratio_or_quantity(run, column.name);
    if (!value || column.better == 0 || !competes(run)) continue;
    differ = differ || (best && *best != *value);
    if (!best || (*value - *best) * column.better > 0) best = value;
  }
  return differ ? best : std::nullopt;
}

std::string cell_of(const Result& result, const RunEntry& run, const HtmlColumn& column,
                    std::optional<double> best) {
  const auto value = ratio_or_quantity(run, column.name);
  if (!value) return "<td class=\"none\">-</td>";
  const bool is_best = best && *value == *best && competes(run);
  std::string exact = *value == std::floor(*value) && std::fabs(*value) < 1e15
                          ? grouped(static_cast<int64_t>(*value))
                          : significant(*value, 7);
  std::string unit = unit_of(column.name);
  std::string cell =
      fmt::format("<td{} data-tip=\"{}\">{}", is_best ? " class=\"best\"" : "",
                  escape(exact + (unit.empty() ? "" : " " + unit)), escape(cell_text(*value, column.name)));
  const auto change = column.compare ? against_baseline(result, run, column.name) : std::nullopt;
  if (change) cell += "<small>" + escape(signed_percent(*change)) + "</small>";
  return cell + "</td>";
}

}  // namespace

std::string comparison_table(const Result& result, const RunGroup& group, ShownNames& shown) {
  const std::vector<HtmlColumn> columns = columns_with_values(result, group);
  std::string html =
      "<div class=\"scroll\"><table class=\"numbers\">" + table_head(columns, shown) + "<tbody>";
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    html += "<tr><th scope=\"row\">" + escape(label_of(result, run));
    if (run.partial()) {
      html += fmt::format("<small>partial: {} of {} rays</small>",
                          grouped(static_cast<int64_t>(run.finished_rays)),
                          grouped(static_cast<int64_t>(run.all_rays)));
    }
    html += "</th>";
    for (const HtmlColumn& column : columns)
      html += cell_of(result, run, column, best_of(result, group, column));
    html += "</tr>";
  }
  html += "</tbody></table></div>";
  const std::string baseline = baseline_name(result, group);
  if (group.runs.size() > 1 && !baseline.empty()) {
    html += "<p class=\"note\">Best in bold; small percentages are against " + escape(baseline) +
            (common_baseline(result, group) == nullptr ? " on the same machine" : "") +
            ". Pointing shows every digit.</p>";
  }
  return html;
}

}  // namespace cuesta::html
