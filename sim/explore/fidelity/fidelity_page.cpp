#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/html/html_text.h"
#include "reports/html/svg_dot_plot.h"
#include "reports/html/svg_line_plot.h"
#include "reports/numbers.h"
#include "reports/study/study_parts.h"
#include "sim/explore/fidelity/fidelity.h"

namespace cuesta {
namespace html {
namespace {

/// Reads a level's count over cycle's, less one, in per cent, without its sign; none where cycle counted
/// nothing.
ReadPlace error_of(const StudyTable& table, std::string of, std::string truth) {
  return [&table, of = std::move(of),
          truth = std::move(truth)](const StudyPlace& place) -> std::optional<double> {
    const auto ratio = table.ratio(place, of, truth);
    return ratio ? std::optional(100 * std::abs(*ratio - 1)) : std::nullopt;
  };
}

ReadPlace unit_error(const StudyTable& table, const std::string& what) {
  return error_of(table, "transaction_" + what, "cycle_" + what);
}

ReadPlace functional_error(const StudyTable& table, bool cycles) {
  return cycles ? error_of(table, "bound_cycles", "cycle_cycles")
                : error_of(table, "texel_bytes", "cycle_dram_read_bytes");
}

struct Errors {
  size_t cases = 0;
  double median = 0, p90 = 0, worst = 0;
  StudyPlace worst_at;
};

Errors errors(const std::vector<StudyPlace>& places, const ReadPlace& error) {
  std::vector<double> values;
  Errors found;
  for (const StudyPlace& place : places) {
    const auto value = error(place);
    if (!value) continue;
    if (*value >= found.worst) found.worst_at = place;
    found.worst = std::max(found.worst, *value);
    values.push_back(*value);
  }
  std::sort(values.begin(), values.end());
  found.cases = values.size();
  if (values.empty()) return found;
  found.median = values[(values.size() - 1) / 2];
  found.p90 = values[(values.size() - 1) * 9 / 10];
  return found;
}

/// Leaves the sections' names out: "mobile height_l1.ways=1" is "mobile ways=1".
std::string short_name(const std::string& machine) {
  std::string name;
  size_t word = 0;
  for (const char c : machine) {
    if (c == '.' && word > 0)
      name.resize(word);
    else
      name += c;
    if (c == ' ') word = name.size();
  }
  return name;
}

std::string case_name(const StudyTable& table, const StudyPlace& place) {
  return name_at(table, place, "algorithm") + " on " + short_name(name_at(table, place, "machine")) + ", " +
         view_name(table, place);
}

std::string error_plot(const StudyTable& table, const std::string& what, const std::string& title,
                       const std::string& axis) {
  DotPlot plot;
  plot.title = title;
  plot.remark =
      "error against cycle in %, without its sign, median at the right; logarithmic axis; an error of 0 has "
      "no dot";
  plot.unit = "%";
  plot.legend = {{"s0", "median", ""}, {"s1", "nine tenths are below", ""}, {"s7", "worst", ""}};
  for (const std::string& value : table.axis(axis).values) {
    const Errors of = errors(places_where(table, {{axis, value}}), unit_error(table, what));
    if (of.cases == 0) continue;
    auto tip = [&](const char* name, double error) {
      return value + "\n" + name + ": " + percent_text(error);
    };
    plot.rows.push_back({axis == "machine" ? short_name(value) : value,
                         percent_text(of.median),
                         {{"s7", of.worst, tip("worst", of.worst), ""},
                          {"s1", of.p90, tip("nine tenths are below", of.p90), ""},
                          {"s0", of.median, tip("median", of.median), ""}}});
  }
  return plot.rows.empty() ? "" : svg_dot_plot(plot);
}

const TimedRun* time_of(const StudyTimes& times, const std::string& machine, const std::string& level) {
  for (const TimedRun& run : times.runs) {
    if (run.machine == machine && run.level == level) return &run;
  }
  return nullptr;
}

std::string levels_section(const StudyTable& table) {
  const std::vector<StudyPlace> all = places_where(table, {});
  const auto row = [&](const char* level, const ReadPlace& cycles, const ReadPlace& bytes, const char* why) {
    const Errors c = errors(all, cycles), b = errors(all, bytes);
    return std::vector<std::string>{level,
                                    "the same",
                                    percent_text(c.median),
                                    percent_text(c.worst),
                                    percent_text(b.median),
                                    percent_text(b.worst),
                                    why};
  };
  const ReadPlace none = [](const StudyPlace&) { return std::optional(0.0); };
  return study_section("What each level gets wrong",
                       "Hits, steps and addresses are the same bits on every level. Error of machine.cycles "
                       "and of the bytes read from "
                       "DRAM, without sign, against cycle.",
                       with_firm_spaces(plain_table(
                           {"level", "hits, steps", "cycles:<br>median", "cycles:<br>worst",
                            "bytes:<br>median", "bytes:<br>worst", "because"},
                           {row("functional", functional_error(table, true), functional_error(table, false),
                                "no time, no cache: a bound and the traffic without a cache"),
                            row("transaction", unit_error(table, "cycles"),
                                unit_error(table, "dram_read_bytes"), "rays look lines up ahead of time"),
                            row("cycle", none, none, "every cycle of every unit"),
                            row("rtl", none, none, "is the hardware; cycle equals it cycle by cycle")})));
}

std::string units_section(const StudyTable& table) {
  struct Unit {
    const char* unit;
    const char* what;
    const char* counter;
  };
  constexpr Unit kUnits[] = {
      {"machine", "cycles", "cycles"},
      {"height_l1", "lookups", "l1_lookups"},
      {"height_l1", "misses", "l1_misses"},
      {"height_l1", "merges", "l1_merges"},
      {"traverse", "cycles with every context waiting", "starved_cycles"},
      {"traverse", "cycles stalled by hit_queue", "stalled_cycles"},
      {"dram", "bytes read", "dram_read_bytes"},
      {"dram", "row hits", "dram_row_hits"},
      {"rays", "median latency", "latency_median"},
  };
  const std::vector<StudyPlace> all = places_where(table, {});
  std::vector<std::vector<std::string>> rows;
  for (const Unit& unit : kUnits) {
    // Counts that hardly take part in the cycles have errors that say nothing: only those of 1 % of the
    // cycles and more.
    std::vector<StudyPlace> heard;
    for (const StudyPlace& place : all) {
      const auto share = table.ratio(place, std::string("cycle_") + unit.counter, "cycle_cycles");
      if (std::string_view(unit.unit) == "rays" || (share && *share >= 0.01)) heard.push_back(place);
    }
    const Errors of = errors(heard, unit_error(table, unit.counter));
    if (of.cases == 0) continue;
    rows.push_back({unit.unit, unit.what, std::to_string(of.cases), percent_text(of.median),
                    percent_text(of.p90), percent_text(of.worst), escape(case_name(table, of.worst_at))});
  }
  return study_section(
      "Transaction against cycle, unit by unit",
      "Over the cases in which the count is at least 1 % of the machine's cycles; latency over all.",
      with_firm_spaces(plain_table(
          {"unit", "count", "cases", "median", "nine tenths below", "worst", "worst case"}, rows)));
}

std::string worst_section(const StudyTable& table) {
  const ReadPlace error = unit_error(table, "cycles");
  std::vector<std::pair<double, StudyPlace>> all;
  for (const StudyPlace& place : places_where(table, {})) all.emplace_back(error(place).value_or(0), place);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::vector<std::string>> rows;
  for (size_t k = 0; k < std::min<size_t>(all.size(), 10); ++k) {
    const StudyPlace& place = all[k].second;
    const auto change = [&](const char* what) {
      const auto ratio = table.ratio(place, std::string("transaction_") + what, std::string("cycle_") + what);
      return ratio ? signed_percent(*ratio - 1) : "-";
    };
    const auto starved = table.ratio(place, "cycle_starved_cycles", "cycle_cycles");
    rows.push_back({escape(case_name(table, place)), change("cycles"), change("dram_read_bytes"),
                    change("l1_merges"), percent_text(100 * starved.value_or(0))});
  }
  return study_section(
      "Where the estimate is worst",
      "The ten largest errors of cycles, with the sign of each, and how much of the pipes' time every "
      "context waited.",
      with_firm_spaces(plain_table({"case", "cycles", "bytes read", "merges", "all wait"}, rows)));
}

/// Draws error against wall time, a point per level; the axes' ends are in their texts.
std::string cost_plot(const StudyTable& table, const StudyTimes& times, const std::string& machine) {
  const std::vector<StudyPlace> cases = places_where(table, {{"machine", machine}});
  struct Point {
    const char* level;
    double error;
  };
  const Point points[] = {{"functional", errors(cases, functional_error(table, true)).median},
                          {"transaction", errors(cases, unit_error(table, "cycles")).median},
                          {"cycle", 0},
                          {"cycle in SystemC", 0},
                          {"rtl", 0},
                          {"rtl with waves", 0}};
  struct Placed {
    double seconds;
    const Point* point;
  };
  std::vector<Placed> placed;
  for (const Point& point : points) {
    if (const TimedRun* run = time_of(times, machine, point.level)) placed.push_back({run->seconds, &point});
  }
  if (placed.size() < 2) return "";
  std::stable_sort(placed.begin(), placed.end(),
                   [](const Placed& a, const Placed& b) { return a.seconds < b.seconds; });
  const double low = std::pow(10.0, std::floor(std::log10(placed.front().seconds)));
  const double high = std::pow(10.0, std::ceil(std::log10(placed.back().seconds * 1.01)));
  auto place_of = [&](double seconds) { return std::log(seconds / low) / std::log(high / low); };
  LinePlot plot;
  plot.title = "Median error of cycles against wall time, " + machine;
  plot.remark = "x: seconds a frame (logarithmic); y: error in %; each point a level, from left to right: ";
  plot.y_unit = "%";
  plot.points = true;
  for (double tick = low; tick <= high * 1.001; tick *= 10)
    plot.x_ticks.emplace_back(place_of(tick), significant(tick) + " s");
  for (const Placed& one : placed) {
    plot.places.push_back(place_of(one.seconds));
    plot.place_texts.push_back(significant(one.seconds) + " s a frame");
  }
  for (size_t k = 0; k < placed.size(); ++k) {
    Line line{placed[k].point->level, fmt::format("s{}", k), {}, {}};
    for (size_t j = 0; j < placed.size(); ++j) {
      line.values.push_back(j == k ? placed[k].point->error : NAN);
      line.texts.push_back(j == k ? percent_text(placed[k].point->error) : "");
    }
    plot.remark += (k == 0 ? "" : ", ") + std::string(placed[k].point->level);
    plot.lines.push_back(std::move(line));
  }
  return svg_line_plot(plot);
}

std::string times_section(const StudyTable& table, const StudyTimes& times) {
  std::vector<std::string> machines;
  for (const TimedRun& run : times.runs) {
    if (std::find(machines.begin(), machines.end(), run.machine) == machines.end())
      machines.push_back(run.machine);
  }
  std::string plots = "<div class=\"grid wide\">";
  std::vector<std::vector<std::string>> rows;
  for (const std::string& machine : machines) {
    plots += cost_plot(table, times, machine);
    const TimedRun* cycle = time_of(times, machine, "cycle");
    for (const TimedRun& run : times.runs) {
      if (run.machine != machine) continue;
      const double error =
          cycle == nullptr || run.cycles == 0
              ? NAN
              : 100 * (static_cast<double>(run.cycles) / static_cast<double>(cycle->cycles) - 1);
      rows.push_back({escape(run.level), machine, significant(1e3 * run.seconds) + " ms",
                      with_prefix(static_cast<double>(run.rays) / run.seconds, ""),
                      run.cycles == 0 ? "-" : with_prefix(static_cast<double>(run.cycles) / run.seconds, ""),
                      cycle == nullptr ? "-" : significant(run.seconds / cycle->seconds) + " x",
                      std::isnan(error) ? "-" : signed_percent(error / 100)});
    }
  }
  const std::string measured =
      measured_sentences(times) +
      fmt::format(
          " Waves: of the first {} cycles of one pipeline. Wall times are of that host and hour; the "
          "ratios were taken in one run.",
          grouped(kFidelityWaveCycles));
  return study_section(
      "What each level costs in wall time", escape(measured),
      plots + "</div>" +
          with_firm_spaces(plain_table({"level", "machine", "wall time<br>a frame", "rays / s", "cycles / s",
                                        "of cycle's<br>wall time", "error of<br>cycles"},
                                       rows)));
}

std::string page(const StudyData& data, const StudyTimes* times) {
  const StudyTable table(data);
  std::vector<std::pair<std::string, std::string>> panels;
  for (const auto& [axis, title] :
       {std::pair{"machine", "by machine"}, std::pair{"algorithm", "by algorithm"},
        std::pair{"map", "by map"}, std::pair{"angle", "by angle (degrees)"}}) {
    panels.emplace_back(
        title, "<div class=\"grid wide\">" + error_plot(table, "cycles", "Error of cycles", axis) +
                   error_plot(table, "dram_read_bytes", "Error of bytes read from DRAM", axis) + "</div>");
  }
  return study_shell(data, fidelity_headline(data),
                     levels_section(table) +
                         (times != nullptr ? times_section(table, *times)
                                           : study_section("What each level costs in wall time",
                                                           "Not measured with these data: `cuesta study "
                                                           "fidelity --times` does, on the host on which it "
                                                           "runs.",
                                                           "")) +
                         study_section("Transaction against cycle", "", choice("errors", panels)) +
                         units_section(table) + worst_section(table) + study_method(data));
}

}  // namespace
}  // namespace html

std::string fidelity_headline(const StudyData& data) {
  using namespace html;
  const StudyTable table(data);
  const std::vector<StudyPlace> all = places_where(table, {});
  const Errors cycles = errors(all, unit_error(table, "cycles")),
               bytes = errors(all, unit_error(table, "dram_read_bytes"));
  const Errors bound = errors(all, functional_error(table, true));
  if (cycles.cases == 0) return kEndedTooEarly;
  return fmt::format(
      "Fidelity transaction finds the cycles of a frame to {} (median; worst {}) and its DRAM bytes to {} "
      "(worst {}) over {} "
      "runs on {} machines; what functional alone says, one step a cycle, is {} off (worst {}).",
      percent_text(cycles.median), percent_text(cycles.worst), percent_text(bytes.median),
      percent_text(bytes.worst), cycles.cases, table.axis("machine").values.size(),
      percent_text(bound.median), percent_text(bound.worst));
}

std::string fidelity_page(const StudyData& data) { return html::page(data, nullptr); }
std::string fidelity_timed_page(const StudyData& data, const StudyTimes& times) {
  return html::page(data, &times);
}

}  // namespace cuesta
