#pragma once

#include <string>
#include <vector>

namespace cuesta::html {

struct Line {
  std::string label;
  std::string css_class;
  std::vector<double> values;      ///< as many as the plot's places; NaN: no point there
  std::vector<std::string> texts;  ///< what pointing shows at each place
};

struct LinePlot {
  std::string title;                     ///< may hold markup
  std::string remark;                    ///< may hold markup
  std::vector<double> places;            ///< 0 to 1 along x, rising
  std::vector<std::string> place_texts;  ///< what pointing shows for x
  std::vector<std::pair<double, std::string>> x_ticks;
  std::string y_unit;  ///< written at the top label
  std::vector<Line> lines;
  bool points = false;       ///< marks at the values: for few places
  bool logarithmic = false;  ///< the y axis; values must be > 0. Else it starts at 0
  double reference = 0;      ///< > 0: a dashed line across, on the axis
};

/// Draws a <figure> with an SVG; pointing or the arrow keys show every line's value at the nearest place.
std::string svg_line_plot(const LinePlot& plot);

}  // namespace cuesta::html
