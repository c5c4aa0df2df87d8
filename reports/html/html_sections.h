#pragma once

#include <set>
#include <string>

#include "reports/result.h"

namespace cuesta::html {

/// Names of statistics, derived quantities and ratios that the page shows: each gets its definition.
using ShownNames = std::set<std::string>;

// Each returns the markup of one part of the page for the runs of one scene, or "" where nothing was counted.

/// Makes the table: a row per run, a column per number that some run has; the best of each column stands out.
std::string comparison_table(const Result& result, const RunGroup& group, ShownNames& shown);

/// Draws a small bar plot for each of the main numbers.
std::string number_plots(const Result& result, const RunGroup& group, ShownNames& shown);

/// Draws what each pipeline cycle was used for, in total and for each pipeline.
std::string utilisation_plots(const Result& result, const RunGroup& group, ShownNames& shown);

/// Draws DRAM traffic against the theoretical peak, and between compulsory and no-cache traffic.
std::string traffic_plots(const Result& result, const RunGroup& group, ShownNames& shown);

/// Draws a line per run for each histogram; median, 99th percentile and maximum below.
std::string histogram_plots(const Result& result, const RunGroup& group, ShownNames& shown);

/// Draws a line per run over the scenes, where there are several.
std::string scene_plots(const Result& result, ShownNames& shown);

/// Shows the planes of all scenes as pictures side by side, one scale per plane.
std::string heat_map_section(const Result& result, ShownNames& shown);

/// Lists every counter of every run, over all scenes.
std::string counter_tables(const Result& result, ShownNames& shown);

std::string definition_list(const ShownNames& shown);

/// Lists inputs, digests and versions.
std::string provenance(const Result& result);

/// Writes a statistic's name as a link to its definition on the page.
std::string defined(std::string_view name, std::string_view text, ShownNames& shown);

/// Finds the sentence that defines a counter, plane, histogram, derived quantity or ratio; empty when nobody
/// did.
std::string definition_sentence(std::string_view name);

}  // namespace cuesta::html
