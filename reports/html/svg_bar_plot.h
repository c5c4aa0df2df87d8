#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cuesta::html {

/// A piece of a bar.
struct Segment {
  std::string css_class;  ///< its colour
  double value = 0;       ///< >= 0
  std::string tip;        ///< what pointing shows
  std::string text;       ///< written inside where there is room
};

/// Bars lie on their side, label above at the left, value above at the right: fits a phone and a desk.
struct Bar {
  std::string label;
  std::string value_text;
  std::vector<Segment> segments;  ///< one for a plain bar
  bool best = false;
};

struct LegendEntry {
  std::string css_class;
  std::string label;
  std::string tip;
};

struct BarPlot {
  std::string title;   ///< may hold markup
  std::string remark;  ///< one line under the title; may hold markup
  std::vector<LegendEntry> legend;
  std::vector<Bar> bars;
  double full = 0;       ///< value at the right end; 0: the longest bar
  double reference = 0;  ///< > 0: a dashed line across all bars
};

/// Draws a <figure> with an SVG whose lengths are percentages of its width.
std::string svg_bar_plot(const BarPlot& plot);

std::string legend_list(const std::vector<LegendEntry>& legend);

}  // namespace cuesta::html
