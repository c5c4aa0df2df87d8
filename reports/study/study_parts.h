#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/study/study_selection.h"

// What the pages of studies are put together from: tables, tabs, sections, and the page around them.

namespace cuesta::html {

/// The headline of a study that has too few cases for its own.
inline constexpr const char* kEndedTooEarly = "The study was ended before it could say anything.";

/// Writes a value of an axis as the heading of a column: "75°", "fractal".
std::string heading_of(const StudyAxis& axis, const std::string& value);

/// Makes a table with a row per algorithm and a column per value of `axis`; `cell` writes what its cases say.
std::string algorithm_table(const StudyTable& table, const std::string& corner, std::string_view axis,
                            const std::vector<std::string>& algorithms, const Where& where,
                            const std::function<std::string(const std::vector<StudyPlace>&)>& cell);
/// Makes such a table of medians of `number` over views.
std::string median_table(const StudyTable& table, std::string_view axis,
                         const std::vector<std::string>& algorithms, const Where& where,
                         const ReadPlace& number, const std::function<std::string(double)>& text);

/// Makes a list of tabs and the panels that they choose; `id` is unique on the page.
std::string choice(const std::string& id, const std::vector<std::pair<std::string, std::string>>& panels);

/// Makes a table whose first column is a heading; cells may hold markup.
std::string plain_table(const std::vector<std::string>& head,
                        const std::vector<std::vector<std::string>>& rows);

std::string study_section(const std::string& title, const std::string& lead, const std::string& body);
/// Makes the last section: conditions, axes and what is counted.
std::string study_method(const StudyData& data);
/// Makes the whole page around the sections in `body`.
std::string study_shell(const StudyData& data, const std::string& headline, const std::string& body);

/// Writes a percentage, two digits below 1 and three above; "-" where there is none.
std::string percent_text(std::optional<double> percent);

}  // namespace cuesta::html
