#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reports/study/study_data.h"
#include "traces/parallel_view.h"

// What the plans of studies are put together from: axes, conditions and counters that several of them have.

namespace cuesta {

/// Begins a plan with what its first lines say; axes, conditions and counters are added to it.
StudyData begin_plan(std::string_view study, std::string question, bool quick);
/// Adds sentences to a plan's conditions.
void add_conditions(StudyData& plan, std::vector<std::string> sentences);

// Studies of traversal look at one picture of square pixels in parallel projection.
inline constexpr uint32_t kViewWidth = 256, kViewHeight = 128;
inline constexpr uint32_t kWarpWidth = 8, kWarpHeight = 4;  // of neighbouring pixels

/// Gives the picture that studies of traversal look at: two tiles' breadth, turned by 25 degrees. One
/// direction for all rays makes the angle exact, an endless plane makes every pixel a ray that hits, and two
/// tiles' breadth meets every part of the map about equally often. A perspective camera would mix angles, and
/// show less of the map the more it is tilted.
ParallelView study_view(double angle_degrees, double depth);
/// Lists the pixels of that picture, row by row: all, or with `sampled` those of one warp in four, evenly
/// spread.
std::vector<uint32_t> picture_pixels(bool sampled);
/// Says what holds for every case of a study that looks at it.
std::vector<std::string> view_conditions();

/// Makes the axis `map`: kinds of generated maps, seed 1, 8 bits.
StudyAxis map_axis(std::vector<std::string> kinds);
StudyAxis size_axis(std::vector<std::string> texels);
StudyAxis depth_axis(std::vector<std::string> tiles);
StudyAxis angle_axis(std::vector<std::string> degrees);
StudyAxis turn_axis(std::vector<std::string> degrees);
StudyAxis algorithm_axis(std::vector<std::string> ids);

/// Lists the kinds of generated maps that published studies of many maps look at.
std::vector<std::string> study_maps();
/// Lists all published algorithms and each of Yun's parts alone.
std::vector<std::string> study_algorithms();

/// Describes the counter of what ViewRunner::simt_slots counts.
StudyCounter simt_counter();

}  // namespace cuesta
