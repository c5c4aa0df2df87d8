#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "models/common/words.h"
#include "models/units/statistics.h"
#include "reports/quantities.h"
#include "sim/cli/options.h"
#include "sim/cli/verbs.h"
#include "sim/config/architecture_file.h"
#include "sim/config/parameters.h"
#include "traces/scene_library.h"

namespace cuesta {
namespace {

using Rows = std::vector<std::vector<std::string>>;

/// Columns as wide as their widest cell, two spaces between; the last one is not filled up.
void print_rows(const Rows& rows) {
  std::vector<size_t> widths(rows[0].size());
  for (const auto& row : rows) {
    for (size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  for (const auto& row : rows) {
    std::string line;
    for (size_t k = 0; k < row.size(); ++k) {
      line += row[k];
      if (k + 1 < row.size()) line.append(widths[k] - row[k].size() + 2, ' ');
    }
    std::printf("%s\n", line.c_str());
  }
}

void add_algorithm_rows(std::span<const Algorithm> algorithms, Rows& rows) {
  for (const Algorithm& a : algorithms) {
    const bool leaf = a.schedule.start == StartRule::kLeaf;
    rows.push_back({a.id, std::string(name_of(a.schedule.start)),
                    leaf ? "-" : std::string(name_of_down(a.schedule.down)),
                    std::string(name_of(a.schedule.up)), a.source, a.meaning});
  }
}

/// The approximate ones, and how their parameters are given.
void list_searches() {
  std::printf(
      "\nApproximate (`searches`; `all+parts+searches+printed` are all): they may miss or misplace a hit, "
      "and a run "
      "counts "
      "how "
      "often.\n");
  Rows rows = {{"id", "steps", "least", "refine", "source", "meaning"}};
  const auto number = [](int value) { return value > 0 ? std::to_string(value) : std::string("-"); };
  for (const SearchRow& row : search_rows()) {
    if (is_printed(row.search.kind)) continue;
    rows.push_back({std::string(row.id), number(row.search.steps), number(row.search.least_steps),
                    number(row.search.refinements), std::string(row.source), std::string(row.meaning)});
  }
  print_rows(rows);
  std::printf(
      "\nAs printed (`printed`): algorithms on the pyramid with the faults of their listings, in float, on "
      "square "
      "powers of two that wrap.\n");
  rows = {{"id", "most steps", "delta", "source", "meaning"}};
  for (const SearchRow& row : search_rows()) {
    if (!is_printed(row.search.kind)) continue;
    char delta[32];
    std::snprintf(delta, sizeof delta, "%g texels", row.search.delta / 1000.0);
    rows.push_back({std::string(row.id), number(row.search.steps), delta, std::string(row.source),
                    std::string(row.meaning)});
  }
  print_rows(rows);
  std::printf(
      "\nWith other parameters: %s.\nExamples: relief:steps=64:refine=5, cone:bilinear, "
      "ki2007-printed:delta=0.005:slope.\n",
      std::string(kSearchSyntax).c_str());
}

void list_algorithms() {
  Rows rows = {{"id", "start", "down", "up", "source", "meaning"}};
  add_algorithm_rows(algorithms(), rows);
  print_rows(rows);
  std::printf(
      "\nParts of yun2013 and yun2013-coherent, each alone (`parts`; `all+parts` are these and the "
      "above):\n");
  rows = {{"id", "start", "down", "up", "source", "meaning"}};
  add_algorithm_rows(algorithm_parts(), rows);
  print_rows(rows);
  std::printf("\nA schedule of your own, wherever an algorithm is accepted: %s.\n",
              std::string(kScheduleSyntax).c_str());
  const std::string stop = "stop=0 to stop=" + std::to_string(kMostStopLevel);
  rows = {
      {"choice", "accepted", "meaning"},
      {"START", joined(kStartNames),
       "the root; the leaves (the stop level); the smallest node that holds the ray's start and end cell"},
      {"DOWN", joined(kDownNames),
       "levels per descent until the first crossing, then 1; common: to the smallest node that holds the "
       "ray's "
       "cell and its end cell"},
      {"UP", joined(kUpNames), "when a ray that has crossed goes up one level"},
      {"stop=N", stop, "level of the leaves; above 0 they are the texels of the mean pyramid"},
      {"quad", joined(kFetchNames), "a visit fetches its texel, or its 2 x 2 siblings, which the ray keeps"}};
  print_rows(rows);
  std::printf("Examples: root:common:never, span:2:even-axis:stop=2, yun2013:quad.\n");
  list_searches();
}

void list_scenes() {
  Rows rows = {{"name", "description"}};
  for (const BuiltInScene& scene : built_in_scenes()) {
    rows.push_back({std::string(scene.name), find_scene(std::string(scene.name)).description});
  }
  print_rows(rows);
}

/// The first line of a preset's text, a comment, is its description.
void list_architectures() {
  Rows rows = {{"name", "description"}};
  for (const Preset& preset : presets()) {
    const std::string_view line = preset.toml.substr(0, preset.toml.find('\n'));
    rows.push_back({std::string(preset.name), std::string(line.substr(std::min<size_t>(2, line.size())))});
  }
  print_rows(rows);
}

void list_effects() { std::printf("None yet: every scene is traversed for its first hit alone.\n"); }

void list_parameters() {
  const Architecture standard;
  for (const Parameter& p : parameters()) {
    std::printf("%s\n    %s\n", std::string(p.path).c_str(), std::string(p.meaning).c_str());
    const std::string unit = p.unit.empty() ? "" : " " + std::string(p.unit);
    std::printf("    default %s%s; accepted is %s; source: %s\n", p.text(p.get(standard)).c_str(),
                unit.c_str(), p.accepted().c_str(), std::string(p.source).c_str());
    if (!p.inert.empty()) std::printf("    inert: %s\n", std::string(p.inert).c_str());
  }
}

void list_statistics() {
  const auto print = [](std::string_view name, std::string_view unit, std::string_view sentence) {
    std::printf("%s [%s]\n    %s\n", std::string(name).c_str(), std::string(unit).c_str(),
                std::string(sentence).c_str());
  };
  for (const StatisticDefinition& s : statistic_definitions()) print(s.name, s.unit, s.sentence);
  for (const DerivedQuantity& q : derived_quantities()) print(q.name, q.unit, q.sentence);
  for (const RatioDefinition& r : ratio_definitions()) print(r.name, r.unit, r.sentence);
}

struct Topic {
  std::string_view name;
  void (*print)();
};

constexpr Topic kTopics[] = {{"algorithms", list_algorithms},       {"scenes", list_scenes},
                             {"architectures", list_architectures}, {"effects", list_effects},
                             {"parameters", list_parameters},       {"statistics", list_statistics}};

class ListCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("what", what_, "algorithms, scenes, architectures, effects, parameters or statistics")
        .required();
  }

  ExitCode run(const Session&) override {
    std::vector<std::string_view> names;
    for (const Topic& topic : kTopics) {
      names.push_back(topic.name);
      if (topic.name != what_) continue;
      topic.print();
      return ExitCode::kOk;
    }
    const std::string near = did_you_mean(what_, names);
    throw usage_error("There is no list of `" + printable(what_) + "`; accepted are " + joined(names) +
                      (near.empty() ? "." : near));
  }

 private:
  std::string what_;
};

}  // namespace

std::unique_ptr<Command> make_list_command() { return make_command<ListCommand>(); }

}  // namespace cuesta
