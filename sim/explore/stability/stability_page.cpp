#include <fmt/format.h>

#include "models/algorithms/schedule.h"
#include "reports/html/html_text.h"
#include "reports/html/svg_bar_plot.h"
#include "reports/numbers.h"
#include "reports/study/study_parts.h"
#include "reports/study/view_times_section.h"
#include "sim/explore/stability/stability.h"
#include "sim/explore/study/ray_ends.h"

namespace cuesta {
namespace html {
namespace {

constexpr const char* kExactOne = "yun2013";
constexpr const char* kPrinted = "ki2007-printed";  // with the delta of half a texel that the paper suggests

bool is_exact(const std::string& algorithm) { return parse_algorithm(algorithm).exact(); }

bool is_printed(const std::string& algorithm) { return algorithm.find("-printed") != std::string::npos; }

/// Divides the rays of several counters by all rays of the cases that fulfil `where`, per cent; nullopt: no
/// such case.
std::optional<double> share(const StudyTable& table, const Where& where,
                            const std::vector<std::string>& counters) {
  return share_of_rays(table, places_where(table, where), counters);
}

const std::vector<std::string>& kWrong = wrong_counters();
const std::vector<std::string> kFailed = {"missed", "behind", "wrong_cell", "nan", "unfinished"};

std::string share_table(const StudyTable& table, const std::string& axis,
                        const std::vector<std::string>& counters) {
  return with_firm_spaces(algorithm_table(table, "share of all rays", axis, table.axis("algorithm").values,
                                          {}, [&](const std::vector<StudyPlace>& places) {
                                            return percent_text(share_of_rays(table, places, counters));
                                          }));
}

std::string failures_section(const StudyTable& table) {
  constexpr RayEnd kEnds[] = {kExactEnd,
                              kTieEnd,
                              kWrongCellEnd,
                              kBehindEnd,
                              kMissedEnd,
                              {"nan", "f0-4", "became NaN"},
                              {"unfinished", "f2-4", "had not ended at the cap of steps"}};
  BarPlot plot;
  plot.title = "How rays end";
  plot.remark = "share of all rays, over all maps, depths, angles and turns";
  plot.full = 100;
  add_ray_ends(
      table, kEnds, percent_text,
      [&](const std::string& algorithm) {
        return Bar{algorithm,
                   percent_text(share(table, {{"algorithm", algorithm}}, kFailed)) + " fail",
                   {},
                   is_exact(algorithm)};
      },
      plot);
  return study_section("Robust against printed", "", svg_bar_plot(plot));
}

std::string rates_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const auto& [axis, name] :
       {std::pair{"angle", "by angle"}, std::pair{"turn", "by turn"}, std::pair{"map", "by map"}}) {
    panels.emplace_back(std::string("wrong, ") + name, share_table(table, axis, kWrong));
    panels.emplace_back(std::string("NaN, ") + name, share_table(table, axis, {"nan"}));
    panels.emplace_back(std::string("never end, ") + name, share_table(table, axis, {"unfinished"}));
  }
  return study_section(
      "Wrong, NaN, endless",
      "Of all rays of the column. Wrong: another cell, or none. At turn 0 rays run along an axis of "
      "the map, where the printed code divides 0 by 0 at its first crossing.",
      choice("rates", panels));
}

/// Counts the steps of a ray of every algorithm, by angle.
std::string steps_section(const StudyTable& table) {
  const StudyAxis& angles = table.axis("angle");
  std::vector<std::string> head = {"steps of all rays"};
  for (const std::string& angle : angles.values) head.push_back(angle + "°");
  head.emplace_back("longest ray");
  std::vector<std::vector<std::string>> rows;
  for (const std::string& algorithm : table.axis("algorithm").values) {
    std::vector<std::string> row = {escape(algorithm)};
    int64_t longest = 0;
    for (const std::string& angle : angles.values) {
      int64_t rays = 0, steps = 0;
      for (const StudyPlace& place : places_where(table, {{"algorithm", algorithm}, {"angle", angle}})) {
        rays += table.value(place, "rays").value_or(0);
        steps += table.value(place, "steps").value_or(0);
        longest = std::max(longest, table.value(place, "longest").value_or(0));
      }
      row.push_back(rays == 0 ? "-" : significant(static_cast<double>(steps) / static_cast<double>(rays), 3));
    }
    row.push_back(grouped(longest));
    rows.push_back(std::move(row));
  }
  return study_section(
      "What robustness costs in steps",
      "Steps per ray, mean over all rays of the column; one that never ends counts with the cap. "
      "oh2006 is the robust form of ki2007-printed, drobot2009 that of drobot2009-printed.",
      with_firm_spaces(plain_table(head, rows)));
}

/// Finds the angle at which most rays end so: "3.1 % at 86°".
std::string worst_of(const StudyTable& table, const std::string& algorithm,
                     const std::vector<std::string>& counters) {
  const StudyAxis& angles = table.axis("angle");
  double worst = -1;
  std::string where;
  for (const std::string& angle : angles.values) {
    const auto found = share(table, {{"algorithm", algorithm}, {"angle", angle}}, counters);
    if (found && *found > worst) {
      worst = *found;
      where = angle;
    }
  }
  return worst < 0 ? "-" : fmt::format("{} at {}°", percent_text(worst), where);
}

std::string beside_section(const StudyTable& table) {
  struct Earlier {
    const char* what;
    const char* prototype;
    std::string algorithm;
    std::vector<std::string> counters;
  };
  const Earlier all[] = {
      {"0 / 0 at the first crossing", "1.5 to 77 % of random rays", "ki2007-printed:delta=0.005", {"nan"}},
      {"delta half a texel: wrong", "0.1 to 30 % from 10° to 86°", "ki2007-printed:slope", kWrong},
      {"a hundredth of it: wrong", "up to 0.6 %", "ki2007-printed:delta=0.005:slope", kWrong},
      {"delta 0: never end", "23 to 83 %", "ki2007-printed:delta=0:slope", {"unfinished"}},
  };
  const StudyAxis& angles = table.axis("angle");
  std::vector<std::string> head = {"what", "prototype", "here"};
  for (const std::string& angle : angles.values) head.push_back(angle + "°");
  std::vector<std::vector<std::string>> rows;
  for (const Earlier& one : all) {
    std::vector<std::string> row = {one.what, one.prototype, one.algorithm};
    for (const std::string& angle : angles.values)
      row.push_back(
          percent_text(share(table, {{"algorithm", one.algorithm}, {"angle", angle}}, one.counters)));
    rows.push_back(std::move(row));
  }
  return study_section("Beside earlier figures",
                       "Prototype: an earlier program of ours, with other maps and rays.",
                       with_firm_spaces(plain_table(head, rows)));
}

std::string page(const StudyData& data, const StudyTimes* times) {
  const StudyTable table(data);
  std::string timed;
  if (times != nullptr) {
    timed = view_times_section(
        table, *times,
        {"What robustness costs in wall time", kExactOne,
         [](const std::string& algorithm) {
           return is_exact(algorithm)     ? std::string("exact")
                  : is_printed(algorithm) ? algorithm.substr(0, algorithm.find(':'))
                                          : algorithm;
         },
         [&](const StudyPlace& place) { return share_of_rays(table, {place}, kFailed); }, "rays that fail"});
  }
  return study_shell(data, stability_headline(data),
                     failures_section(table) + rates_section(table) + steps_section(table) + timed +
                         beside_section(table) + study_method(data));
}

}  // namespace
}  // namespace html

