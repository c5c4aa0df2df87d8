#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reports/html/html_sections.h"
#include "reports/html/html_text.h"
#include "reports/html/svg_bar_plot.h"
#include "reports/numbers.h"
#include "reports/quantities.h"

namespace cuesta::html {
namespace {

/// Counters of the traverse unit that begin so are uses of its cycles; they add up to `traverse.cycles`.
constexpr std::string_view kFamilies[] = {"traverse.slots_", "traverse.bubble_", "traverse.stall_"};

struct Reason {
  std::string name;   ///< "traverse.slots_step"
  std::string label;  ///< "slots: step"
  std::string colour;
};

std::string words(std::string_view name) {
  std::string text(name.substr(name.find('.') + 1));
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// Every reason that some run has, families in order, the step first.
std::vector<Reason> reasons_of(const Result& result, const RunGroup& group) {
  std::vector<Reason> reasons;
  for (size_t family = 0; family < std::size(kFamilies); ++family) {
    std::set<std::string> names;
    for (size_t index : group.runs) {
      for (const auto& [path, value] : result.runs[index].measurements.counters.all()) {
        const std::string name = without_index(path);
        if (name.starts_with(kFamilies[family])) names.insert(name);
      }
    }
    int shade = 0;
    if (names.erase("traverse.slots_step") > 0)
      reasons.push_back({"traverse.slots_step", "slots step", "work"});
    for (const std::string& name : names) {
      reasons.push_back({name, words(name), fmt::format("f{}-{}", family, shade++ % 5)});
    }
  }
  return reasons;
}

Bar bar_for(const RunEntry& run, const std::string& label, const std::vector<Reason>& reasons,
            const std::string& unit, double full) {
  auto count = [&](const std::string& name) -> double {
    const Counters& counters = run.measurements.counters;
    if (unit.empty()) return static_cast<double>(counter_total(counters, name).value_or(0));
    return static_cast<double>(counters.get(unit + name.substr(name.find('.'))));
  };
  const double cycles = count("traverse.cycles");
  Bar bar{label, grouped(static_cast<int64_t>(cycles)) + " cycles", {}, false};
  double sum = 0;
  for (const Reason& reason : reasons) {
    const double value = count(reason.name);
    const std::string share = fmt::format("{:.1f} %", cycles > 0 ? 100 * value / cycles : 0);
    sum += value;
    bar.segments.push_back(
        {reason.colour, value,
         fmt::format("{}\n{}: {} cycles, {}\n{}", label, reason.label, grouped(static_cast<int64_t>(value)),
                     share, definition_sentence(reason.name)),
         full > 0 && value / full > 0.05 ? share : ""});
  }
  if (cycles > sum) {
    bar.segments.push_back(
        {"unknown", cycles - sum,
         fmt::format("{}\nnot accounted for: {} cycles", label, grouped(static_cast<int64_t>(cycles - sum))),
         ""});
  }
  return bar;
}

}  // namespace

std::string utilisation_plots(const Result& result, const RunGroup& group, ShownNames& shown) {
  const std::vector<Reason> reasons = reasons_of(result, group);
  double full = 0;
  int64_t pipelines = 0;
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    full = std::max(full, quantity(run, "traverse.cycles").value_or(0));
    pipelines = std::max(pipelines, run.machine.pipelines());
  }
  if (reasons.empty() || full <= 0) return "";
  BarPlot plot;
  plot.title = "What each pipeline cycle was used for";
  plot.remark =
      "Sum over all pipelines; the bars' lengths are " + defined("traverse.cycles", "pipeline cycles", shown);
  for (const Reason& reason : reasons) {
    shown.insert(reason.name);
    plot.legend.push_back({reason.colour, reason.label, definition_sentence(reason.name)});
  }
  plot.full = full;
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    if (quantity(run, "traverse.cycles"))
      plot.bars.push_back(bar_for(run, label_of(result, run), reasons, "", full));
  }
  std::string html = svg_bar_plot(plot);
  if (pipelines < 2) return html;
  BarPlot each;
  each.title = "The same for each pipeline";
  each.legend = plot.legend;
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    for (int64_t p = 0; p < run.machine.pipelines(); ++p) {
      const std::string unit = fmt::format("traverse[{}]", p);
      const auto cycles = static_cast<double>(run.measurements.counters.get(unit + ".cycles"));
      each.full = std::max(each.full, cycles);
    }
  }
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    for (int64_t p = 0; p < run.machine.pipelines(); ++p) {
      const std::string unit = fmt::format("traverse[{}]", p);
      each.bars.push_back(bar_for(run, label_of(result, run) + ", " + unit, reasons, unit, each.full));
    }
  }
  return html + "<details><summary>Each pipeline</summary>" + svg_bar_plot(each) + "</details>";
}

}  // namespace cuesta::html
