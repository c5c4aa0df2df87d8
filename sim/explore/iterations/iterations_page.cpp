#include <fmt/format.h>

#include "models/common/words.h"
#include "reports/html/html_text.h"
#include "reports/html/svg_bar_plot.h"
#include "reports/numbers.h"
#include "reports/study/study_parts.h"
#include "reports/study/study_plots.h"
#include "sim/explore/iterations/iterations.h"
#include "sim/explore/study/plan_parts.h"

namespace cuesta {
namespace html {
namespace {

constexpr Quotient kStepsPerRay{"steps", "rays"};
constexpr Quotient kSimt{"steps", "simt_slots", 100};

std::string steps_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const std::string& depth : table.axis("depth").values) {
    for (const std::string& size : some_values(table.axis("size"), 3)) {
      panels.emplace_back(depth_and_size(depth, size),
                          map_plots(table, kStepsPerRay, depth, size, {}, "steps/ray", true));
    }
  }
  return study_section(
      "Steps per ray against the angle",
      "Mean node visits of a ray; the axis is logarithmic. 0° looks along the normal, 90° along the "
      "surface.",
      choice("steps", panels));
}

std::string ratio_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const std::string& depth : table.axis("depth").values) {
    panels.emplace_back("depth " + depth,
                        median_table(
                            table, "angle", table.axis("algorithm").values, {{"depth", depth}},
                            [&](const StudyPlace& place) { return against(table, place, "oh2006", "steps"); },
                            percent_change));
  }
  return study_section("Steps against oh2006",
                       "Median over maps and sizes of the change in steps on the same rays.",
                       choice("ratio", panels));
}

/// Tells what one would not have guessed; every number from the data.
std::string surprises_section(const StudyTable& table) {
  std::string html = "<ul class=\"prose\">";
  const Wins noise =
      wins(table, "steps", {{"map", "noise"}, {"size", table.axis("size").values.front()}}, kAnyAngle);
  if (noise.views > 0) {
    html += fmt::format(
        "<li><b>On rough maps the plain walk often beats every pyramid.</b> White noise, {} texels: dda "
        "takes the "
        "fewest "
        "steps of all published schedules in {} of {} views. A ray ends after a few texels, and a bound that "
        "is near "
        "the top everywhere skips none of them.</li>",
        table.axis("size").values.front(), noise.of("dda"), noise.views);
  }
  html +=
      "<li><b>A part of Yun's can cost more than it saves.</b> yun2013-up-selective (up whenever the "
      "neighbour "
      "would be skipped) against oh2006 between 50° and 75°: steps " +
      spread_text(spread_against(table, "yun2013-up-selective", "oh2006", "steps", {}, {50, 75})) +
      "; with the test of even indices (yun2013-up): " +
      spread_text(spread_against(table, "yun2013-up", "oh2006", "steps", {}, {50, 75})) +
      ". In the middle of its parent a ray that goes up must come down again at once.</li>";
  html += "<li><b>Warps gain far more than rays.</b> yun2013 against oh2006 from 75° on: steps " +
          spread_text(spread_against(table, "yun2013", "oh2006", "steps", {}, kGrazing)) +
          ", steps of warps " +
          spread_text(spread_against(table, "yun2013", "oh2006", "simt_slots", {}, kGrazing)) +
          ". Without level-up a few rays that pass low over the relief walk on at a fine level and hold "
          "their whole "
          "warp: going up shortens the longest ray, not the usual one.</li>";
  return study_section("What surprised", "", with_firm_spaces(html) + "</ul>");
}

std::string winners_section(const StudyTable& table) {
  std::string html = "<div class=\"grid\">";
  const std::pair<const char*, Angles> classes[] = {
      {"front: to 30°", kFront}, {"oblique: between", {31, 74}}, {"grazing: from 75°", kGrazing}};
  for (const auto& [name, angles] : classes) {
    const Wins found = wins(table, "steps", {}, angles);
    BarPlot plot;
    plot.title = name;
    plot.remark = fmt::format("share of {} views; several may share one", found.views);
    plot.full = 100;
    for (const auto& [algorithm, count] : found.least) {
      const double share =
          found.views == 0 ? 0 : 100.0 * static_cast<double>(count) / static_cast<double>(found.views);
      plot.bars.push_back(
          {algorithm,
           fmt::format("{:.0f} %", share),
           {{"accent", share, fmt::format("{}\n{} of {} views", algorithm, count, found.views), ""}},
           false});
    }
    html += svg_bar_plot(plot);
  }
  return study_section("Who takes the fewest steps",
                       "Published schedules; a view is a map, size, depth and angle.", html + "</div>");
}