std::string stability_headline(const StudyData& data) {
  using namespace html;
  const StudyTable table(data);
  int64_t rays = 0, lost = 0;
  for (const std::string& algorithm : table.axis("algorithm").values) {
    if (!is_exact(algorithm)) continue;
    for (const StudyPlace& place : places_where(table, {{"algorithm", algorithm}})) {
      rays += table.value(place, "rays").value_or(0);
      lost += table.value(place, "nan").value_or(0) + table.value(place, "unfinished").value_or(0);
    }
  }
  const Where printed = {{"algorithm", kPrinted}};
  if (rays == 0 || !share(table, printed, kFailed)) return kEndedTooEarly;
  return fmt::format(
      "Of {} rays of exact schedules {} became NaN or failed to end, and {} differ from the truth, by the "
      "rounding of "
      "their numbers alone; the pyramid code as Ki & Oh 2007 print it fails on {} of the same rays (worst "
      "{}): {} "
      "wrong, {} NaN, {} endless.",
      grouped(rays), lost == 0 ? "none" : grouped(lost),
      percent_text(share(table, {{"algorithm", kExactOne}}, kWrong)),
      percent_text(share(table, printed, kFailed)), worst_of(table, kPrinted, kFailed),
      percent_text(share(table, printed, kWrong)), percent_text(share(table, printed, {"nan"})),
      percent_text(share(table, printed, {"unfinished"})));
}

std::string stability_page(const StudyData& data) { return html::page(data, nullptr); }
std::string stability_timed_page(const StudyData& data, const StudyTimes& times) {
  return html::page(data, &times);
}

}  // namespace cuesta
