#include <fmt/format.h>

#include "reports/html/html_text.h"
#include "reports/numbers.h"
#include "reports/study/study_parts.h"
#include "sim/explore/iterations/iterations.h"

namespace cuesta::html {
namespace {

std::string steps_text(const StudyTable& table, const Where& where) {
  const auto at = places_where(table, where);
  if (at.empty()) return "-";
  const auto value = value_of(table, at.front(), {"steps", "rays"});
  return value ? significant(*value, 3) : "-";
}

std::string fewest_against(const StudyTable& table, std::string_view base, std::string_view counter) {
  const Spread found = spread_against(table, "yun2013", base, counter, {});
  if (found.views == 0) return "no such view in these data. ";
  return fmt::format("against {}: {} at most ({}), median {}. ", escape(base), percent_change(found.least),
                     escape(view_name(table, found.least_at)), percent_change(found.median));
}

std::string up_to_66(const StudyTable& table) {
  return fewest_against(table, "oh2006", "steps") + fewest_against(table, "drobot2009", "steps") +
         fewest_against(table, "tevs2008", "steps");
}

std::string which_part_pays(const StudyTable& table) {
  std::string text;
  for (const char* part : {"yun2013-start", "yun2013-down", "yun2013-up", "yun2013-coherent-up"}) {
    const Spread front = spread_against(table, part, "oh2006", "steps", {}, kFront);
    const Spread grazing = spread_against(table, part, "oh2006", "steps", {}, kGrazing);
    if (front.views == 0 || grazing.views == 0) continue;
    text += fmt::format("{}: {} to 30°, {} from 75° (medians). ", part, percent_change(front.median),
                        percent_change(grazing.median));
  }
  return text.empty() ? "the parts are not in these data" : text;
}

std::string best_case(const StudyTable& table) {
  std::string text;
  for (const std::string& size : table.axis("size").values) {
    const Spread found =
        spread(places_where(table, {{"size", size}, {"algorithm", "oh2006"}}), [&](const StudyPlace& place) {
          return value_of(table, place, {"steps", "rays"});
        });
    if (found.views == 0) continue;
    text += fmt::format("{}{}: {} ({})", text.empty() ? "" : "; ", size, significant(found.least, 3),
                        escape(name_at(table, found.least_at, "angle") + "°"));
  }
  return "fewest steps per ray of oh2006 by the map's side: " + text + ".";
}

std::string tevs_against_drobot(const StudyTable& table) {
  return "tevs2008 against drobot2009: " +
         spread_text(spread_against(table, "tevs2008", "drobot2009", "steps", {})) +
         "; against drobot2009-interval: " +
         spread_text(spread_against(table, "tevs2008", "drobot2009-interval", "steps", {})) + ".";
}

std::string both_even(const StudyTable& table) {
  return "tevs2008-both-even against tevs2008: " +
         spread_text(spread_against(table, "tevs2008-both-even", "tevs2008", "steps", {})) + ".";
}

std::string selective_alone(const StudyTable& table) {
  return "without the even test (yun2013-up-selective) against tevs2008: " +
         spread_text(spread_against(table, "yun2013-up-selective", "tevs2008", "steps", {})) +
         "; with it (yun2013-up): " +
         spread_text(spread_against(table, "yun2013-up", "tevs2008", "steps", {})) + ".";
}

std::string coherent_alone(const StudyTable& table) {
  return "yun2013-coherent-up against tevs2008: " +
         spread_text(spread_against(table, "yun2013-coherent-up", "tevs2008", "steps", {})) + ".";
}

struct PrototypeRow {
  const char *map, *depth, *angle, *steps;
};

/// Steps per ray of Oh / Tevs / Yun on 256 x 256.
std::string prototype_table(const StudyTable& table) {
  static constexpr PrototypeRow kRows[] = {
      {"fractal", "0.05", "10", "9.1 / 9.1 / 3.0"},    {"fractal", "0.05", "50", "9.7 / 10.0 / 5.7"},
      {"fractal", "0.05", "75", "11.0 / 11.9 / 8.8"},  {"fractal", "0.05", "86", "17.3 / 18.4 / 15.9"},
      {"fractal", "0.35", "10", "9.7 / 10.0 / 5.7"},   {"fractal", "0.35", "50", "13.6 / 15.1 / 12.4"},
      {"fractal", "0.35", "75", "21.7 / 21.7 / 19.5"}, {"fractal", "0.35", "86", "45.3 / 34.0 / 32.5"},
      {"spikes", "0.35", "10", "13.7 / 14.0 / 10.2"},  {"spikes", "0.35", "50", "52.1 / 33.7 / 31.2"},
      {"spikes", "0.35", "75", "127 / 59.4 / 57.4"},   {"spikes", "0.35", "86", "195 / 78.9 / 77.4"},
      {"noise", "0.35", "10", "12.2 / 13.3 / 8.8"},    {"noise", "0.35", "50", "16.8 / 17.7 / 14.6"},
      {"noise", "0.35", "75", "23.1 / 22.6 / 19.9"},   {"noise", "0.35", "86", "33.4 / 28.8 / 26.3"},
  };
  std::vector<std::vector<std::string>> rows;
  for (const PrototypeRow& row : kRows) {
    auto steps = [&](const char* algorithm) {
      return steps_text(table, {{"map", row.map},
                                {"size", "256"},
                                {"depth", row.depth},
                                {"angle", row.angle},
                                {"algorithm", algorithm}});
    };
    rows.push_back({fmt::format("{}, {}, {}°", row.map, row.depth, row.angle), row.steps,
                    steps("oh2006") + " / " + steps("tevs2008") + " / " + steps("yun2013")});
  }
  return plain_table({"256 texels: map, depth, angle", "prototype: Oh / Tevs / Yun", "here"}, rows);
}

std::string prototype_leaf_walk(const StudyTable& table) {
  std::string text = "dda, steps per ray at 10 / 50 / 75 / 86°:";
  for (const char* map : {"fractal", "noise"}) {
    text += fmt::format(" {}", map);
    for (const char* angle : {"10", "50", "75", "86"}) {
      text += (angle == std::string("10") ? " " : " / ") +
              steps_text(
                  table,
                  {{"map", map}, {"size", "256"}, {"depth", "0.35"}, {"angle", angle}, {"algorithm", "dda"}});
    }
    text += ";";
  }
  text.back() = '.';
  return text;
}

std::string second_prototype(const StudyTable& table) {
  auto one = [&](const Where& where, Angles angles) {
    return spread_text(spread_against(table, "yun2013", "oh2006", "steps", where, angles));
  };
  std::string text = "yun2013 against oh2006. To 10°, depth 0.05: ";
  for (const char* size : {"256", "1024"}) {
    text += fmt::format("{} on {}; ", one({{"depth", "0.05"}, {"size", size}}, {0, 10}), size);
  }
  text += "depth 0.35: " + one({{"depth", "0.35"}}, {0, 10}) + ". From 75°: ";
  for (const char* size : {"256", "1024", "4096"})
    text += fmt::format("{} on {}; ", one({{"size", size}}, kGrazing), size);
  text.resize(text.size() - 2);
  return text + ".";
}

}  // namespace

const std::vector<Statement>& statements_on_steps() {
  static const std::vector<Statement> all = {
      {"Yun, Kwon, Nah, Manocha, Park 2013", "printed",
       "Up to 66 % fewer steps than other pyramidal methods.", up_to_66,
       "Their scenes and views are not at hand. The largest savings here are where a ray's start and end "
       "share a small "
       "node, so that the start-level decision skips the whole way down from the root; a larger map makes "
       "that way "
       "longer, and so the percentage larger. It is an upper bound in both, the median is what to plan "
       "with."},
      {"Yun et al. 2013", "printed",
       "Front views gain from start level and multi-level down, grazing ones from level-up.", which_part_pays,
       "Held alone over oh2006. A part that pays nothing alone in a class of views may still pay beside "
       "another."},
      {"Ki & Oh 2007", "printed", "Best case log2(N) steps; n + 1 by their loop, 9 for 256.", best_case,
       "A front view of constant texels goes down once from root to leaf, a visit a level. With the "
       "start-level "
       "decision the best case is one step, whatever the size."},
      {"Yun et al. 2013", "printed", "Tevs is faster than Drobot in general.", tevs_against_drobot,
       "Going up after every crossing pays only where the next thing is empty; it is repaid at each return."},
      {"An earlier program of ours", "prototype",
       "Tevs with both indices even takes 0 to 6 % fewer steps than with an even axis.", both_even,
       "Maps and views differ; the order of the two is what to compare."},
      {"An earlier program of ours", "reconstructed, prototype",
       "Selective level-up alone: 5 % better to 26 % worse than Tevs; with the even test 0.5 to 9 % better.",
       selective_alone,
       "The rule is printed, its details are reconstructed. Without the even test a ray goes up in the "
       "middle of its "
       "parent, and its next descent leads back where it was."},
      {"An earlier program of ours", "prototype", "Coherent level-up is within 7 % of Tevs either way.",
       coherent_alone, "Here over all sizes and angles; the prototype's were fewer."},
      {"An earlier program of ours", "prototype", "Steps per ray on 256 x 256, wrap, uniform phase.",
       prototype_table,
       "Its maps bear the same names but are others: compare the order of the algorithms and their ratios. "
       "No map here "
       "was made to meet these figures."},
      {"An earlier program of ours", "prototype",
       "The leaf walk, depth 0.35: fractal 9 / 53 / 143 / 391, noise 6 / 14 / 25 / 46 steps per ray.",
       prototype_leaf_walk,
       "A leaf walk's steps are the texels that a ray passes over: they tell how deep a ray sinks into the "
       "map, so they "
       "show directly how much the maps differ."},
      {"A second earlier program of ours", "prototype",
       "Front views -66 to -76 % at small depth (to 1024 a side), -23 to -50 % at depth .3; grazing -8 to "
       "-24 % on 256, "
       "-11 to -44 % on 1024, up to -65 % on rough 4096.",
       second_prototype, "Which of its baselines is meant is not recorded; held against oh2006 here."},
  };
  return all;
}

}  // namespace cuesta::html