std::string growth_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const std::string& depth : table.axis("depth").values) {
    std::string html = "<div class=\"grid wide\">";
    for (const std::string& angle : some_values(table.axis("angle"), 4)) {
      LinePlot plot = lines_over(
          table, "size", published(table), "steps/ray", true,
          [&](const std::string& algorithm, const std::string& size) {
            return median_of(table,
                             {{"size", size}, {"depth", depth}, {"angle", angle}, {"algorithm", algorithm}},
                             kStepsPerRay);
          });
      plot.title = angle + "°";
      plot.remark = "median over the maps, against the map's side (logarithmic)";
      plot.logarithmic = true;
      html += svg_line_plot(plot);
    }
    panels.emplace_back("depth " + depth, html + "</div>");
  }
  return study_section("Growth with the map's size", "The same tile in more detail.",
                       choice("growth", panels));
}

std::string parts_section(const StudyTable& table) {
  std::vector<std::string> names;
  for (const std::string& name : table.axis("algorithm").values) {
    if (name.starts_with("yun2013")) names.push_back(name);
  }
  std::string html = "<div class=\"grid wide\">";
  for (const std::string& depth : table.axis("depth").values) {
    LinePlot plot = lines_over(
        table, "angle", names, "%", false, [&](const std::string& algorithm, const std::string& angle) {
          const Spread found =
              spread_against(table, algorithm, "oh2006", "steps", {{"depth", depth}, {"angle", angle}});
          return found.views == 0 ? std::nullopt : std::optional(100 * found.median);
        });
    plot.title = "depth " + escape(depth);
    plot.remark = "steps in per cent of oh2006's, median over maps and sizes, against the angle";
    plot.reference = 100;
    html += svg_line_plot(plot);
  }
  html += "</div>";
  std::vector<std::vector<std::string>> rows;
  for (const std::string& name : names) {
    rows.push_back({escape(name)});
    for (const Angles angles : {kFront, kGrazing}) {
      for (const std::string& depth : table.axis("depth").values) {
        rows.back().push_back(
            escape(spread_text(spread_against(table, name, "oh2006", "steps", {{"depth", depth}}, angles))));
      }
    }
  }
  std::vector<std::string> head{"part"};
  for (const char* angles : {"to 30°", "from 75°"}) {
    for (const std::string& depth : table.axis("depth").values)
      head.push_back(fmt::format("{}, depth {}", angles, depth));
  }
  return study_section("Yun's parts, each alone",
                       "oh2006 with one thing changed, and all of them together. The dashed line is oh2006.",
                       html + plain_table(head, rows));
}

std::string simt_section(const StudyTable& table) {
  std::string html = "<div class=\"grid wide\">";
  for (const std::string& depth : table.axis("depth").values) {
    LinePlot plot = lines_over(
        table, "angle", published(table), "%", false,
        [&](const std::string& algorithm, const std::string& angle) {
          return median_of(table, {{"depth", depth}, {"angle", angle}, {"algorithm", algorithm}}, kSimt);
        });
    plot.title = "SIMT efficiency, depth " + escape(depth);
    plot.remark = "median over maps and sizes, against the angle";
    html += svg_line_plot(plot);
  }
  return study_section(
      "On a programmable GPU",
      fmt::format("Warps of {} x {} neighbouring pixels: mean over longest ray of the warp. The steps that a "
                  "warp waits for decide, not those that it takes.",
                  kWarpWidth, kWarpHeight),
      html + "</div>" + "<h3>Warp steps against oh2006</h3><br>" +
          median_table(
              table, "angle", table.axis("algorithm").values, {},
              [&](const StudyPlace& place) { return against(table, place, "oh2006", "simt_slots"); },
              percent_change));
}

