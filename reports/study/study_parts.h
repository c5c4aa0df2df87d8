#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/html/svg_line_plot.h"
#include "reports/study/study_data.h"

// What the pages of studies are put together from: selections of cases, their ratios, and the page around them.

namespace cuesta::html {

/// axis = value, all of them.
using Where = std::vector<std::pair<std::string_view, std::string_view>>;

/// One counter over another, or alone.
struct Quotient {
  std::string_view numerator;
  std::string_view denominator;
  double scale = 1;
};

/// The finished cases that fulfil `where`, in order.
std::vector<StudyPlace> places_where(const StudyTable& table, const Where& where);
/// The same place with another value on one axis; nullopt where the axis has no such value.
std::optional<StudyPlace> moved(const StudyTable& table, StudyPlace place, std::string_view axis,
                                std::string_view value);
std::optional<double> value_of(const StudyTable& table, const StudyPlace& place, const Quotient& quotient);
/// The place's counter over that of another algorithm in the same view (the same rays).
std::optional<double> against(const StudyTable& table, const StudyPlace& place, std::string_view base,
                              std::string_view counter);
/// "fractal 1024, depth 0.35, 75 degrees"
std::string view_name(const StudyTable& table, const StudyPlace& place);
const std::string& name_at(const StudyTable& table, const StudyPlace& place, std::string_view axis);

/// Least, median (lower) and largest of a number over views, with the views of the ends.
struct Spread {
  size_t views = 0;
  double least = 0, median = 0, largest = 0;
  StudyPlace least_at, largest_at;
};
Spread spread(const std::vector<StudyPlace>& places,
              const std::function<std::optional<double>(const StudyPlace&)>& number);
/// Angles in degrees, both ends included.
struct Angles {
  double least, largest;
};
inline constexpr Angles kFront{0, 30}, kGrazing{75, 90}, kAnyAngle{0, 90};
bool within(const StudyTable& table, const StudyPlace& place, Angles angles);
/// `algorithm` against `base` over the views that fulfil `where`.
Spread spread_against(const StudyTable& table, std::string_view algorithm, std::string_view base,
                      std::string_view counter, const Where& where, Angles angles = kAnyAngle);
/// "-12 % to -40 %, median -30 % (48 views)", from the largest ratio to the least.
std::string spread_text(const Spread& spread);

/// How often each published algorithm needs the least of a counter, in views where `where` holds.
struct Wins {
  size_t views = 0;
  std::vector<std::pair<std::string, size_t>> least;  ///< by algorithm; several may share a view
  std::vector<std::pair<std::string, size_t>> alone;  ///< likewise, of the views that none shares; most first
  size_t shared = 0;                                  ///< views that several share
  size_t of(std::string_view algorithm) const;        ///< in `least`
};
Wins wins(const StudyTable& table, std::string_view counter, const Where& where, Angles angles);

/// A table of medians over views: a row per algorithm, a column per value of `axis`; `number` of a place.
std::string median_table(const StudyTable& table, std::string_view axis,
                         const std::vector<std::string>& algorithms, const Where& where,
                         const std::function<std::optional<double>(const StudyPlace&)>& number,
                         const std::function<std::string(double)>& text);

/// Whether an algorithm of that name is one part of yun2013 alone.
bool is_part(std::string_view algorithm);
std::vector<std::string> published(const StudyTable& table);

/// Up to `most` values of an axis, the first and the last among them, evenly spread.
std::vector<std::string> some_values(const StudyAxis& axis, size_t most);

/// A line per algorithm over an axis of numbers; `number` nullopt: no point. Texts carry `unit`.
LinePlot lines_over(const StudyTable& table, std::string_view axis,
                    const std::vector<std::string>& algorithms, const std::string& unit, bool logarithmic_x,
                    const std::function<std::optional<double>(const std::string& algorithm,
                                                              const std::string& value)>& number);

/// A list of tabs and the panels that they choose; `id` is unique on the page.
std::string choice(const std::string& id, const std::vector<std::pair<std::string, std::string>>& panels);

/// A table; the first column is a heading; cells may hold markup.
std::string plain_table(const std::vector<std::string>& head,
                        const std::vector<std::vector<std::string>>& rows);

std::string study_section(const std::string& title, const std::string& lead, const std::string& body);
/// Conditions, axes and what is counted, as the last section.
std::string study_method(const StudyData& data);
/// The whole page.
std::string study_shell(const StudyData& data, const std::string& headline, const std::string& body);

/// No line break between a number and its per cent sign.
std::string with_firm_spaces(std::string text);
std::string percent_change(double ratio);  ///< 0.34 -> "-66 %"

}  // namespace cuesta::html
