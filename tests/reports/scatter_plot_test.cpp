#include "reports/html/svg_scatter_plot.h"

#include <gtest/gtest.h>

namespace cuesta::html {
namespace {

ScatterPlot plot_of(std::vector<ScatterPoint> points) {
  ScatterPlot plot;
  plot.series = {{"one", "s0", std::move(points)}};
  plot.front = true;
  return plot;
}

TEST(ScatterPlot, TheFrontHoldsWhatNoOtherPointBeats) {
  const ScatterPlot plot = plot_of({{8, 1, 0, "d"},
                                    {2, 40, 0, "a"},
                                    {4, 50, 0, "worse than a"},
                                    {4, 10, 0, "b"},
                                    {4, 10, 0, "as b"},
                                    {16, 0, 0, "e"},
                                    {32, 0, 0, "slower than e"}});
  std::string names;
  for (const ScatterPoint* point : pareto_front(plot)) names += point->tip + " ";
  EXPECT_EQ(names, "a b d e ");
}

TEST(ScatterPlot, DrawsADotForEveryPointAndALineForZero) {
  const std::string svg = svg_scatter_plot(plot_of({{1, 0, 4, "zero & one"}, {100, 50, 1, "far"}}));
  size_t dots = 0;
  for (size_t at = 0; (at = svg.find("<circle", at)) != std::string::npos; ++at) ++dots;
  EXPECT_EQ(dots, 2u);
  EXPECT_NE(svg.find("zero &amp; one"), std::string::npos);
  EXPECT_NE(svg.find("r=\"13.0\""), std::string::npos);
  EXPECT_NE(svg.find("r=\"6.5\""), std::string::npos);  // a quarter of the area
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(ScatterPlot, WithoutPointsOrWithZerosAloneItStillStands) {
  for (const ScatterPlot& plot : {ScatterPlot{}, plot_of({{5, 0, 0, ""}})}) {
    const std::string svg = svg_scatter_plot(plot);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
  }
}

}  // namespace
}  // namespace cuesta::html
