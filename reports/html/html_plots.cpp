#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "reports/headline.h"
#include "reports/html/html_sections.h"
#include "reports/html/html_text.h"
#include "reports/html/svg_bar_plot.h"
#include "reports/html/svg_line_plot.h"
#include "reports/numbers.h"
#include "reports/quantities.h"

namespace cuesta::html {
namespace {

std::optional<double> number(const RunEntry& run, std::string_view name) {
  const auto found = ratio(run, name);
  return found ? found : quantity(run, name);
}

std::string bar_tip(const Result& result, const RunEntry& run, const RatioDefinition& definition,
                    double value) {
  std::string tip = label_of(result, run) + "\n" + readable(value, std::string(definition.unit));
  if (const auto parts = ratio(run, definition)) {
    tip += fmt::format("\n{} / {}\n= {} / {}", definition.numerator, definition.denominator,
                       significant(parts->numerator, 6), significant(parts->denominator, 6));
  }
  const auto change = against_baseline(result, run, definition.name);
  if (change)
    tip += "\n" + signed_percent(*change) + " against " + label_of(result, *baseline_of(result, run));
  return tip;
}

std::string number_plot(const Result& result, const RunGroup& group, const RatioDefinition& definition,
                        ShownNames& shown) {
  BarPlot plot;
  plot.title = defined(definition.name, definition.heading, shown);
  std::optional<double> best;
  for (size_t index : group.runs) {
    const auto value = ratio(result.runs[index], definition.name);
    if (!value || definition.better == 0 || !competes(result.runs[index])) continue;
    if (quantity(result.runs[index], "error.wrong") && definition.name != "wrong_rays" &&
        definition.name != "nan_rays" && definition.name != "endless_rays")
      continue;  // no fair race
    if (!best || (*value - *best) * definition.better > 0) best = value;
  }
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    const auto value = ratio(run, definition.name);
    if (!value) continue;
    const std::string colour = run.algorithm == "oh2006" && group.runs.size() > 1 ? "baseline" : "accent";
    plot.bars.push_back({label_of(result, run),
                         readable(*value, std::string(definition.unit)),
                         {{colour, *value, bar_tip(result, run, definition, *value), ""}},
                         group.runs.size() > 1 && best && *value == *best && competes(run)});
  }
  if (plot.bars.empty()) return "";
  if (definition.unit == "fraction") plot.full = 1;
  const RunEntry* baseline = common_baseline(result, group);
  const auto reference = baseline == nullptr ? std::nullopt : ratio(*baseline, definition.name);
  if (reference && group.runs.size() > 1) plot.reference = *reference;
  return svg_bar_plot(plot);
}

std::vector<int64_t> all_bins(const Result& result, const RunGroup& group, const std::string& name) {
  std::map<int64_t, bool> bins;
  for (size_t index : group.runs) {
    for (const Histogram& histogram : result.runs[index].measurements.histograms) {
      if (histogram.name != name) continue;
      for (size_t k = 0; k < histogram.first.size(); ++k) {
        if (histogram.count[k] > 0) bins[histogram.first[k]] = true;
      }
    }
  }
  std::vector<int64_t> first;
  for (const auto& bin : bins) first.push_back(bin.first);
  return first;
}

std::string histogram_plot(const Result& result, const RunGroup& group, const std::string& name,
                           ShownNames& shown) {
  const std::vector<int64_t> bins = all_bins(result, group, name);
  if (bins.size() < 2) return "";
  const StatisticDefinition* definition = find_statistic(name);
  const std::string unit = definition == nullptr ? "" : std::string(definition->unit);
  LinePlot plot;
  std::string title = name;
  std::replace(title.begin(), title.end(), '_', ' ');
  title[0] = static_cast<char>(title[0] >= 'a' && title[0] <= 'z' ? title[0] - 'a' + 'A' : title[0]);
  plot.title = defined(name, title + " of a ray", shown);
  plot.remark = "Share of the rays in each bin; horizontal: " + escape(unit) + ", logarithmic";
  plot.y_unit = "% of rays";
  const double low = std::log2(static_cast<double>(bins.front()) + 1),
               high = std::log2(static_cast<double>(bins.back()) + 1);
  auto place = [&](int64_t value) {
    return (std::log2(static_cast<double>(value) + 1) - low) / (high - low);
  };
  for (int64_t bin : bins) {
    plot.places.push_back(place(bin));
    plot.place_texts.push_back("from " + grouped(bin) + " " + unit);
  }
  double last = -1;
  for (int64_t decade = 1; decade <= bins.back(); decade *= 10) {
    for (int64_t tick : {decade, 2 * decade, 5 * decade}) {
      if (tick < bins.front() || tick > bins.back() || place(tick) - last < 0.1) continue;
      last = place(tick);
      plot.x_ticks.push_back({last, grouped(tick)});
    }
  }
  std::string rows;
  for (size_t position = 0; position < group.runs.size(); ++position) {
    const RunEntry& run = result.runs[group.runs[position]];
    for (const Histogram& histogram : run.measurements.histograms) {
      if (histogram.name != name) continue;
      int64_t all = 0;
      std::map<int64_t, int64_t> counts;
      for (size_t k = 0; k < histogram.first.size(); ++k) {
        counts[histogram.first[k]] = histogram.count[k];
        all += histogram.count[k];
      }
      Line line{label_of(result, run), series_class(position), {}, {}};
      for (int64_t bin : bins) {
        const int64_t count = counts.contains(bin) ? counts[bin] : 0;
        line.values.push_back(all == 0 ? 0 : 100.0 * static_cast<double>(count) / static_cast<double>(all));
        line.texts.push_back(fmt::format("{:.2f} % ({})", line.values.back(), grouped(count)));
      }
      plot.lines.push_back(line);
      rows += fmt::format(
          "<tr><th scope=\"row\"><i class=\"{}\"></i>{}</th><td>{}</td><td>{}</td><td>{}</td></tr>",
          series_class(position), escape(label_of(result, run)), grouped(histogram.median),
          grouped(histogram.p99), grouped(histogram.max));
    }
  }
  return "<div class=\"with-table\">" + svg_line_plot(plot) +
         "<div class=\"scroll\"><table class=\"numbers\"><thead><tr><th scope=\"col\">" + escape(unit) +
         "</th><th scope=\"col\">median</th><th scope=\"col\">p99</th><th "
         "scope=\"col\">max</th></tr></thead><tbody>" +
         rows + "</tbody></table></div></div>";
}

}  // namespace

