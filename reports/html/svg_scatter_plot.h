#pragma once

#include <string>
#include <vector>

namespace cuesta::html {

struct ScatterPoint {
  double x = 0;     ///< > 0
  double y = 0;     ///< >= 0
  double area = 0;  ///< >= 0: what the dot's area stands for
  std::string tip;
};

/// Points of one kind; more than one are joined by a line in their order.
struct ScatterSeries {
  std::string label;
  std::string css_class;
  std::vector<ScatterPoint> points;
};

struct ScatterPlot {
  std::string title;    ///< may hold markup
  std::string remark;   ///< may hold markup
  std::string x_label;  ///< with its unit, under the axis
  std::string y_label;  ///< with its unit, over the axis
  std::vector<ScatterSeries> series;
  bool front =
      false;  ///< draw the Pareto front: what no other point beats in x and y at once; less is better
};

/// Draws a <figure>. x is logarithmic. y is logarithmic down to a hundredth of its largest decade or less,
/// and 0 has a line of its own at the foot.
std::string svg_scatter_plot(const ScatterPlot& plot);

/// Finds the points that no other beats: less x at no more y, or less y at no more x; by rising x.
std::vector<const ScatterPoint*> pareto_front(const ScatterPlot& plot);

}  // namespace cuesta::html
