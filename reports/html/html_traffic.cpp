#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/html/html_sections.h"
#include "reports/html/html_text.h"
#include "reports/html/svg_bar_plot.h"
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

Segment segment_of(const std::string& label, const Part& part, double bytes, double peak, const std::string& more) {
  const std::string share = fmt::format("{:.1f} %", 100 * bytes / peak);
  return {part.colour, bytes / peak, fmt::format("{}\n{}: {}, {} of the peak{}", label, part.label,
                                                readable(bytes, "bytes"), share, more), share};
}

Bar peak_bar(const Result& result, const RunEntry& run, const std::vector<Part>& reasons) {
  const double peak = *quantity(run, "dram.peak_bytes");
  const std::string label = label_of(result, run);
  const auto bandwidth = ratio(run, "dram_bandwidth");
  const auto used = ratio(run, "dram_utilisation");
  Bar bar{label, (used ? readable(*used, "fraction") : "") + (bandwidth ? ", " + readable(*bandwidth, "bytes/s") : ""),
          {}, false};
  double sum = 0;
  for (const Part& part : {Part{"dram.read_bytes", "read", "work"}, Part{"dram.write_bytes", "written", "f2-0"}}) {
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
  plot.remark = "The whole width is the " + defined("dram.peak_bytes", "theoretical peak", shown) + " of each run's cycles";
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

/// Where the fills lie between the least that any cache of this line size needs and no cache at all.
std::string ends_plot(const Result& result, const RunGroup& group, ShownNames& shown) {
  static const Part kParts[] = {{"height_l1.compulsory_bytes", "compulsory", "f0-3"},
                                {"height_l1.fill_bytes", "fetched by the L1s", "work"},
                                {"machine.texel_bytes", "without a cache", "rest"}};
  double least = 0, most = 0;
  for (size_t index : group.runs) {
    for (const Part& part : kParts) {
      const double bytes = quantity(result.runs[index], part.name).value_or(0);
      if (bytes > 0) least = least > 0 ? std::min(least, bytes) : bytes;
      most = std::max(most, bytes);
    }
  }
  if (most <= 0) return "";
  BarPlot plot;
  plot.title = "Height bytes fetched, between the two ends";
  plot.remark = "Logarithmic, from " + readable(std::pow(10, std::floor(std::log10(least))), "bytes") + "; a bar ends at " +
                defined("height_l1.compulsory_bytes", "compulsory", shown) + ", " +
                defined("height_l1.fill_bytes", "fetched", shown) + " or " +
                defined("machine.texel_bytes", "no cache", shown) + ", whichever comes next";
  plot.logarithmic = true;
  plot.log_start = std::pow(10, std::floor(std::log10(least)));
  plot.full = most;
  for (const Part& part : kParts) plot.legend.push_back({part.colour, part.label, definition_sentence(part.name)});
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    std::vector<std::pair<double, const Part*>> ends;
    for (const Part& part : kParts) {
      if (const auto bytes = quantity(run, part.name)) ends.push_back({*bytes, &part});
    }
    if (ends.empty()) continue;
    std::stable_sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::string label = label_of(result, run);
    Bar bar{label, readable(quantity(run, "height_l1.fill_bytes").value_or(0), "bytes"), {}, false};
    double before = 0;
    for (const auto& [bytes, part] : ends) {
      bar.segments.push_back({part->colour, bytes - before,
                              fmt::format("{}\n{}: {}\n{}", label, part->label, readable(bytes, "bytes"),
                                          definition_sentence(part->name)), ""});
      before = bytes;
    }
    plot.bars.push_back(bar);
  }
  return svg_bar_plot(plot);
}

}  // namespace

std::string traffic_plots(const Result& result, const RunGroup& group, ShownNames& shown) {
  const std::string plots = peak_plot(result, group, shown) + ends_plot(result, group, shown);
  return plots.empty() ? "" : "<div class=\"grid wide\">" + plots + "</div>";
}

}  // namespace cuesta::html
