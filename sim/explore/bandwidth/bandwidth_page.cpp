#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "models/rays/hit.h"
#include "reports/html/html_text.h"
#include "reports/html/svg_dot_plot.h"
#include "reports/numbers.h"
#include "reports/study/study_parts.h"
#include "reports/study/study_plots.h"
#include "sim/explore/bandwidth/bandwidth.h"
#include "sim/explore/study/plan_parts.h"

namespace cuesta {
namespace html {
namespace {

constexpr Quotient kCyclesPerRay{"cycles", "rays"};
constexpr Quotient kReadPerRay{"dram_read_bytes", "rays"};
constexpr Quotient kHitRate{"l1_hits", "l1_lookups", 100};

Where on_mobile(Where where) {
  where.emplace_back("machine", "mobile");
  return where;
}

std::string over_views(const StudyTable& table, const std::string& id, const Quotient& quotient,
                       const std::string& unit, bool logarithmic) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const std::string& depth : table.axis("depth").values) {
    for (const std::string& size : table.axis("size").values) {
      panels.emplace_back(depth_and_size(depth, size),
                          map_plots(table, quotient, depth, size, on_mobile({}), unit, logarithmic));
    }
  }
  return choice(id, panels);
}

/// Tells what steps alone would not have told; every number from the data.
std::string surprises_section(const StudyTable& table) {
  auto spread_of = [&](std::string_view algorithm, std::string_view base, std::string_view counter,
                       Where where, Angles angles) {
    return spread_text(spread_against(table, algorithm, base, counter, on_mobile(std::move(where)), angles));
  };
  constexpr Angles kOblique{50, 60};
  const std::string& large = table.axis("size").values.back();
  const std::string& small = table.axis("size").values.front();
  std::string html = "<ul class=\"prose\">";
  html +=
      "<li><b>In oblique views, steps saved at the top of the pyramid save no time.</b> The start-level "
      "decision "
      "alone "
      "against oh2006 at 50°: steps " +
      spread_of("yun2013-start", "oh2006", "steps", {}, kOblique) + "; cycles " +
      spread_of("yun2013-start", "oh2006", "cycles", {}, kOblique) +
      ". The levels near the root are a few lines that never leave the L1, and the pipe waits for the "
      "leaves' "
      "lines: what is skipped was free.</li>";
  html +=
      "<li><b>Going up too often costs steps, not cycles.</b> drobot2009 against yun2013 from 75° on, " +
      large + " texels: steps " + spread_of("drobot2009", "yun2013", "steps", {{"size", large}}, kGrazing) +
      "; cycles " + spread_of("drobot2009", "yun2013", "cycles", {{"size", large}}, kGrazing) +
      "; DRAM bytes " + spread_of("drobot2009", "yun2013", "dram_read_bytes", {{"size", large}}, kGrazing) +
      ". Its extra visits are to upper levels, which are in the cache; both need the same lines below. On " +
      small + " texels, where the pipe and not the DRAM is full, cycles are " +
      spread_of("drobot2009", "yun2013", "cycles", {{"size", small}}, kGrazing) + ".</li>";
  html +=
      "<li><b>On white noise the plain walk is hard to beat.</b> dda against yun2013 on noise, " + small +
      " texels, at 50°: cycles " +
      spread_of("dda", "yun2013", "cycles", {{"map", "noise"}, {"size", small}}, kOblique) + ", DRAM bytes " +
      spread_of("dda", "yun2013", "dram_read_bytes", {{"map", "noise"}, {"size", small}}, kOblique) +
      "; from 75° on: cycles " +
      spread_of("dda", "yun2013", "cycles", {{"map", "noise"}, {"size", small}}, kGrazing) +
      ". A texel as high as the top stands in nearly every block, so the bounds skip nothing; the walk reads "
      "neighbours in a line of level 0, while a pyramid reads a line on every level.</li>";
  const auto rate = [&](const char* algorithm) {
    const auto found =
        median_of(table, on_mobile({{"size", large}, {"angle", "0"}, {"algorithm", algorithm}}), kHitRate);
    return found ? significant(*found, 2) + " %" : "-";
  };
  html += "<li><b>The better schedule can have the worse hit rate.</b> Front views, " + large +
          " texels: " + rate("yun2013") + " for yun2013 and " + rate("oh2006") +
          " for oh2006, with DRAM bytes " +
          spread_of("yun2013", "oh2006", "dram_read_bytes", {{"size", large}}, {0, 10}) +
          ". oh2006's hits are the way down from the root, which yun2013 does not make.</li>";
  return study_section("What steps alone do not tell", "", with_firm_spaces(html) + "</ul>");
}

std::string ratio_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  const std::pair<const char*, const char*> counters[] = {{"cycles", "cycles"},
                                                          {"steps", "steps"},
                                                          {"DRAM bytes read", "dram_read_bytes"},
                                                          {"warp steps", "simt_slots"}};
  for (const auto& [name, counter] : counters) {
    const std::string_view of = counter;
    panels.emplace_back(
        name, median_table(
                  table, "angle", table.axis("algorithm").values, on_mobile({}),
                  [&table, of](const StudyPlace& place) { return against(table, place, "oh2006", of); },
                  percent_change));
  }
  return study_section("Against oh2006",
                       "Median over maps, sizes and depths of the change on the same rays, mobile.",
                       choice("ratio", panels));
}

