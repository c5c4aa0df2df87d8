#pragma once

#include <set>
#include <string>

#include "reports/result.h"

namespace cuesta::html {

/// Names of statistics, derived quantities and ratios that the page shows: each gets its definition.
using ShownNames = std::set<std::string>;

// Each returns the markup of one part of the page for the runs of one scene, or "" where nothing was counted.

/// The table: a row per run, a column per number that some run has; the best of each column stands out.
std::string comparison_table(const Result& result, const RunGroup& group, ShownNames& shown);

/// A small bar plot for each of the main numbers.
std::string number_plots(const Result& result, const RunGroup& group, ShownNames& shown);

/// What each pipeline cycle was used for, in total and for each pipeline.
std::string utilisation_plots(const Result& result, const RunGroup& group, ShownNames& shown);

/// DRAM traffic against the theoretical peak, and between compulsory and no-cache traffic.
std::string traffic_plots(const Result& result, const RunGroup& group, ShownNames& shown);

/// A line per run for each histogram; median, 99th percentile and maximum below.
std::string histogram_plots(const Result& result, const RunGroup& group, ShownNames& shown);

/// Over all scenes: a line per run over the scenes, where there are several.
std::string scene_plots(const Result& result, ShownNames& shown);

/// Over all scenes: the planes as pictures side by side, one scale per plane.
std::string heat_map_section(const Result& result, ShownNames& shown);

/// Over all scenes: every counter of every run.
std::string counter_tables(const Result& result, ShownNames& shown);

std::string definition_list(const ShownNames& shown);

/// Inputs, digests, versions.
std::string provenance(const Result& result);

/// A statistic's name as a link to its definition on the page.
std::string defined(std::string_view name, std::string_view text, ShownNames& shown);

/// The sentence that defines a counter, plane, histogram, derived quantity or ratio; empty when nobody did.
std::string definition_sentence(std::string_view name);

}  // namespace cuesta::html
