#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/algorithms/schedule.h"
#include "models/work/hit_judge.h"
#include "reports/html/html_text.h"
#include "reports/html/svg_bar_plot.h"
#include "reports/numbers.h"
#include "reports/study/study_parts.h"
#include "reports/study/view_times_section.h"
#include "sim/explore/accuracy/accuracy.h"
#include "sim/explore/study/ray_ends.h"

namespace cuesta {
namespace html {

namespace {

bool is_exact(const std::string& algorithm) { return parse_algorithm(algorithm).exact(); }

/// Names what shares a colour: exact algorithms, and searches that differ in parameters alone.
std::string kind_of(const std::string& algorithm) {
  return is_exact(algorithm) ? "exact" : algorithm.substr(0, algorithm.find(':'));
}

/// Reads the rays that are wrong, per cent.
ReadPlace wrong_reader(const StudyTable& table) {
  return [&table](const StudyPlace& place) { return share_of_rays(table, {place}, wrong_counters()); };
}

std::string percentage(double value) { return significant(value, 3) + " %"; }

constexpr const char* kExactOne = "yun2013";
constexpr Quotient kCycles{"cycles", "rays"}, kSteps{"steps", "rays"}, kBytes{"dram_read_bytes", "rays"};

double median_or_0(const StudyTable& table, const Where& where, const ReadPlace& number) {
  return median_of(table, where, number).value_or(0);
}

ReadPlace reader(const StudyTable& table, const Quotient& quotient) {
  return [&table, quotient](const StudyPlace& place) { return value_of(table, place, quotient); };
}

/// Draws error, cycles and bytes of every algorithm in the views of one depth and angle: medians over the
/// maps.
ScatterPlot cost_plot(const StudyTable& table, const std::string& depth, const std::string& angle) {
  ScatterPlot plot;
  plot.title = "depth " + escape(depth) + ", " + escape(angle) + "°";
  plot.remark = "medians over the maps; a dot's area: DRAM bytes read per ray; dashed: the Pareto front";
  plot.x_label = "cycles per ray (logarithmic)";
  plot.y_label = "rays that are wrong, % (logarithmic above 0)";
  plot.front = true;
  for (const std::string& algorithm : table.axis("algorithm").values) {
    const Where where = {{"depth", depth}, {"angle", angle}, {"algorithm", algorithm}};
    if (places_where(table, where).empty()) continue;
    ScatterPoint point;
    point.x = median_or_0(table, where, reader(table, kCycles));
    point.y = median_or_0(table, where, wrong_reader(table));
    point.area = median_or_0(table, where, reader(table, kBytes));
    point.tip = fmt::format("{}\n{} % of the rays wrong\n{} cycles/ray\n{} steps/ray\n{} DRAM bytes/ray",
                            algorithm, significant(point.y, 3), significant(point.x, 3),
                            significant(median_or_0(table, where, reader(table, kSteps)), 3),
                            significant(point.area, 3));
    add_point(kind_of(algorithm), std::move(point), plot);
  }
  return plot;
}

std::string cost_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  std::vector<std::string> depths = table.axis("depth").values, angles = table.axis("angle").values;
  std::reverse(depths.begin(), depths.end());  // where algorithms differ most comes first
  std::reverse(angles.begin(), angles.end());
  for (const std::string& depth : depths) {
    for (const std::string& angle : angles) {
      const ScatterPlot plot = cost_plot(table, depth, angle);
      std::vector<std::vector<std::string>> rows;
      const ScatterPoint* before = nullptr;
      for (const ScatterPoint* point : pareto_front(plot)) {
        const std::string name = point->tip.substr(0, point->tip.find('\n'));
        rows.push_back({escape(name), significant(point->y, 3) + " %", significant(point->x, 3),
                        before == nullptr ? "" : "× " + significant(point->x / before->x, 3),
                        before == nullptr ? "" : "− " + significant(before->y - point->y, 3) + " %"});
        before = point;
      }
      panels.emplace_back(
          "depth " + depth + ", " + angle + "°",
          svg_scatter_plot(plot) + "<h3>What each next step of accuracy costs</h3><br>" +
              plain_table({"on the front", "wrong rays", "cycles / ray", "cycles against the row above",
                           "wrong rays against the row above"},
                          rows));
    }
  }
  return study_section(
      "Error, cycles and bytes",
      "Down is more right, left is quicker, small is less traffic. Lines join one search with more "
      "and more steps.",
      choice("cost", panels));
}

std::string verdict_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const std::string& depth : table.axis("depth").values) {
    panels.emplace_back("wrong rays, depth " + depth,
                        median_table(table, "angle", table.axis("algorithm").values, {{"depth", depth}},
                                     wrong_reader(table), percentage));
  }
  BarPlot plot;
  plot.title = "Verdicts over all views";
  plot.remark = "share of all rays";
  plot.full = 100;
  constexpr RayEnd kEnds[] = {kExactEnd, kTieEnd, kWrongCellEnd, kBehindEnd, kMissedEnd};
  add_ray_ends(
      table, kEnds, percentage,
      [&](const std::string& algorithm) {
        const auto wrong =
            share_of_rays(table, places_where(table, {{"algorithm", algorithm}}), wrong_counters());
        return Bar{algorithm, percentage(wrong.value_or(0)) + " wrong", {}, false};
      },
      plot);
  panels.emplace_back("all verdicts", svg_bar_plot(plot));
  return study_section(
      "How many rays are wrong",
      "Medians over the maps of the rays that missed, hit behind the truth or hit a wrong cell; "
      "ties are right.",
      choice("verdicts", panels));
}

