#include "reports/html/svg_scatter_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html/html_text.h"
#include "reports/html/svg_bar_plot.h"
#include "reports/numbers.h"

namespace cuesta::html {
namespace {

constexpr int kScatterTop = 30;
constexpr int kScatterHeight = 330;  // down to the least value above 0
constexpr int kZero = 26;            // from there to the line of 0
constexpr int kScatterBottom = 38;
constexpr double kScatterMargin = 3;  // per cent left free at both sides
constexpr double kLargestDot = 13;

/// One logarithmic axis, from a round value below the least to one above the largest.
struct LogAxis {
  double low = 1, high = 10;

  static LogAxis around(double least, double most) {
    if (!(least > 0)) return {};
    const auto decade = [](double value) { return std::pow(10.0, std::floor(std::log10(value * 1.0001))); };
    LogAxis axis{decade(least), decade(most)};
    for (const double step : {2.0, 5.0})
      axis.low = step * decade(least) <= least ? step * decade(least) : axis.low;
    for (const double step : {10.0, 5.0, 2.0, 1.0}) {
      if (step * decade(most) >= most * 0.9999) axis.high = step * decade(most);
    }
    if (axis.high <= axis.low) axis.high = 10 * axis.low;
    return axis;
  }
  double place(double value) const { return std::log(value / low) / std::log(high / low); }
  std::vector<double> ticks() const {
    const bool many = high / low > 300;
    std::vector<double> values;
    for (double decade = std::pow(10.0, std::floor(std::log10(low * 1.0001))); decade <= high * 1.001;
         decade *= 10) {
      for (const double step : {1.0, 2.0, 5.0}) {
        const double value = decade * step;
        if (value > low * 0.999 && value < high * 1.001 && (!many || step == 1.0)) values.push_back(value);
      }
    }
    return values;
  }
};

struct Scales {
  LogAxis x, y;
  double largest_area = 0;

  explicit Scales(const ScatterPlot& plot) {
    double x_least = HUGE_VAL, x_most = 0, y_least = HUGE_VAL, y_most = 0;
    for (const ScatterSeries& series : plot.series) {
      for (const ScatterPoint& point : series.points) {
        x_least = std::min(x_least, point.x);
        x_most = std::max(x_most, point.x);
        if (point.y > 0) y_least = std::min(y_least, point.y);
        y_most = std::max(y_most, point.y);
        largest_area = std::max(largest_area, point.area);
      }
    }
    if (x_most > 0) x = LogAxis::around(x_least, x_most);
    if (y_most > 0) y = LogAxis::around(y_least, y_most);
  }
  double left(double value) const { return kScatterMargin + (100 - 2 * kScatterMargin) * x.place(value); }
  double top(double value) const {
    return value > 0 ? kScatterTop + kScatterHeight * (1 - y.place(value))
                     : kScatterTop + kScatterHeight + kZero;
  }
  double radius(double area) const {
    return largest_area > 0 ? std::max(3.0, kLargestDot * std::sqrt(area / largest_area)) : 5;
  }
};

std::string scatter_axes(const ScatterPlot& plot, const Scales& scales) {
  std::string svg;
  for (const double value : scales.y.ticks()) {
    const double y = scales.top(value);
    svg += fmt::format("<line class=\"grid\" x1=\"0\" x2=\"100%\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>", y);
    svg += fmt::format("<text class=\"tick\" x=\"0\" y=\"{:.1f}\">{}</text>", y - 3, significant(value, 3));
  }
  const double zero = scales.top(0);
  svg += fmt::format("<line class=\"reference\" x1=\"0\" x2=\"100%\" y1=\"{0:.1f}\" y2=\"{0:.1f}\"/>", zero);
  svg += fmt::format("<text class=\"tick\" x=\"0\" y=\"{:.1f}\">0</text>", zero - 3);
  for (const double value : scales.x.ticks()) {
    const double x = scales.left(value);
    svg += fmt::format("<line class=\"grid\" x1=\"{0:.2f}%\" x2=\"{0:.2f}%\" y1=\"{1}\" y2=\"{2:.1f}\"/>", x,
                       kScatterTop, zero);
    svg += fmt::format("<text class=\"tick\" x=\"{:.2f}%\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>", x,
                       zero + 16, escape(with_prefix(value, "")));
  }
  svg += fmt::format("<text class=\"tick\" x=\"100%\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>", zero + 33,
                     escape(plot.x_label));
  return svg + fmt::format("<text class=\"tick\" x=\"0\" y=\"12\">{}</text>", escape(plot.y_label));
}

/// A line between places in the coordinates of the nested svg: per mille across, pixels down.
std::string line_through(const std::vector<const ScatterPoint*>& points, const Scales& scales, bool steps) {
  std::string path;
  double before = 0;
  for (const ScatterPoint* point : points) {
    const double x = 10 * scales.left(point->x), y = scales.top(point->y);
    if (steps && !path.empty()) path += fmt::format("L{:.1f} {:.1f}", x, before);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", x, y);
    before = y;
  }
  return path;
}

}  // namespace

std::vector<const ScatterPoint*> pareto_front(const ScatterPlot& plot) {
  std::vector<const ScatterPoint*> points, front;
  for (const ScatterSeries& series : plot.series) {
    for (const ScatterPoint& point : series.points) points.push_back(&point);
  }
  std::stable_sort(points.begin(), points.end(), [](const ScatterPoint* a, const ScatterPoint* b) {
    return a->x != b->x ? a->x < b->x : a->y < b->y;
  });
  for (const ScatterPoint* point : points) {
    if (front.empty() || point->y < front.back()->y) front.push_back(point);
  }
  return front;
}

std::string svg_scatter_plot(const ScatterPlot& plot) {
  const Scales scales(plot);
  std::vector<LegendEntry> legend;
  for (const ScatterSeries& series : plot.series) legend.push_back({series.css_class, series.label, ""});
  const int height = kScatterTop + kScatterHeight + kZero + kScatterBottom;
  std::string figure = "<figure class=\"plot\"><figcaption>" + plot.title + "<small>" + plot.remark +
                       "</small></figcaption>" + legend_list(legend);
  figure += fmt::format("<svg class=\"scatter\" width=\"100%\" height=\"{}\">", height) +
            scatter_axes(plot, scales);
  figure += fmt::format(
      "<svg x=\"0\" y=\"0\" width=\"100%\" height=\"{0}\" viewBox=\"0 0 1000 {0}\" "
      "preserveAspectRatio=\"none\">",
      height);
  for (const ScatterSeries& series : plot.series) {
    std::vector<const ScatterPoint*> points;
    for (const ScatterPoint& point : series.points) points.push_back(&point);
    if (points.size() < 2) continue;
    figure += fmt::format("<path class=\"line {0}\" data-series=\"{0}\" d=\"{1}\"/>", series.css_class,
                          line_through(points, scales, false));
  }
  if (plot.front) {
    figure += "<path class=\"line front\" d=\"" + line_through(pareto_front(plot), scales, true) + "\"/>";
  }
  figure += "</svg>";
  for (const ScatterSeries& series : plot.series) {
    for (const ScatterPoint& point : series.points) {
      figure += fmt::format(
          "<circle class=\"mark {0}\" data-series=\"{0}\" cx=\"{1:.2f}%\" cy=\"{2:.1f}\" r=\"{3:.1f}\"{4}/>",
          series.css_class, scales.left(point.x), scales.top(point.y), scales.radius(point.area),
          tip_attributes(point.tip));
    }
  }
  return figure + "</svg></figure>\n";
}

}  // namespace cuesta::html