std::string number_plots(const Result& result, const RunGroup& group, ShownNames& shown) {
  if (group.runs.size() < 2) return "";  // the table says it all
  std::string plots;
  for (const char* name : {"steps_per_ray", "cycles_per_ray", "wrong_rays", "dram_bytes_per_ray",
                           "l1_hit_rate", "step_utilisation", "frames_per_second"}) {
    plots += number_plot(result, group, *find_ratio(name), shown);
  }
  return plots.empty() ? "" : "<div class=\"grid\">" + plots + "</div>";
}

std::string histogram_plots(const Result& result, const RunGroup& group, ShownNames& shown) {
  std::set<std::string> names;
  for (size_t index : group.runs) {
    for (const Histogram& histogram : result.runs[index].measurements.histograms)
      names.insert(histogram.name);
  }
  std::string plots;
  for (const std::string& name : names) plots += histogram_plot(result, group, name, shown);
  return plots;
}

std::string scene_plots(const Result& result, ShownNames& shown) {
  const std::vector<RunGroup> groups = group_by_scene(result);
  if (groups.size() < 2) return "";
  std::vector<std::string> labels;
  for (const RunEntry& run : result.runs) {
    const std::string label = label_of(result, run);
    if (std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
  }
  std::string plots;
  for (const char* name :
       {"steps_per_ray", "cycles_per_ray", "wrong_rays", "dram_bytes_per_ray", "l1_hit_rate"}) {
    const RatioDefinition& definition = *find_ratio(name);
    LinePlot plot;
    plot.title = defined(name, definition.heading, shown);
    plot.y_unit = definition.unit == "fraction" ? "%" : std::string(definition.unit);
    plot.points = true;
    for (size_t k = 0; k < groups.size(); ++k) {
      plot.places.push_back(0.06 + 0.88 * static_cast<double>(k) / static_cast<double>(groups.size() - 1));
      plot.place_texts.push_back(groups[k].scene);
      plot.x_ticks.push_back({k == 0 ? 0.0 : k + 1 == groups.size() ? 1.0 : plot.places[k], groups[k].scene});
    }
    bool some = false;
    for (size_t series = 0; series < labels.size(); ++series) {
      Line line{labels[series], series_class(series), {}, {}};
      for (const RunGroup& group : groups) {
        line.values.push_back(std::numeric_limits<double>::quiet_NaN());
        line.texts.push_back("-");
        for (size_t index : group.runs) {
          const auto value = number(result.runs[index], name);
          if (label_of(result, result.runs[index]) != labels[series] || !value) continue;
          line.values.back() = definition.unit == "fraction" ? *value * 100 : *value;
          line.texts.back() = readable(*value, std::string(definition.unit));
          some = true;
        }
      }
      plot.lines.push_back(line);
    }
    if (some) plots += svg_line_plot(plot);
  }
  return plots.empty() ? "" : "<div class=\"grid wide\">" + plots + "</div>";
}

}  // namespace cuesta::html
