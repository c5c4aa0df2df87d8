#include "reports/study/study_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>

#include "reports/html/assets.h"
#include "reports/html/html_text.h"
#include "reports/numbers.h"

namespace cuesta::html {
namespace {

double number_of(const std::string& text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

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
  return table.axis(axis).values[place[axis_index(table.data(), axis)]];
}

std::string view_name(const StudyTable& table, const StudyPlace& place) {
  return fmt::format("{} {}, depth {}, {}°", name_at(table, place, "map"), name_at(table, place, "size"),
                     name_at(table, place, "depth"), name_at(table, place, "angle"));
}

Spread spread(const std::vector<StudyPlace>& places,
              const std::function<std::optional<double>(const StudyPlace&)>& number) {
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

bool within(const StudyTable& table, const StudyPlace& place, Angles angles) {
  const double angle = number_of(name_at(table, place, "angle"));
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

std::string median_table(const StudyTable& table, std::string_view axis,
                         const std::vector<std::string>& algorithms, const Where& where,
                         const std::function<std::optional<double>(const StudyPlace&)>& number,
                         const std::function<std::string(double)>& text) {
  const StudyAxis& columns = table.axis(axis);
  std::vector<std::string> head{"algorithm"};
  for (const std::string& value : columns.values)
    head.push_back(value + (columns.unit == "degrees" ? "°" : ""));
  std::vector<std::vector<std::string>> rows;
  for (const std::string& algorithm : algorithms) {
    rows.push_back({escape(algorithm)});
    for (const std::string& value : columns.values) {
      Where cell = where;
      cell.emplace_back("algorithm", algorithm);
      cell.emplace_back(axis, value);
      const Spread found = spread(places_where(table, cell), number);
      rows.back().push_back(found.views == 0 ? "-" : text(found.median));
    }
  }
  return plain_table(head, rows);
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

LinePlot lines_over(
    const StudyTable& table, std::string_view axis_name, const std::vector<std::string>& algorithms,
    const std::string& unit, bool logarithmic_x,
    const std::function<std::optional<double>(const std::string&, const std::string&)>& number) {
  const StudyAxis& axis = table.axis(axis_name);
  LinePlot plot;
  plot.y_unit = unit;
  plot.points = true;
  auto at = [&](const std::string& value) {
    return logarithmic_x ? std::log2(number_of(value)) : number_of(value);
  };
  const double low = at(axis.values.front()), high = at(axis.values.back());
  double last_tick = -1;
  for (const std::string& value : axis.values) {
    const double place = high > low ? 0.05 + 0.9 * (at(value) - low) / (high - low) : 0.5;
    plot.places.push_back(place);
    plot.place_texts.push_back(value + " " + axis.unit);
    const bool end = value == axis.values.back();
    if (!end && (place - last_tick < 0.12 || (high > low && 0.95 - place < 0.12))) continue;
    last_tick = place;
    plot.x_ticks.push_back({place, value + (end ? axis.unit == "degrees" ? "°" : " " + axis.unit : "")});
    if (end) plot.x_ticks.back().first = 1;
  }
  for (size_t k = 0; k < algorithms.size(); ++k) {
    Line line{algorithms[k], series_class(k), {}, {}};
    bool some = false;
    for (const std::string& value : axis.values) {
      const auto found = number(algorithms[k], value);
      some = some || found;
      line.values.push_back(found.value_or(std::numeric_limits<double>::quiet_NaN()));
      line.texts.push_back(found ? significant(*found, 3) + " " + unit : "-");
    }
    if (some) plot.lines.push_back(std::move(line));
  }
  return plot;
}

std::string choice(const std::string& id, const std::vector<std::pair<std::string, std::string>>& panels) {
  if (panels.size() == 1) return panels[0].second;
  std::string tabs = "<div class=\"tabs\" role=\"tablist\">", bodies;
  for (size_t k = 0; k < panels.size(); ++k) {
    tabs += fmt::format("<button role=\"tab\" aria-controls=\"{}-{}\">{}</button>", id, k,
                        escape(panels[k].first));
    bodies += fmt::format("<div id=\"{}-{}\" role=\"tabpanel\" aria-label=\"{}\">{}</div>", id, k,
                          escape(panels[k].first), panels[k].second);
  }
  return tabs + "</div>" + bodies;
}

std::string plain_table(const std::vector<std::string>& head,
                        const std::vector<std::vector<std::string>>& rows) {
  std::string html = "<div class=\"scroll\"><table class=\"numbers\"><thead><tr>";
  for (const std::string& cell : head) html += "<th scope=\"col\">" + cell + "</th>";
  html += "</tr></thead><tbody>";
  for (const std::vector<std::string>& row : rows) {
    for (size_t k = 0; k < row.size(); ++k) {
      html += k == 0 ? "<tr><th scope=\"row\">" + row[k] + "</th>" : "<td>" + row[k] + "</td>";
    }
    html += "</tr>";
  }
  return html + "</tbody></table></div>";
}

std::string study_section(const std::string& title, const std::string& lead, const std::string& body) {
  return "<section><h2>" + title + "</h2>" +
         (lead.empty() ? "" : "<p class=\"lead\">" + with_firm_spaces(lead) + "</p>") + body + "</section>\n";
}

std::string study_method(const StudyData& data) {
  std::string html = "<ul class=\"prose\">";
  for (const std::string& condition : data.conditions) html += "<li>" + escape(condition) + "</li>";
  html += "<li>A median over an even number of cases is the lower of the middle two.</li>";
  html += "</ul><dl class=\"definitions\">";
  auto item = [&](const std::string& name, const std::string& unit, const std::string& sentence) {
    html += fmt::format("<div><dt>{}<small>{}</small></dt><dd>{}</dd></div>", escape(name), escape(unit),
                        escape(sentence));
  };
  for (const StudyAxis& axis : data.axes) {
    item(axis.name, axis.unit, axis.sentence + " " + listed_values(axis, ", ") + ".");
  }
  for (const StudyCounter& counter : data.counters) item(counter.name, counter.unit, counter.sentence);
  return study_section("How it was counted", "", html + "</dl>");
}

std::string study_shell(const StudyData& data, const std::string& headline, const std::string& body) {
  const std::string title = "Cuesta: study " + data.study;
  const std::string cases =
      fmt::format("{} cases{}{}", grouped(static_cast<int64_t>(data.cases.size())),
                  data.partial() ? " of " + grouped(static_cast<int64_t>(data.planned)) + ": partial" : "",
                  data.amount == "quick" ? ", the quick matrix" : "");
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
         "<meta name=\"color-scheme\" content=\"light dark\">"
         "<link rel=\"icon\" href=\"data:,\"><title>" +
         escape(title) + "</title>\n<style>" + std::string(kStyleSheet) +
         "</style></head>\n<body><main>\n<header><p class=\"headline\">" +
         with_firm_spaces(escape(headline)) + "</p><h1>" + escape(title) + "</h1><p class=\"facts\">" +
         escape(data.question + " " + cases) + "</p></header>\n" + body +
         "</main><div id=\"tip\" role=\"status\" hidden></div>\n<script>" + std::string(kScript) +
         "</script></body></html>\n";
}

std::string with_firm_spaces(std::string text) {
  for (size_t at = text.find(" %"); at != std::string::npos; at = text.find(" %", at))
    text.replace(at, 1, "&nbsp;");
  return text;
}

std::string percent_change(double ratio) {
  const double percent = 100 * (ratio - 1);
  return percent > -0.5 && percent < 0.5 ? "0 %" : fmt::format("{:+.0f} %", percent);
}

}  // namespace cuesta::html
