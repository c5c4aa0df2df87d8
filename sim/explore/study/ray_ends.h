#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "models/work/hit_judge.h"
#include "reports/html/svg_bar_plot.h"
#include "reports/study/study_data.h"

// How the rays of an algorithm end: the counters of a plan and the bars of a page, for studies that judge
// hits.

namespace cuesta {

/// Describes the counters of verdicts, in the order of Verdict.
std::vector<StudyCounter> verdict_counters();
/// Gives the counts of one case for them.
std::vector<int64_t> verdict_counts(const Judgement& judgement);

/// Lists the counters of the rays whose answer is wrong; ties are right.
const std::vector<std::string>& wrong_counters();

namespace html {

/// One way to end: its counter, the class of its colour, and what it means.
struct RayEnd {
  const char* counter;
  const char* colour;
  const char* meaning;
};
inline constexpr RayEnd kExactEnd{"exact", "work", "the true cell"};
inline constexpr RayEnd kTieEnd{"tie", "f1-1", "right if touching counts"};
inline constexpr RayEnd kWrongCellEnd{"wrong_cell", "f0-1", "another cell, too early"};
inline constexpr RayEnd kBehindEnd{"behind", "f0-3", "another cell, too late"};
inline constexpr RayEnd kMissedEnd{"missed", "f2-2", "no hit where there is one"};

/// Adds the ends to the plot: a legend, and for each algorithm that has cases a bar of its shares of all
/// rays. `percent` writes a share, `bar` gives the bar without its segments.
void add_ray_ends(const StudyTable& table, std::span<const RayEnd> ends,
                  const std::function<std::string(double)>& percent,
                  const std::function<Bar(const std::string& algorithm)>& bar, BarPlot& plot);

}  // namespace html
}  // namespace cuesta
