#include "reports/html/svg_bar_plot.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/html_text.h"

namespace cuesta::html {
namespace {

constexpr int kLabelHeight = 18;
constexpr int kBarHeight = 16;
constexpr int kBarRowHeight = 44;

double length_of(const Bar& bar) {
  double sum = 0;
  for (const Segment& segment : bar.segments) sum += segment.value;
  return sum;
}

/// Percentage of the plot's width at which `value` stands.
double place(double full, double value) { return full <= 0 ? 0 : 100 * std::clamp(value / full, 0.0, 1.0); }

std::string bar_marks(double full, const Bar& bar, int top) {
  std::string svg = fmt::format("<rect class=\"track\" x=\"0\" y=\"{}\" width=\"100%\" height=\"{}\"/>",
                                top + kLabelHeight, kBarHeight);
  double sum = 0;
  for (const Segment& segment : bar.segments) {
    const double from = place(full, sum);
    sum += segment.value;
    const double width = place(full, sum) - from;
    if (segment.value <= 0) continue;
    svg += fmt::format("<rect class=\"mark {}\" x=\"{:.3f}%\" y=\"{}\" width=\"{:.3f}%\" height=\"{}\"{}/>",
                       segment.css_class, from, top + kLabelHeight, std::max(width, 0.15), kBarHeight,
                       tip_attributes(segment.tip));
    if (!segment.text.empty() && width > 9) {
      svg += fmt::format(
          "<text class=\"in-bar on-{}\" x=\"{:.3f}%\" y=\"{}\" text-anchor=\"middle\">{}</text>",
          segment.css_class, from + width / 2, top + kLabelHeight + kBarHeight - 4, escape(segment.text));
    }
  }
  return svg;
}

}  // namespace

std::string legend_list(const std::vector<LegendEntry>& legend) {
  if (legend.empty()) return "";
  std::string list = "<ul class=\"legend\">";
  for (const LegendEntry& entry : legend) {
    list += fmt::format("<li data-series=\"{0}\"{1}><i class=\"{0}\"></i>{2}</li>", entry.css_class,
                        entry.tip.empty() ? "" : tip_attributes(entry.tip), escape(entry.label));
  }
  return list + "</ul>";
}

std::string svg_bar_plot(const BarPlot& plot) {
  double full = plot.full;
  for (const Bar& bar : plot.bars) full = plot.full > 0 ? full : std::max(full, length_of(bar));
  std::string figure = "<figure class=\"plot\"><figcaption>" + plot.title;
  if (!plot.remark.empty()) figure += "<small>" + plot.remark + "</small>";
  figure += "</figcaption>" + legend_list(plot.legend);
  const auto height = static_cast<int>(plot.bars.size()) * kBarRowHeight;
  figure += fmt::format("<svg class=\"bars\" width=\"100%\" height=\"{}\">", height);
  int top = 0;
  for (const Bar& bar : plot.bars) {
    figure += fmt::format("<text class=\"label{}\" x=\"0\" y=\"{}\">{}</text>", bar.best ? " best" : "",
                          top + 13, escape(bar.label));
    figure += fmt::format("<text class=\"value{}\" x=\"100%\" y=\"{}\" text-anchor=\"end\">{}</text>",
                          bar.best ? " best" : "", top + 13, escape(bar.value_text));
    figure += bar_marks(full, bar, top);
    if (plot.reference > 0) {
      const double x = std::min(99.8, place(full, plot.reference));
      figure +=
          fmt::format("<line class=\"reference\" x1=\"{0:.3f}%\" x2=\"{0:.3f}%\" y1=\"{1}\" y2=\"{2}\"/>", x,
                      top + kLabelHeight - 2, top + kLabelHeight + kBarHeight + 2);
    }
    top += kBarRowHeight;
  }
  return figure + "</svg></figure>\n";
}

}  // namespace cuesta::html
