#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/study/study_data.h"

// What the pages of studies take from their data: selections of cases, ratios of their counts, medians and
// shares.

namespace cuesta::html {

/// Conditions on a case: axis = value, all of them.
using Where = std::vector<std::pair<std::string_view, std::string_view>>;

/// Reads a number of one case; nullopt where it has none.
using ReadPlace = std::function<std::optional<double>(const StudyPlace&)>;

/// One counter over another, or alone.
struct Quotient {
  std::string_view numerator;
  std::string_view denominator;
  double scale = 1;
};

/// Finds the finished cases that fulfil `where`, in order.
std::vector<StudyPlace> places_where(const StudyTable& table, const Where& where);
/// Moves a place to another value on one axis; nullopt where the axis has no such value.
std::optional<StudyPlace> moved(const StudyTable& table, StudyPlace place, std::string_view axis,
                                std::string_view value);
std::optional<double> value_of(const StudyTable& table, const StudyPlace& place, const Quotient& quotient);
/// Divides the place's counter by that of another algorithm in the same view (the same rays).
std::optional<double> against(const StudyTable& table, const StudyPlace& place, std::string_view base,
                              std::string_view counter);
/// Names a view: "fractal 1024, depth 0.35, 75°".
std::string view_name(const StudyTable& table, const StudyPlace& place);
/// Gives the value that a place has on an axis, as it is written.
const std::string& name_at(const StudyTable& table, const StudyPlace& place, std::string_view axis);

/// Least, median (lower) and largest of a number over views, with the views of the ends.
struct Spread {
  size_t views = 0;
  double least = 0, median = 0, largest = 0;
  StudyPlace least_at, largest_at;
};
Spread spread(const std::vector<StudyPlace>& places, const ReadPlace& number);
/// Takes the lower median over the cases that fulfil `where`; nullopt where none of them has the number.
std::optional<double> median_of(const StudyTable& table, const Where& where, const ReadPlace& number);
std::optional<double> median_of(const StudyTable& table, const Where& where, const Quotient& quotient);

/// Sums up counters of rays over the places, in per cent of all their rays; nullopt where there are no rays.
std::optional<double> share_of_rays(const StudyTable& table, const std::vector<StudyPlace>& places,
                                    const std::vector<std::string>& counters);

/// Angles in degrees, both ends included.
struct Angles {
  double least, largest;
};
inline constexpr Angles kFront{0, 30}, kGrazing{75, 90}, kAnyAngle{0, 90};
bool within(const StudyTable& table, const StudyPlace& place, Angles angles);
/// Takes the spread of `algorithm` against `base` over the views that fulfil `where`.
Spread spread_against(const StudyTable& table, std::string_view algorithm, std::string_view base,
                      std::string_view counter, const Where& where, Angles angles = kAnyAngle);
/// Writes a spread of ratios from the largest to the least: "-12 % to -40 %, median -30 % (48 views)".
std::string spread_text(const Spread& spread);
/// Writes a ratio as a change: 0.34 -> "-66 %".
std::string percent_change(double ratio);

/// How often each published algorithm needs the least of a counter, in views where `where` holds.
struct Wins {
  size_t views = 0;
  std::vector<std::pair<std::string, size_t>> least;  ///< by algorithm; several may share a view
  std::vector<std::pair<std::string, size_t>> alone;  ///< likewise, of the views that none shares; most first
  size_t shared = 0;                                  ///< views that several share
  size_t of(std::string_view algorithm) const;        ///< in `least`
};
Wins wins(const StudyTable& table, std::string_view counter, const Where& where, Angles angles);

/// Says whether an algorithm of that name is one part of yun2013 alone.
bool is_part(std::string_view algorithm);
/// Lists the study's algorithms but the parts.
std::vector<std::string> published(const StudyTable& table);

/// Picks up to `most` values of an axis, the first and the last among them, evenly spread.
std::vector<std::string> some_values(const StudyAxis& axis, size_t most);

}  // namespace cuesta::html