std::string distribution_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  const std::vector<std::string> sizes = some_values(table.axis("size"), 3);
  const std::string& size = sizes[sizes.size() / 2];
  for (const std::string& depth : table.axis("depth").values) {
    for (const std::string& angle : some_values(table.axis("angle"), 4)) {
      std::vector<std::vector<std::string>> rows;
      for (const std::string& algorithm : table.axis("algorithm").values) {
        const auto at = places_where(table, {{"map", "fractal"},
                                             {"size", size},
                                             {"depth", depth},
                                             {"angle", angle},
                                             {"algorithm", algorithm}});
        if (at.empty()) continue;
        auto text = [&](const Quotient& quotient) {
          const auto value = value_of(table, at.front(), quotient);
          return value ? significant(*value, 3) : "-";
        };
        auto whole = [&](std::string_view counter) {
          return grouped(table.value(at.front(), counter).value_or(0));
        };
        rows.push_back({escape(algorithm), text(kStepsPerRay), whole("steps_median"), whole("steps_p99"),
                        whole("steps_max"), text({"fetches", "rays"}), text({"unique_texels", "rays"}),
                        text({"unique_lines", "rays"}), text(kSimt) + " %"});
      }
      panels.emplace_back(
          "depth " + depth + ", " + angle + "°",
          plain_table({"fractal, " + size + " texels", "steps / ray", "median", "p99", "longest",
                       "fetches / ray", "different texels / ray", "different lines / ray", "SIMT"},
                      rows));
    }
  }
  return study_section("One map in numbers", "How unlike each other the rays are, and how much they read.",
                       choice("numbers", panels));
}

}  // namespace
}  // namespace html

std::string iterations_headline(const StudyData& data) {
  using namespace html;
  const StudyTable table(data);
  const Spread front = spread_against(table, "yun2013", "oh2006", "steps", {}, kFront);
  const Spread grazing = spread_against(table, "yun2013", "oh2006", "steps", {}, kGrazing);
  if (front.views == 0 || grazing.views == 0) return kEndedTooEarly;
  const Wins all = wins(table, "steps", {}, kAnyAngle);
  std::string winners;
  for (const auto& [algorithm, views] : all.alone) {
    const double share = 100 * static_cast<double>(views) / static_cast<double>(all.views);
    if (share < 0.5) continue;
    winners += winners.empty() ? fmt::format("{} alone in {:.0f} % of the views", algorithm, share)
                               : fmt::format(", {} in {:.0f} %", algorithm, share);
  }
  std::vector<std::string_view> sharing;
  for (const auto& [algorithm, views] : all.alone) {
    if (all.of(algorithm) > views) sharing.push_back(algorithm);
  }
  if (all.shared > 0) {
    winners += fmt::format("{}several of {} alike in {:.0f} %", winners.empty() ? "" : "; ", joined(sharing),
                           100 * static_cast<double>(all.shared) / static_cast<double>(all.views));
  }
  return fmt::format(
      "yun2013 takes {:.0f} % fewer steps than oh2006 in front views (to 30°) and {:.0f} % fewer at grazing "
      "angles "
      "(from 75°), medians over {} and {} views, and up to {:.0f} % fewer on {}. The fewest steps of all "
      "published schedules: {}.",
      100 * (1 - front.median), 100 * (1 - grazing.median), front.views, grazing.views,
      100 * (1 - std::min(front.least, grazing.least)),
      view_name(table, front.least < grazing.least ? front.least_at : grazing.least_at), winners);
}

std::string iterations_page(const StudyData& data) {
  using namespace html;
  const StudyTable table(data);
  return study_shell(data, iterations_headline(data),
                     ratio_section(table) + steps_section(table) + winners_section(table) +
                         surprises_section(table) + parts_section(table) + growth_section(table) +
                         simt_section(table) + distribution_section(table) +
                         study_section("What the literature says, what we get, why they differ", "",
                                       statements(statements_on_steps(), table)) +
                         study_method(data));
}

}  // namespace cuesta
