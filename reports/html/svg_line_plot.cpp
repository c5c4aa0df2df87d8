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

constexpr int kTop = 18;      // room for the highest label
constexpr int kHeight = 220;  // of the area between the axes
constexpr int kBottom = 22;

double y_of(double value, double full) { return kTop + kHeight * (1 - value / full); }

std::string path_of(const LinePlot& plot, const Line& line, double full) {
  std::string path;
  bool pen_down = false;
  for (size_t k = 0; k < plot.places.size(); ++k) {
    if (std::isnan(line.values[k])) {
      pen_down = false;
      continue;
    }
    path += fmt::format("{}{:.2f} {:.2f}", pen_down ? "L" : "M", 1000 * plot.places[k],
                        1000 * (1 - line.values[k] / full));
    pen_down = true;
  }
  return path;
}

std::string axes(const LinePlot& plot, double full) {
  std::string svg;
  for (int k = 0; k <= 4; ++k) {
    const double value = full * k / 4;
    const double y = y_of(value, full);
    svg += fmt::format("<line class=\"grid\" x1=\"0\" x2=\"100%\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>", y);
    svg += fmt::format("<text class=\"tick\" x=\"0\" y=\"{:.1f}\">{}{}</text>", y - 3, significant(value, 3),
                       k == 4 ? " " + escape(plot.y_unit) : "");
  }
  for (const auto& [place, text] : plot.x_ticks) {
    const char* anchor = place < 0.04 ? "start" : place > 0.96 ? "end" : "middle";
    svg += fmt::format("<text class=\"tick\" x=\"{:.2f}%\" y=\"{}\" text-anchor=\"{}\">{}</text>",
                       100 * place, kTop + kHeight + 16, anchor, escape(text));
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
  double highest = 0;
  for (const Line& line : plot.lines) {
    for (double value : line.values) highest = std::isnan(value) ? highest : std::max(highest, value);
  }
  const double full = round_up_nicely(highest);
  std::vector<LegendEntry> legend;
  for (const Line& line : plot.lines) legend.push_back({line.css_class, line.label, ""});
  std::string figure = "<figure class=\"plot lines\"><figcaption>" + plot.title;
  if (!plot.remark.empty()) figure += "<small>" + plot.remark + "</small>";
  figure += "</figcaption>" + legend_list(legend);
  figure += fmt::format(
      "<div class=\"area\" tabindex=\"0\" role=\"img\" aria-label=\"Line plot; arrow keys read values\">"
      "<svg width=\"100%\" height=\"{}\">",
      kTop + kHeight + kBottom);
  figure += axes(plot, full);
  figure += fmt::format(
      "<svg x=\"0\" y=\"{}\" width=\"100%\" height=\"{}\" viewBox=\"0 0 1000 1000\" "
      "preserveAspectRatio=\"none\" overflow=\"visible\">",
      kTop, kHeight);
  for (const Line& line : plot.lines) {
    figure += fmt::format("<path class=\"line {0}\" data-series=\"{0}\" d=\"{1}\"/>", line.css_class,
                          path_of(plot, line, full));
  }
  figure += "</svg>";
  for (const Line& line : plot.lines) {
    for (size_t k = 0; plot.points && k < plot.places.size(); ++k) {
      if (std::isnan(line.values[k])) continue;
      figure +=
          fmt::format("<circle class=\"{0}\" data-series=\"{0}\" cx=\"{1:.2f}%\" cy=\"{2:.1f}\" r=\"4\"/>",
                      line.css_class, 100 * plot.places[k], y_of(line.values[k], full));
    }
  }
  return figure + "</svg></div>" + data_for_script(plot) + "</figure>\n";
}

}  // namespace cuesta::html