std::string size_section(const StudyTable& table) {
  std::string html = "<div class=\"grid wide\">";
  for (const auto& [title, quotient, unit, logarithmic] :
       {std::tuple{"L1 hit rate", kHitRate, "%", false},
        std::tuple{"DRAM bytes read per ray", kReadPerRay, "B/ray", true}}) {
    for (const std::string& angle : some_values(table.axis("angle"), 2)) {
      LinePlot plot =
          lines_over(table, "size", published(table), unit, true,
                     [&, q = quotient](const std::string& algorithm, const std::string& size) {
                       return median_of(
                           table, on_mobile({{"size", size}, {"angle", angle}, {"algorithm", algorithm}}), q);
                     });
      plot.title = std::string(title) + ", " + angle + "°";
      plot.remark = "median over maps and depths, against the map's side (logarithmic)";
      plot.logarithmic = logarithmic;
      html += svg_line_plot(plot);
    }
  }
  return study_section(
      "The cache and the map's size",
      "The L1 holds 16 KiB. A pixel covers more texels as the map grows, so neighbours share fewer "
      "lines: what a level of detail is for.",
      html + "</div>");
}

/// Draws the bytes of each algorithm in one view: compulsory, read, and without a cache.
std::string ends_plot(const StudyTable& table, const Where& view, const std::string& title) {
  DotPlot plot;
  plot.title = title;
  plot.remark = "bytes of the picture, logarithmic";
  plot.unit = "bytes";
  plot.legend = {{"s0", "each line once", ""}, {"s1", "read from DRAM", ""}, {"s7", "without a cache", ""}};
  for (const std::string& algorithm : table.axis("algorithm").values) {
    Where where = view;
    where.emplace_back("algorithm", algorithm);
    const auto at = places_where(table, where);
    if (at.empty()) continue;
    auto bytes = [&](std::string_view counter, double scale) {
      return scale * static_cast<double>(table.value(at.front(), counter).value_or(0));
    };
    const double once = bytes("unique_lines", 64), read = bytes("dram_read_bytes", 1),
                 none = bytes("texel_bytes", 1);
    auto tip = [&](const char* what, double value) {
      return algorithm + "\n" + what + ": " + readable(value, "bytes");
    };
    DotRow row{algorithm, readable(read, "bytes"), {}};
    row.dots = {{"s7", none, tip("without a cache", none), ""},
                {"s1", read, tip("read from DRAM", read), ""},
                {"s0", once, tip("each line once", once), ""}};
    std::stable_sort(row.dots.begin(), row.dots.end(),
                     [](const Segment& a, const Segment& b) { return a.value > b.value; });
    plot.rows.push_back(row);
  }
  return plot.rows.empty() ? "" : svg_dot_plot(plot);
}

std::string ends_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  const std::string& depth = table.axis("depth").values.back();
  for (const std::string& size : table.axis("size").values) {
    std::string html = "<div class=\"grid wide\">";
    for (const std::string& angle : some_values(table.axis("angle"), 4)) {
      html += ends_plot(table,
                        on_mobile({{"map", "fractal"}, {"size", size}, {"depth", depth}, {"angle", angle}}),
                        "fractal, " + size + " texels, depth " + depth + ", " + angle + "°");
    }
    panels.emplace_back(size + " texels", html + "</div>");
  }
  return study_section(
      "Between the two ends",
      "Every different line read once is the least that any cache of this line size can read; every "
      "texel read from DRAM is what no cache would. More than that: lines brought in more than was "
      "used of them.",
      choice("ends", panels));
}

