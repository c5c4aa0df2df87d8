#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reports/html/html_sections.h"
#include "reports/html/html_text.h"
#include "reports/html/svg_bar_plot.h"
#include "reports/html/svg_dot_plot.h"
#include "reports/numbers.h"
#include "reports/quantities.h"

namespace cuesta::html {
namespace {

struct Part {
  std::string name;
  std::string label;
  std::string colour;
};

/// Counters `dram.idle_*` and `dram.bus_idle_*` say why a data bus carried nothing, in memory clocks.
std::vector<Part> idle_reasons(const Result& result, const RunGroup& group) {
  std::set<std::string> names;
  for (size_t index : group.runs) {
    for (const auto& [path, value] : result.runs[index].measurements.counters.all()) {
      const std::string name = without_index(path);
      if (name.starts_with("dram.idle_") || name.starts_with("dram.bus_idle_")) names.insert(name);
    }
  }
  std::vector<Part> reasons;
  for (const std::string& name : names) {
    std::string label = name.substr(name.find('.') + 1);
    std::replace(label.begin(), label.end(), '_', ' ');
    reasons.push_back({name, label, fmt::format("f1-{}", reasons.size() % 5)});
  }
  return reasons;
}

Segment segment_of(const std::string& label, const Part& part, double bytes, double peak,
                   const std::string& more) {
  const std::string share = fmt::format("{:.1f} %", 100 * bytes / peak);
  return {
      part.colour, bytes / peak,
      fmt::format("{}\n{}: {}, {} of the peak{}", label, part.label, readable(bytes, "bytes"), share, more),
      share};
}

Bar peak_bar(const Result& result, const RunEntry& run, const std::vector<Part>& reasons) {
  const double peak = *quantity(run, "dram.peak_bytes");
  const std::string label = label_of(result, run);
  const auto bandwidth = ratio(run, "dram_bandwidth");
  const auto used = ratio(run, "dram_utilisation");
  Bar bar{
      label,
      (used ? readable(*used, "fraction") : "") + (bandwidth ? ", " + readable(*bandwidth, "bytes/s") : ""),
      {},
      false};
  double sum = 0;
  for (const Part& part :
       {Part{"dram.read_bytes", "read", "work"}, Part{"dram.write_bytes", "written", "f2-0"}}) {
    const double bytes = quantity(run, part.name).value_or(0);
    sum += bytes;
    bar.segments.push_back(segment_of(label, part, bytes, peak, ""));
  }
  double clocks = 0;
  for (const Part& part : reasons) clocks += quantity(run, part.name).value_or(0);
  for (const Part& part : reasons) {
    const double share = clocks > 0 ? quantity(run, part.name).value_or(0) / clocks : 0;
    bar.segments.push_back(segment_of(label, part, share * std::max(0.0, peak - sum), peak,
                                      "\n" + definition_sentence(part.name)));
  }
  if (clocks <= 0) {
    bar.segments.push_back(segment_of(label, {"", "not used", "rest"}, std::max(0.0, peak - sum), peak, ""));
  }
  return bar;
}

std::string peak_plot(const Result& result, const RunGroup& group, ShownNames& shown) {
  const std::vector<Part> reasons = idle_reasons(result, group);
  BarPlot plot;
  plot.title = "DRAM traffic against its peak";
  plot.remark = "The whole width is the " + defined("dram.peak_bytes", "theoretical peak", shown) +
                " of each run's cycles";
  plot.legend = {{"work", "read", definition_sentence("dram.read_bytes")},
                 {"f2-0", "written", definition_sentence("dram.write_bytes")}};
  shown.insert({"dram.read_bytes", "dram.write_bytes", "dram_bandwidth", "dram_utilisation"});
  for (const Part& part : reasons) {
    plot.legend.push_back({part.colour, part.label, definition_sentence(part.name)});
    shown.insert(part.name);
  }
  if (reasons.empty()) plot.legend.push_back({"rest", "not used", ""});
  plot.full = 1;
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    if (quantity(run, "dram.peak_bytes").value_or(0) > 0) plot.bars.push_back(peak_bar(result, run, reasons));
  }
  return plot.bars.empty() ? "" : svg_bar_plot(plot);
}

/// Where the fills lie against the least that any cache of this line size needs, and against no cache at all.
std::string ends_plot(const Result& result, const RunGroup& group, ShownNames& shown) {
  static const Part kParts[] = {{"height_l1.compulsory_bytes", "compulsory", "f0-1"},
                                {"machine.texel_bytes", "without a cache", "f1-2"},
                                {"height_l1.fill_bytes", "fetched by the L1s", "work"}};
  DotPlot plot;
  plot.title = "Height bytes fetched, between the two ends";
  plot.remark = "Logarithmic; " + defined("height_l1.compulsory_bytes", "compulsory", shown) +
                ": each line once; " + defined("machine.texel_bytes", "without a cache", shown) +
                ": each texel alone. Right: " + defined("height_l1.fill_bytes", "fetched", shown);
  plot.unit = "bytes";
  for (const Part& part : kParts)
    plot.legend.push_back({part.colour, part.label, definition_sentence(part.name)});
  bool some = false;
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    const auto fetched = quantity(run, "height_l1.fill_bytes");
    if (!fetched) continue;
    some = true;
    const std::string label = label_of(result, run);
    DotRow row{label, readable(*fetched, "bytes"), {}};
    for (const Part& part : kParts) {
      const double bytes = quantity(run, part.name).value_or(0);
      row.dots.push_back({part.colour, bytes,
                          fmt::format("{}\n{}: {}\n{}", label, part.label, readable(bytes, "bytes"),
                                      definition_sentence(part.name)),
                          ""});
    }
    plot.rows.push_back(row);
  }
  return some ? svg_dot_plot(plot) : "";
}

}  // namespace

std::string traffic_plots(const Result& result, const RunGroup& group, ShownNames& shown) {
  const std::string plots = peak_plot(result, group, shown) + ends_plot(result, group, shown);
  return plots.empty() ? "" : "<div class=\"grid wide\">" + plots + "</div>";
}

}  // namespace cuesta::html
