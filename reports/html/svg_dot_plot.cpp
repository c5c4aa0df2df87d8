#include "reports/html/svg_dot_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html/html_text.h"
#include "reports/numbers.h"

namespace cuesta::html {
namespace {

constexpr int kDotRowHeight = 40;
constexpr int kDotY = 26;         // below the row's top
constexpr double kDotMargin = 2;  // per cent left free at both ends, for dots that lie there

struct DotAxis {
  int low = 0, high = 1;  ///< powers of ten

  double place(double value) const {
    return kDotMargin + (100 - 2 * kDotMargin) * (std::log10(value) - low) / (high - low);
  }
};

DotAxis axis_for(const DotPlot& plot) {
  double least = 0, most = 0;
  for (const DotRow& row : plot.rows) {
    for (const Segment& dot : row.dots) {
      if (dot.value <= 0) continue;
      least = least > 0 ? std::min(least, dot.value) : dot.value;
      most = std::max(most, dot.value);
    }
  }
  if (most <= 0) return {};
  const int low = static_cast<int>(std::floor(std::log10(least)));
  return {low, std::max(low + 1, static_cast<int>(std::ceil(std::log10(most))))};
}

std::string row_marks(const DotRow& row, const DotAxis& axis, int top) {
  double first = 100, last = 0;
  for (const Segment& dot : row.dots) {
    if (dot.value <= 0) continue;
    first = std::min(first, axis.place(dot.value));
    last = std::max(last, axis.place(dot.value));
  }
  std::string svg =
      fmt::format("<text class=\"label\" x=\"0\" y=\"{}\">{}</text>", top + 13, escape(row.label));
  svg += fmt::format("<text class=\"value\" x=\"100%\" y=\"{}\" text-anchor=\"end\">{}</text>", top + 13,
                     escape(row.value_text));
  if (last > first) {
    svg += fmt::format("<line class=\"stem\" x1=\"{:.2f}%\" x2=\"{:.2f}%\" y1=\"{}\" y2=\"{}\"/>", first,
                       last, top + kDotY, top + kDotY);
  }
  int radius = 9;  // falling, so that no dot hides an equal one
  for (const Segment& dot : row.dots) {
    if (dot.value > 0) {
      svg += fmt::format("<circle class=\"mark {}\" cx=\"{:.2f}%\" cy=\"{}\" r=\"{}\"{}/>", dot.css_class,
                         axis.place(dot.value), top + kDotY, radius, tip_attributes(dot.tip));
    }
    radius = std::max(3, radius - 2);
  }
  return svg;
}

}  // namespace

std::string svg_dot_plot(const DotPlot& plot) {
  const DotAxis axis = axis_for(plot);
  const int bottom = static_cast<int>(plot.rows.size()) * kDotRowHeight;
  std::string figure = "<figure class=\"plot\"><figcaption>" + plot.title + "<small>" + plot.remark +
                       "</small></figcaption>" + legend_list(plot.legend);
  figure += fmt::format("<svg class=\"dots\" width=\"100%\" height=\"{}\">", bottom + 18);
  for (int power = axis.low; power <= axis.high; ++power) {
    const double x = axis.place(std::pow(10, power));
    const char* anchor = power == axis.low ? "start" : power == axis.high ? "end" : "middle";
    figure +=
        fmt::format("<line class=\"grid\" x1=\"{0:.2f}%\" x2=\"{0:.2f}%\" y1=\"18\" y2=\"{1}\"/>", x, bottom);
    figure += fmt::format("<text class=\"tick\" x=\"{:.2f}%\" y=\"{}\" text-anchor=\"{}\">{}</text>", x,
                          bottom + 14, anchor, escape(readable(std::pow(10, power), plot.unit)));
  }
  int top = 0;
  for (const DotRow& row : plot.rows) {
    figure += row_marks(row, axis, top);
    top += kDotRowHeight;
  }
  return figure + "</svg></figure>\n";
}

}  // namespace cuesta::html
