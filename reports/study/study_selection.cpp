#include "reports/study/study_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace cuesta::html {

std::vector<StudyPlace> places_where(const StudyTable& table, const Where& where) {
  std::vector<std::pair<size_t, uint16_t>> wanted;
  for (const auto& [axis, value] : where) {
    const auto found = table.find(axis, value);
    if (!found) return {};
    wanted.emplace_back(axis_index(table.data(), axis), *found);
  }
  std::vector<StudyPlace> places;
  for (const StudyCase& one : table.data().cases) {
    const bool fits = std::all_of(wanted.begin(), wanted.end(),
                                  [&](const auto& want) { return one.place[want.first] == want.second; });
    if (fits) places.push_back(one.place);
  }
  return places;
}

std::optional<StudyPlace> moved(const StudyTable& table, StudyPlace place, std::string_view axis,
                                std::string_view value) {
  const auto found = table.find(axis, value);
  if (!found) return std::nullopt;
  place[axis_index(table.data(), axis)] = *found;
  return place;
}

std::optional<double> value_of(const StudyTable& table, const StudyPlace& place, const Quotient& quotient) {
  if (quotient.denominator.empty()) {
    const auto value = table.value(place, quotient.numerator);
    return value ? std::optional(quotient.scale * static_cast<double>(*value)) : std::nullopt;
  }
  const auto ratio = table.ratio(place, quotient.numerator, quotient.denominator);
  return ratio ? std::optional(quotient.scale * *ratio) : std::nullopt;
}

std::optional<double> against(const StudyTable& table, const StudyPlace& place, std::string_view base,
                              std::string_view counter) {
  const auto other = moved(table, place, "algorithm", base);
  if (!other) return std::nullopt;
  const auto above = table.value(place, counter), below = table.value(*other, counter);
  if (!above || !below || *below == 0) return std::nullopt;
  return static_cast<double>(*above) / static_cast<double>(*below);
}

const std::string& name_at(const StudyTable& table, const StudyPlace& place, std::string_view axis) {
  return value_at(table.data(), place, axis);
}

std::string view_name(const StudyTable& table, const StudyPlace& place) {
  return fmt::format("{} {}, depth {}, {}°", name_at(table, place, "map"), name_at(table, place, "size"),
                     name_at(table, place, "depth"), name_at(table, place, "angle"));
}

Spread spread(const std::vector<StudyPlace>& places, const ReadPlace& number) {
  std::vector<std::pair<double, const StudyPlace*>> all;
  for (const StudyPlace& place : places) {
    if (const auto value = number(place)) all.emplace_back(*value, &place);
  }
  Spread found;
  found.views = all.size();
  if (all.empty()) return found;
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  found.least = all.front().first;
  found.least_at = *all.front().second;
  found.median = all[(all.size() - 1) / 2].first;
  found.largest = all.back().first;
  found.largest_at = *all.back().second;
  return found;
}

std::optional<double> median_of(const StudyTable& table, const Where& where, const ReadPlace& number) {
  const Spread found = spread(places_where(table, where), number);
  return found.views == 0 ? std::nullopt : std::optional(found.median);
}

std::optional<double> median_of(const StudyTable& table, const Where& where, const Quotient& quotient) {
  return median_of(table, where, [&](const StudyPlace& place) { return value_of(table, place, quotient); });
}

std::optional<double> share_of_rays(const StudyTable& table, const std::vector<StudyPlace>& places,
                                    const std::vector<std::string>& counters) {
  int64_t rays = 0, counted = 0;
  for (const StudyPlace& place : places) {
    rays += table.value(place, "rays").value_or(0);
    for (const std::string& counter : counters) counted += table.value(place, counter).value_or(0);
  }
  if (rays == 0) return std::nullopt;
  return 100 * static_cast<double>(counted) / static_cast<double>(rays);
}

bool within(const StudyTable& table, const StudyPlace& place, Angles angles) {
  const double angle = number_at(table.data(), place, "angle");
  return angle >= angles.least && angle <= angles.largest;
}

Spread spread_against(const StudyTable& table, std::string_view algorithm, std::string_view base,
                      std::string_view counter, const Where& where, Angles angles) {
  Where all = where;
  all.emplace_back("algorithm", algorithm);
  return spread(places_where(table, all), [&](const StudyPlace& place) {
    return within(table, place, angles) ? against(table, place, base, counter) : std::nullopt;
  });
}

std::string spread_text(const Spread& spread) {
  if (spread.views == 0) return "no such view in these data";
  return fmt::format("{} to {}, median {} ({} views)", percent_change(spread.largest),
                     percent_change(spread.least), percent_change(spread.median), spread.views);
}

std::string percent_change(double ratio) {
  const double percent = 100 * (ratio - 1);
  return percent > -0.5 && percent < 0.5 ? "0 %" : fmt::format("{:+.0f} %", percent);
}

size_t Wins::of(std::string_view algorithm) const {
  for (const auto& [name, count] : least) {
    if (name == algorithm) return count;
  }
  return 0;
}

Wins wins(const StudyTable& table, std::string_view counter, const Where& where, Angles angles) {
  Wins found;
  const std::vector<std::string> names = published(table);
  for (const std::string& name : names) found.least.emplace_back(name, 0);
  found.alone = found.least;
  Where views = where;
  views.emplace_back("algorithm", "oh2006");
  for (const StudyPlace& view : places_where(table, views)) {
    if (!within(table, view, angles)) continue;
    ++found.views;
    std::vector<std::optional<int64_t>> values;
    std::optional<int64_t> least;
    for (const std::string& name : names) {
      values.push_back(table.value(*moved(table, view, "algorithm", name), counter));
      if (values.back() && (!least || *values.back() < *least)) least = values.back();
    }
    const auto winners = std::ranges::count(values, least);
    found.shared += winners > 1;
    for (size_t k = 0; k < names.size(); ++k) {
      found.least[k].second += values[k] == least;
      found.alone[k].second += values[k] == least && winners == 1;
    }
  }
  std::ranges::stable_sort(found.alone, std::greater(), &std::pair<std::string, size_t>::second);
  return found;
}

bool is_part(std::string_view algorithm) {
  return algorithm.starts_with("yun2013-") && algorithm != "yun2013-coherent";
}

std::vector<std::string> published(const StudyTable& table) {
  std::vector<std::string> names;
  for (const std::string& name : table.axis("algorithm").values) {
    if (!is_part(name)) names.push_back(name);
  }
  return names;
}

std::vector<std::string> some_values(const StudyAxis& axis, size_t most) {
  const size_t all = axis.values.size();
  if (all <= most) return axis.values;
  std::vector<std::string> some;
  for (size_t k = 0; k < most; ++k) some.push_back(axis.values[k * (all - 1) / (most - 1)]);
  return some;
}

}  // namespace cuesta::html