std::string error_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const std::string& depth : table.axis("depth").values) {
    for (const std::string& angle : some_values(table.axis("angle"), 3)) {
      std::vector<std::vector<std::string>> rows;
      for (const std::string& algorithm : table.axis("algorithm").values) {
        const Where where = {{"depth", depth}, {"angle", angle}, {"algorithm", algorithm}};
        if (places_where(table, where).empty()) continue;
        const auto text = [&](std::string_view counter, double scale) {
          return significant(median_or_0(table, where, reader(table, {counter, "", scale})), 3);
        };
        const auto each = [&](const Quotient& quotient) {
          return significant(median_or_0(table, where, reader(table, quotient)), 3);
        };
        rows.push_back({escape(algorithm), text("height_rms", 1 / kErrorParts),
                        text("height_p99", 1 / kErrorParts), text("height_max", 1 / kErrorParts),
                        text("texel_rms", 1 / kErrorParts), text("texel_p99", 1 / kErrorParts),
                        text("texel_max", 1 / kErrorParts), text("psnr", 0.01), text("ssim", 1e-6),
                        each(kSteps), each(kCycles), each(kBytes), text("preprocessing_texels", 1e-6),
                        text("map_bytes", 1.0 / 1024)});
      }
      panels.emplace_back(
          "depth " + depth + ", " + angle + "°",
          plain_table({"medians over the maps", "height RMS (LSB)", "p99 (LSB)", "max (LSB)", "texels RMS",
                       "p99 (texels)", "max (texels)", "PSNR (dB)", "SSIM", "steps / ray", "cycles / ray",
                       "DRAM bytes / ray", "preprocessing (M texels read)", "map (KiB)"},
                      rows));
    }
  }
  return study_section(
      "How far from the truth",
      "Along the ray, over rays that hit: as a difference in height, and in the plane of the map; "
      "and the picture of depths as a whole. 8-bit heights: 1 LSB is 1/255 of the depth.",
      choice("errors", panels));
}

/// Finds the search of least cycles whose median of wrong rays is at most `limit` per cent; nullptr: none.
const std::string* cheapest(const StudyTable& table, const std::string& depth, const std::string& angle,
                            double limit) {
  const std::string* best = nullptr;
  double least = 0;
  for (const std::string& algorithm : table.axis("algorithm").values) {
    const Where where = {{"depth", depth}, {"angle", angle}, {"algorithm", algorithm}};
    if (is_exact(algorithm) || places_where(table, where).empty()) continue;
    if (median_or_0(table, where, wrong_reader(table)) > limit) continue;
    const double cycles = median_or_0(table, where, reader(table, kCycles));
    if (best == nullptr || cycles < least) {
      best = &algorithm;
      least = cycles;
    }
  }
  return best;
}

std::string one_percent_section(const StudyTable& table) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& depth : table.axis("depth").values) {
    for (const std::string& angle : table.axis("angle").values) {
      const Where exact = {{"depth", depth}, {"angle", angle}, {"algorithm", kExactOne}};
      const double cycles = median_or_0(table, exact, reader(table, kCycles));
      std::vector<std::string> row = {fmt::format("depth {}, {}°", depth, angle), significant(cycles, 3)};
      for (const double limit : {10.0, 1.0, 0.1}) {
        const std::string* name = cheapest(table, depth, angle, limit);
        if (name == nullptr) {
          row.push_back("none");
          continue;
        }
        const double its = median_or_0(table, {{"depth", depth}, {"angle", angle}, {"algorithm", *name}},
                                       reader(table, kCycles));
        row.push_back(
            fmt::format("{}: {} (× {})", escape(*name), significant(its, 3), significant(its / cycles, 3)));
      }
      rows.push_back(std::move(row));
    }
  }
  return study_section(
      "The cheapest search that is right enough",
      "Cycles per ray, medians over the maps; in brackets against yun2013. Exact algorithms differ from the "
      "truth by "
      "the rounding of their reciprocals alone: " +
          significant(median_or_0(table, {{"algorithm", kExactOne}}, wrong_reader(table)), 2) +
          " % of the rays (median), " +
          significant(spread(places_where(table, {{"algorithm", kExactOne}}), wrong_reader(table)).largest,
                      2) +
          " % at most.",
      plain_table({"views", "yun2013", "at most 10 % wrong", "at most 1 % wrong", "at most 0.1 % wrong"},
                  rows));
}

