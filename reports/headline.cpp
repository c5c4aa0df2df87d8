#include "reports/headline.h"

#include <fmt/format.h>

#include <vector>

#include "reports/numbers.h"
#include "reports/quantities.h"

namespace cuesta {
namespace {

std::optional<double> number(const RunEntry& run, std::string_view name) {
  const auto found = ratio(run, name);
  return found ? found : quantity(run, name);
}

std::string about_one_run(const Result& result, const RunEntry& run) {
  std::string text = fmt::format("{} traced {} rays", label_of(result, run), grouped(static_cast<int64_t>(run.finished_rays)));
  if (run.partial()) text += fmt::format(" of {} (partial)", grouped(static_cast<int64_t>(run.all_rays)));
  text += " on " + run.scene;
  if (const auto cycles = quantity(run, "machine.cycles")) text += " in " + grouped(static_cast<int64_t>(*cycles)) + " cycles";
  std::vector<std::string> parts;
  if (const auto steps = ratio(run, "steps_per_ray")) parts.push_back(significant(*steps) + " steps per ray");
  if (const auto cycles = ratio(run, "cycles_per_ray")) parts.push_back(significant(*cycles) + " cycles per ray");
  if (const auto hits = ratio(run, "l1_hit_rate")) parts.push_back("L1 hit rate " + readable(*hits, "fraction"));
  for (size_t k = 0; k < parts.size(); ++k) text += (k == 0 ? ": " : ", ") + parts[k];
  return text + ".";
}

struct Best {
  const RunEntry* run = nullptr;
  size_t compared = 0;
};

Best fewest(const Result& result, const RunGroup& group, std::string_view name) {
  Best best;
  double least = 0;
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    const auto value = number(run, name);
    if (!value || run.partial()) continue;
    ++best.compared;
    if (best.run == nullptr || *value < least) {
      best.run = &run;
      least = *value;
    }
  }
  return best;
}

std::string about_scene(const Result& result, const RunGroup& group) {
  const bool timed = fewest(result, group, "machine.cycles").compared == fewest(result, group, "steps_per_ray").compared;
  const std::string_view name = timed ? "machine.cycles" : "steps_per_ray";
  const Best best = fewest(result, group, name);
  if (best.run == nullptr) return fmt::format("No run on {} is complete.", group.scene);
  const double value = *number(*best.run, name);
  const std::string what = timed ? grouped(static_cast<int64_t>(value)) + " cycles" : significant(value) + " steps per ray";
  std::string text = fmt::format("{} needed the fewest {} on {}: {}", label_of(result, *best.run),
                                 timed ? "cycles" : "steps", group.scene, what);
  const RunEntry* baseline = baseline_of(result, *best.run);
  const auto change = against_baseline(result, *best.run, name);
  if (baseline != nullptr && change) {
    text += fmt::format(", {} % fewer than {}", significant(-*change * 100), label_of(result, *baseline));
    const auto steps = against_baseline(result, *best.run, "steps_per_ray");
    if (timed && steps) text += fmt::format(", with {} % {} steps", significant(std::abs(*steps) * 100), *steps < 0 ? "fewer" : "more");
  } else if (baseline == best.run) {
    text += fmt::format(", the fewest of {}", best.compared);
  }
  return text + ".";
}

}  // namespace

std::optional<double> against_baseline(const Result& result, const RunEntry& run, std::string_view name) {
  const RunEntry* baseline = baseline_of(result, run);
  if (baseline == nullptr || baseline == &run || run.partial() || baseline->partial()) return std::nullopt;
  const auto value = number(run, name);
  const auto other = number(*baseline, name);
  if (!value || !other || *other == 0) return std::nullopt;
  return *value / *other - 1;
}

std::string headline(const Result& result) {
  std::string text;
  std::vector<std::string> unfinished;
  for (const RunGroup& group : group_by_scene(result)) {
    if (!text.empty()) text += " ";
    text += group.runs.size() == 1 ? about_one_run(result, result.runs[group.runs.front()]) : about_scene(result, group);
    if (group.runs.size() == 1) continue;
    for (size_t index : group.runs) {
      const RunEntry& run = result.runs[index];
      if (run.partial()) {
        unfinished.push_back(fmt::format("{} is partial ({} of {} rays) and not compared.", label_of(result, run),
                                         grouped(static_cast<int64_t>(run.finished_rays)),
                                         grouped(static_cast<int64_t>(run.all_rays))));
      }
    }
  }
  for (const std::string& sentence : unfinished) text += " " + sentence;
  return text;
}

}  // namespace cuesta
