#pragma once

#include <functional>
#include <optional>
#include <string>

#include "reports/html/svg_scatter_plot.h"
#include "reports/study/study_parts.h"
#include "reports/study/study_times.h"

namespace cuesta::html {

/// What wall times of one view are shown against.
struct TimedView {
  std::string title;
  const char* base;                                        ///< algorithm that others are divided by
  std::function<std::string(const std::string&)> kind_of;  ///< of an algorithm: what shares a colour
  ReadPlace error;                                         ///< per cent of the rays
  const char* error_name;                                  ///< "rays that are wrong"
};

/// Shows error against the simulator's own wall time, functional and cycle by cycle, as charts and as a
/// table.
std::string view_times_section(const StudyTable& table, const StudyTimes& times, const TimedView& view);

/// Adds a point to the series named `kind`; `exact` has a colour of its own.
void add_point(const std::string& kind, ScatterPoint point, ScatterPlot& plot);

}  // namespace cuesta::html
