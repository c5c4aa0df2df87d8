#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "models/common/words.h"
#include "models/units/statistics.h"
#include "reports/quantities.h"
#include "sim/cli/list_algorithms.h"
#include "sim/cli/options.h"
#include "sim/cli/verbs.h"
#include "sim/config/architecture_file.h"
#include "sim/config/parameters.h"
#include "traces/scene_library.h"

namespace cuesta {
namespace {

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
