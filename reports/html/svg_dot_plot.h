#pragma once

#include <string>
#include <vector>

#include "reports/html/svg_bar_plot.h"

namespace cuesta::html {

/// Several values of one kind on one row.
struct DotRow {
  std::string label;
  std::string value_text;
  std::vector<Segment> dots;  ///< largest first; `value` is the dot's place; `text` is not used
};

struct DotPlot {
  std::string title;   ///< may hold markup
  std::string remark;  ///< may hold markup
  std::vector<LegendEntry> legend;
  std::vector<DotRow> rows;
  std::string unit;  ///< of the labels of the axis, as `readable` takes it
};

/// Draws a <figure>: dots on a logarithmic axis whose ends are powers of ten; values of 0 have no dot.
std::string svg_dot_plot(const DotPlot& plot);

}  // namespace cuesta::html
