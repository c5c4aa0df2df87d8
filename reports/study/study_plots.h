#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/html/svg_line_plot.h"
#include "reports/study/study_selection.h"

namespace cuesta::html {

/// Draws a line per algorithm over an axis of numbers; `number` nullopt: no point. Texts carry `unit`.
LinePlot lines_over(const StudyTable& table, std::string_view axis,
                    const std::vector<std::string>& algorithms, const std::string& unit, bool logarithmic_x,
                    const std::function<std::optional<double>(const std::string& algorithm,
                                                              const std::string& value)>& number);

/// Names a depth and a size of map: "depth 0.35, 1024 texels".
std::string depth_and_size(const std::string& depth, const std::string& size);

/// Makes a plot per map, of one depth and size: a quotient of the published algorithms against the angle,
/// median over the cases that fulfil `where` besides.
std::string map_plots(const StudyTable& table, const Quotient& quotient, const std::string& depth,
                      const std::string& size, const Where& where, const std::string& unit, bool logarithmic);

}  // namespace cuesta::html
