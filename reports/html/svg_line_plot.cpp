#include "reports/html/svg_line_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/html/html_text.h"
#include "reports/html/svg_bar_plot.h"
#include "reports/numbers.h"

namespace cuesta::html {
namespace {

constexpr int kLineTop = 18;      // room for the highest label
constexpr int kLineHeight = 220;  // of the area between the axes
constexpr int kLineBottom = 22;

/// The y axis: from `low` (0, or above it where logarithmic) to `high`.
struct LineAxis {
  bool logarithmic;
  double low, high;

  /// 0 at the foot, 1 at the top.
  double place(double value) const {
    if (!logarithmic) return value / high;
    return std::log(value / low) / std::log(high / low);
  }
  double y(double value) const { return kLineTop + kLineHeight * (1 - place(value)); }
  std::vector<double> ticks() const {
    std::vector<double> values;
    if (!logarithmic) {
      for (int k = 0; k <= 4; ++k) values.push_back(high * k / 4);
      return values;
    }
    const bool decades = high / low > 500;
    for (double decade = std::pow(10.0, std::floor(std::log10(low * 1.0001))); decade <= high; decade *= 10) {
      for (double step : {1.0, 2.0, 5.0}) {
        const double value = decade * step;
        if (value > low * 0.999 && value < high * 1.001 && (!decades || step == 1.0)) values.push_back(value);
      }
    }
    return values;
  }
};

LineAxis axis_of(const LinePlot& plot) {
  double highest = plot.reference, lowest = plot.reference > 0 ? plot.reference : HUGE_VAL;
  for (const Line& line : plot.lines) {
    for (double value : line.values) {
      if (std::isnan(value)) continue;
      highest = std::max(highest, value);
      lowest = std::min(lowest, value);
    }
  }
  if (!plot.logarithmic || !(lowest > 0) || !std::isfinite(lowest))
    return {false, 0, round_up_nicely(highest)};
  const double decade = std::pow(10.0, std::floor(std::log10(lowest * 1.0001)));
  double low = decade;
  for (double step : {2.0, 5.0}) low = step * decade <= lowest * 1.0001 ? step * decade : low;
  const double high = round_up_nicely(highest);
  return {true, low, high > low ? high : 10 * low};
}

std::string path_of(const LinePlot& plot, const Line& line, const LineAxis& axis) {
  std::string path;
  bool pen_down = false;
  for (size_t k = 0; k < plot.places.size(); ++k) {
    if (std::isnan(line.values[k])) {
      pen_down = false;
      continue;
    }
    path += fmt::format("{}{:.2f} {:.2f}", pen_down ? "L" : "M", 1000 * plot.places[k],
                        1000 * (1 - axis.place(line.values[k])));
    pen_down = true;
  }
  return path;
}

std::string line_axes(const LinePlot& plot, const LineAxis& axis) {
  std::string svg;
  const std::vector<double> ticks = axis.ticks();
  for (double value : ticks) {
    const double y = axis.y(value);
    svg += fmt::format("<line class=\"grid\" x1=\"0\" x2=\"100%\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>", y);
    svg += fmt::format("<text class=\"tick\" x=\"0\" y=\"{:.1f}\">{}{}</text>", y - 3, significant(value, 3),
                       value == ticks.back() ? " " + escape(plot.y_unit) : "");
  }
  if (plot.reference > 0) {
    svg += fmt::format("<line class=\"reference\" x1=\"0\" x2=\"100%\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>",
                       axis.y(plot.reference));
  }
  for (const auto& [place, text] : plot.x_ticks) {
    const char* anchor = place < 0.04 ? "start" : place > 0.96 ? "end" : "middle";
    svg += fmt::format("<text class=\"tick\" x=\"{:.2f}%\" y=\"{}\" text-anchor=\"{}\">{}</text>",
                       100 * place, kLineTop + kLineHeight + 16, anchor, escape(text));
  }
  return svg;
}

std::string data_for_script(const LinePlot& plot) {
  nlohmann::ordered_json data = {{"places", plot.places}, {"x", plot.place_texts}, {"lines", nullptr}};
  data["lines"] = nlohmann::ordered_json::array();
  for (const Line& line : plot.lines) {
    data["lines"].push_back({{"label", line.label}, {"series", line.css_class}, {"texts", line.texts}});
  }
  const auto replace = nlohmann::ordered_json::error_handler_t::replace;
  return "<script type=\"application/json\">" + safe_json(data.dump(-1, ' ', false, replace)) + "</script>";
}

}  // namespace

std::string svg_line_plot(const LinePlot& plot) {
  const LineAxis axis = axis_of(plot);
  std::vector<LegendEntry> legend;
  for (const Line& line : plot.lines) legend.push_back({line.css_class, line.label, ""});
  std::string figure = "<figure class=\"plot lines\"><figcaption>" + plot.title;
  if (!plot.remark.empty()) figure += "<small>" + plot.remark + "</small>";
  figure += "</figcaption>" + legend_list(legend);
  figure += fmt::format(
      "<div class=\"area\" tabindex=\"0\" role=\"img\" aria-label=\"Line plot; arrow keys read values\">"
      "<svg width=\"100%\" height=\"{}\">",
      kLineTop + kLineHeight + kLineBottom);
  figure += line_axes(plot, axis);
  figure += fmt::format(
      "<svg x=\"0\" y=\"{}\" width=\"100%\" height=\"{}\" viewBox=\"0 0 1000 1000\" "
      "preserveAspectRatio=\"none\" overflow=\"visible\">",
      kLineTop, kLineHeight);
  for (const Line& line : plot.lines) {
    figure += fmt::format("<path class=\"line {0}\" data-series=\"{0}\" d=\"{1}\"/>", line.css_class,
                          path_of(plot, line, axis));
  }
  figure += "</svg>";
  for (const Line& line : plot.lines) {
    for (size_t k = 0; plot.points && k < plot.places.size(); ++k) {
      if (std::isnan(line.values[k])) continue;
      figure +=
          fmt::format("<circle class=\"{0}\" data-series=\"{0}\" cx=\"{1:.2f}%\" cy=\"{2:.1f}\" r=\"4\"/>",
                      line.css_class, 100 * plot.places[k], axis.y(line.values[k]));
    }
  }
  return figure + "</svg></div>" + data_for_script(plot) + "</figure>\n";
}

}  // namespace cuesta::html