std::string picture_section(const StudyData& data) {
  if (data.pictures.empty()) return "";
  std::string html;
  for (const StudyPicture& picture : data.pictures) {
    html += fmt::format(
        "<figure class=\"panels\"><img alt=\"{0}\" "
        "src=\"data:image/png;base64,{1}\"><figcaption>{0}</figcaption>"
        "</figure>",
        escape(picture.caption), base64(picture.png));
  }
  return study_section(
      "What errors look like",
      "Side by side: how far down each pixel sees, the steps that it took, and which pixels are wrong.",
      html);
}

}  // namespace
}  // namespace html

std::string accuracy_headline(const StudyData& data) {
  using namespace html;
  const StudyTable table(data);
  const std::string& depth = table.axis("depth").values.back();
  const auto figure = [&](const char* algorithm, Angles angles) {
    std::vector<StudyPlace> places;
    for (const StudyPlace& place : places_where(table, {{"depth", depth}, {"algorithm", algorithm}})) {
      if (within(table, place, angles)) places.push_back(place);
    }
    return spread(places, wrong_reader(table));
  };
  const auto cost = [&](const char* algorithm, Angles angles) {
    return spread_against(table, algorithm, kExactOne, "cycles", {{"depth", depth}}, angles);
  };
  const Spread relief = figure("relief", kGrazing), cone = figure("cone", kGrazing);
  const Spread relief_cost = cost("relief", kGrazing), cone_cost = cost("cone", kGrazing);
  if (relief.views == 0 || cone.views == 0) return kEndedTooEarly;
  size_t beaten = 0, views = 0;
  for (const std::string& one : table.axis("depth").values) {
    for (const std::string& angle : table.axis("angle").values) {
      const std::string* name = cheapest(table, one, angle, 1.0);
      ++views;
      if (name == nullptr) continue;
      const double its = median_or_0(table, {{"depth", one}, {"angle", angle}, {"algorithm", *name}},
                                     reader(table, kCycles));
      beaten += its < median_or_0(table, {{"depth", one}, {"angle", angle}, {"algorithm", kExactOne}},
                                  reader(table, kCycles));
    }
  }
  const Spread exact_cost = spread(places_where(table, {{"depth", depth}, {"algorithm", kExactOne}}),
                                   [&](const StudyPlace& place) -> std::optional<double> {
                                     if (!within(table, place, kGrazing)) return std::nullopt;
                                     return value_of(table, place, kCycles);
                                   });
  const Search one_relief = parse_search("relief"), one_cone = parse_search("cone");
  return fmt::format(
      "At grazing angles (from {:g}°, depth {}) yun2013 takes {} cycles per ray and errs by the rounding of "
      "its "
      "numbers alone, on {} % of the rays; relief with {} + {} steps takes {} times as many and is wrong on "
      "{} % "
      "of the rays, cone stepping with at most {} takes {} times as many and is wrong on {} % (lower medians "
      "over {} views). A search that is right on 99 % of the rays takes fewer cycles than yun2013 in {} of "
      "{} "
      "classes of views.",
      kGrazing.least, depth, significant(exact_cost.median, 3),
      significant(figure(kExactOne, kGrazing).median, 2), one_relief.steps, one_relief.refinements,
      significant(relief_cost.median, 2), significant(relief.median, 2), one_cone.steps,
      significant(cone_cost.median, 2), significant(cone.median, 2), relief.views, beaten, views);
}

namespace html {
namespace {

std::string page(const StudyData& data, const StudyTimes* times) {
  const StudyTable table(data);
  return study_shell(
      data, accuracy_headline(data),
      cost_section(table) + one_percent_section(table) +
          (times != nullptr ? view_times_section(table, *times,
                                                 {"What being right costs in wall time", kExactOne, kind_of,
                                                  wrong_reader(table), "rays that are wrong"})
                            : "") +
          picture_section(data) + verdict_section(table) + error_section(table) + study_method(data));
}

}  // namespace
}  // namespace html

std::string accuracy_page(const StudyData& data) { return html::page(data, nullptr); }
std::string accuracy_timed_page(const StudyData& data, const StudyTimes& times) {
  return html::page(data, &times);
}

}  // namespace cuesta
