#include "reports/study/study_plots.h"

#include <cmath>
#include <limits>

#include "reports/html/html_text.h"
#include "reports/numbers.h"

namespace cuesta::html {

LinePlot lines_over(
    const StudyTable& table, std::string_view axis_name, const std::vector<std::string>& algorithms,
    const std::string& unit, bool logarithmic_x,
    const std::function<std::optional<double>(const std::string&, const std::string&)>& number) {
  const StudyAxis& axis = table.axis(axis_name);
  LinePlot plot;
  plot.y_unit = unit;
  plot.points = true;
  auto at = [&](const std::string& value) {
    return logarithmic_x ? std::log2(number_of_value(value)) : number_of_value(value);
  };
  const double low = at(axis.values.front()), high = at(axis.values.back());
  double last_tick = -1;
  for (const std::string& value : axis.values) {
    const double place = high > low ? 0.05 + 0.9 * (at(value) - low) / (high - low) : 0.5;
    plot.places.push_back(place);
    plot.place_texts.push_back(value + " " + axis.unit);
    const bool end = value == axis.values.back();
    if (!end && (place - last_tick < 0.12 || (high > low && 0.95 - place < 0.12))) continue;
    last_tick = place;
    plot.x_ticks.push_back({place, value + (end ? axis.unit == "degrees" ? "°" : " " + axis.unit : "")});
    if (end) plot.x_ticks.back().first = 1;
  }
  for (size_t k = 0; k < algorithms.size(); ++k) {
    Line line{algorithms[k], series_class(k), {}, {}};
    bool some = false;
    for (const std::string& value : axis.values) {
      const auto found = number(algorithms[k], value);
      some = some || found;
      line.values.push_back(found.value_or(std::numeric_limits<double>::quiet_NaN()));
      line.texts.push_back(found ? significant(*found, 3) + " " + unit : "-");
    }
    if (some) plot.lines.push_back(std::move(line));
  }
  return plot;
}

std::string depth_and_size(const std::string& depth, const std::string& size) {
  return "depth " + depth + ", " + size + " texels";
}

std::string map_plots(const StudyTable& table, const Quotient& quotient, const std::string& depth,
                      const std::string& size, const Where& where, const std::string& unit,
                      bool logarithmic) {
  std::string html = "<div class=\"grid wide\">";
  for (const std::string& map : table.axis("map").values) {
    LinePlot plot = lines_over(
        table, "angle", published(table), unit, false,
        [&](const std::string& algorithm, const std::string& angle) {
          Where all = where;
          all.insert(
              all.end(),
              {{"map", map}, {"size", size}, {"depth", depth}, {"angle", angle}, {"algorithm", algorithm}});
          return median_of(table, all, quotient);
        });
    plot.title = escape(map);
    plot.remark = "against the angle, " + depth_and_size(depth, size);
    plot.logarithmic = logarithmic;
    html += svg_line_plot(plot);
  }
  return html + "</div>";
}

}  // namespace cuesta::html