std::string machines_section(const StudyTable& table) {
  std::string size;
  for (const StudyPlace& place : places_where(table, {{"machine", "desktop"}}))
    size = name_at(table, place, "size");
  if (size.empty()) return "";
  std::vector<std::pair<std::string, std::string>> panels;
  for (const std::string& depth : table.axis("depth").values) {
    for (const std::string& angle : table.axis("angle").values) {
      std::vector<std::vector<std::string>> rows;
      for (const std::string& algorithm : table.axis("algorithm").values) {
        std::vector<std::string> row{escape(algorithm)};
        for (const std::string& machine : table.axis("machine").values) {
          const auto at = places_where(table, {{"map", "fractal"},
                                               {"size", size},
                                               {"depth", depth},
                                               {"angle", angle},
                                               {"machine", machine},
                                               {"algorithm", algorithm}});
          if (at.empty()) break;
          const double clock = 1e6 * static_cast<double>(table.value(at.front(), "clock_mhz").value_or(0));
          const double cycles = static_cast<double>(table.value(at.front(), "cycles").value_or(1));
          const double rays = static_cast<double>(table.value(at.front(), "rays").value_or(0));
          auto number = [&](const Quotient& q) {
            return significant(value_of(table, at.front(), q).value_or(NAN), 3);
          };
          row.insert(row.end(), {number(kCyclesPerRay), with_prefix(rays * clock / cycles, ""),
                                 significant(clock / cycles, 3), number(kHitRate) + " %", number(kReadPerRay),
                                 number({"starved_cycles", "pipe_cycles", 100}) + " %"});
        }
        if (row.size() > 7) rows.push_back(row);
      }
      if (rows.empty()) continue;
      std::vector<std::string> head{"fractal, " + size + " texels"};
      for (const std::string& machine : table.axis("machine").values) {
        for (const char* column :
             {"cycles / ray", "rays / s", "frames / s", "L1 hits", "B read / ray", "starved"}) {
          head.push_back(machine + "<br>" + column);
        }
      }
      panels.emplace_back("depth " + depth + ", " + angle + "°", plain_table(head, rows));
    }
  }
  return study_section(
      "Two machines, and frames per second",
      fmt::format("A frame is the picture of {} x {} rays, all of which hit, at the preset's clock. Starved: "
                  "share of the pipes' cycles in which every context waited for memory.",
                  kViewWidth, kViewHeight),
      choice("machines", panels));
}

}  // namespace
}  // namespace html

std::string bandwidth_headline(const StudyData& data) {
  using namespace html;
  const StudyTable table(data);
  const Spread front = spread_against(table, "yun2013", "oh2006", "cycles", on_mobile({}), kFront);
  const Spread grazing = spread_against(table, "yun2013", "oh2006", "cycles", on_mobile({}), kGrazing);
  const Spread bytes = spread_against(table, "yun2013", "oh2006", "dram_read_bytes", on_mobile({}), kGrazing);
  if (front.views == 0 || grazing.views == 0) return kEndedTooEarly;
  const std::vector<std::string>& sizes = table.axis("size").values;
  const auto small =
      median_of(table, on_mobile({{"size", sizes.front()}, {"algorithm", "yun2013"}}), kHitRate);
  const auto large =
      median_of(table, on_mobile({{"size", sizes.back()}, {"algorithm", "yun2013"}}), kHitRate);
  return fmt::format(
      "On the mobile preset yun2013 needs {:.0f} % fewer cycles than oh2006 in front views (to 30°) and "
      "{:.0f} % fewer "
      "from 75° on, where it reads {:.0f} % fewer bytes from DRAM (medians over {} and {} views); its L1 hit "
      "rate "
      "falls from {:.0f} % on maps of {} texels a side to {:.0f} % on {}.",
      100 * (1 - front.median), 100 * (1 - grazing.median), 100 * (1 - bytes.median), front.views,
      grazing.views, small.value_or(0), sizes.front(), large.value_or(0), sizes.back());
}

std::string bandwidth_page(const StudyData& data) {
  using namespace html;
  const StudyTable table(data);
  return study_shell(
      data, bandwidth_headline(data),
      ratio_section(table) + surprises_section(table) +
          study_section(
              "Cycles per ray against the angle",
              "Machine cycles over rays, mobile; the axis is logarithmic. Set-up lets in one ray in four "
              "cycles: no schedule is below that.",
              over_views(table, "cycles", kCyclesPerRay, "cycles/ray", true)) +
          study_section(
              "Bytes read from DRAM per ray",
              fmt::format("Heights only; hit records add {} bytes a ray for everybody.", kHitRecordBytes),
              over_views(table, "bytes", kReadPerRay, "B/ray", true)) +
          size_section(table) + ends_section(table) + machines_section(table) +
          study_section("What the literature says, what we get, why they differ", "",
                        statements(statements_on_cycles(), table)) +
          study_method(data));
}

}  // namespace cuesta
