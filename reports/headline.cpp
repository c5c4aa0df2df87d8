#include "reports/headline.h"

#include <fmt/format.h>

#include <algorithm>
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
  std::string text = fmt::format("{} traced {} ray{}", label_of(result, run),
                                 grouped(static_cast<int64_t>(run.finished_rays)),
                                 run.finished_rays == 1 && !run.partial() ? "" : "s");
  if (run.partial()) text += fmt::format(" of {} (partial)", grouped(static_cast<int64_t>(run.all_rays)));
  text += " on " + run.scene;
  if (const auto cycles = quantity(run, "machine.cycles"))
    text += (run.fidelity == "transaction" ? " in an estimated " : " in ") +
            grouped(static_cast<int64_t>(*cycles)) + " cycles";
  std::vector<std::string> parts;
  if (const auto steps = ratio(run, "steps_per_ray")) parts.push_back(significant(*steps) + " steps per ray");
  if (const auto cycles = ratio(run, "cycles_per_ray"))
    parts.push_back(significant(*cycles) + " cycles per ray");
  if (const auto hits = ratio(run, "l1_hit_rate"))
    parts.push_back("L1 hit rate " + readable(*hits, "fraction"));
  for (size_t k = 0; k < parts.size(); ++k) text += (k == 0 ? ": " : ", ") + parts[k];
  return text + ".";
}

struct Best {
  const RunEntry* run = nullptr;
  size_t compared = 0;
};

bool approximate(const RunEntry& run) { return quantity(run, "error.wrong").has_value(); }

bool all_approximate(const Result& result, const RunGroup& group) {
  return std::all_of(group.runs.begin(), group.runs.end(),
                     [&](size_t index) { return approximate(result.runs[index]); });
}

/// Whose level of detail counts: the first exact run, or the first of all.
const RunEntry& reference_run(const Result& result, const RunGroup& group) {
  for (const size_t index : group.runs) {
    if (!approximate(result.runs[index])) return result.runs[index];
  }
  return result.runs[group.runs.front()];
}

/// Of the exact runs, where there are some, on the level of detail of the reference: others see other heights.
Best fewest(const Result& result, const RunGroup& group, std::string_view name) {
  Best best;
  double least = 0;
  const bool any = all_approximate(result, group);
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    if (level_of_detail(run) != level_of_detail(reference_run(result, group))) continue;
    const auto value = number(run, name);
    if (!value || run.partial() || (!any && approximate(run))) continue;
    ++best.compared;
    if (best.run == nullptr || *value < least) {
      best.run = &run;
      least = *value;
    }
  }
  return best;
}

bool timed(const Result& result, const RunGroup& group) {
  return fewest(result, group, "machine.cycles").compared == fewest(result, group, "steps_per_ray").compared;
}

/// "1,262,580 cycles, 23.1 % fewer than oh2006 (14.9 % fewer steps)"
std::string figures(const Result& result, const Best& best, bool with_time) {
  const std::string_view name = with_time ? "machine.cycles" : "steps_per_ray";
  const double value = *number(*best.run, name);
  const std::string_view estimated = best.run->fidelity == "transaction" ? "an estimated " : "";
  std::string text = with_time ? fmt::format("{}{} cycles", estimated, grouped(static_cast<int64_t>(value)))
                               : significant(value) + " steps per ray";
  const RunEntry* baseline = baseline_of(result, *best.run);
  const auto change = against_baseline(result, *best.run, name);
  if (change) {
    const std::string other = label_of(result, *baseline);
    text += fmt::format(", {} % {} than {}", significant(std::abs(*change) * 100),
                        *change <= 0 ? "fewer" : "more", other);
    const auto steps = against_baseline(result, *best.run, "steps_per_ray");
    if (with_time && steps) {
      text += fmt::format(" ({} % {} steps)", significant(std::abs(*steps) * 100),
                          *steps <= 0 ? "fewer" : "more");
    }
  } else if (best.compared > 1) {
    text += fmt::format(", the fewest of {}", best.compared);
  }
  return text;
}

/// Wrong or without an answer, over the rays.
double astray(const RunEntry& run) {
  double share = 0;
  for (const char* name : {"wrong_rays", "nan_rays", "endless_rays"}) share += ratio(run, name).value_or(0);
  return share;
}

/// The approximate run with the fewest rays astray, beside the best exact one.
std::string about_searches(const Result& result, const RunGroup& group) {
  const RunEntry* closest = nullptr;
  size_t searches = 0;
  for (size_t index : group.runs) {
    const RunEntry& run = result.runs[index];
    if (run.partial() || !approximate(run)) continue;
    ++searches;
    if (closest == nullptr || astray(run) < astray(*closest)) closest = &run;
  }
  if (closest == nullptr) return "";
  const double wrong = ratio(*closest, "wrong_rays").value_or(0), lost = astray(*closest) - wrong;
  std::string text = searches == 1
                         ? fmt::format(" On {} {} is approximate: ", group.scene, label_of(result, *closest))
                         : fmt::format(" Of the {} approximate searches on {} {} comes closest: ", searches,
                                       group.scene, label_of(result, *closest));
  text += readable(wrong, "fraction") + " of its rays are wrong";
  if (lost > 0) text += " and " + readable(lost, "fraction") + " end without an answer";
  const std::string_view name = timed(result, group) ? "machine.cycles" : "steps_per_ray";
  const Best best = fewest(result, group, name);
  const auto value = number(*closest, name);
  if (best.run != nullptr && !approximate(*best.run) && value && *number(*best.run, name) > 0) {
    text += fmt::format(", at {} times the {} of {}", significant(*value / *number(*best.run, name)),
                        name == "machine.cycles" ? "cycles" : "steps", label_of(result, *best.run));
  }
  return text + ".";
}

/// One sentence for neighbouring scenes with the same winner.
std::string about_scenes(const Result& result, const std::vector<RunGroup>& groups) {
  std::string text, winner;
  for (const RunGroup& group : groups) {
    if (group.runs.size() == 1) {
      text += (text.empty() ? "" : ". ") + about_one_run(result, result.runs[group.runs.front()]);
      text.pop_back();  // its full stop: the loop sets them
      winner.clear();
      continue;
    }
    const bool with_time = timed(result, group);
    const Best best = fewest(result, group, with_time ? "machine.cycles" : "steps_per_ray");
    if (best.run == nullptr) {
      text += (text.empty() ? "" : ". ") + fmt::format("No run on {} is complete", group.scene);
      winner.clear();
      continue;
    }
    const std::string label = label_of(result, *best.run);
    if (label == winner) {
      text += fmt::format("; on {}: ", group.scene);
    } else {
      text += (text.empty() ? "" : ". ") + fmt::format("{} needed the fewest {} on {}: ", label,
                                                       with_time ? "cycles" : "steps", group.scene);
    }
    text += figures(result, best, with_time);
    winner = label;
  }
  return text.empty() ? "Nothing ran." : text + ".";
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
  const std::vector<RunGroup> groups = group_by_scene(result);
  std::string text = about_scenes(result, groups);
  for (const RunGroup& group : groups) {
    text += about_searches(result, group);
    const std::string_view level = level_of_detail(reference_run(result, group));
    const auto elsewhere = std::count_if(group.runs.begin(), group.runs.end(), [&](size_t index) {
      return !approximate(result.runs[index]) && level_of_detail(result.runs[index]) != level;
    });
    if (elsewhere > 0) {
      text += fmt::format(
          " On {} this is for the runs whose leaves are on level {}; {} on other levels {} other heights.",
          group.scene, level, elsewhere == 1 ? "the one" : fmt::format("the {}", elsewhere),
          elsewhere == 1 ? "sees" : "see");
    }
    for (size_t index : group.runs) {
      const RunEntry& run = result.runs[index];
      if (!run.partial() || group.runs.size() == 1) continue;
      text += fmt::format(" {} on {} is partial ({} of {} rays) and not compared.", label_of(result, run),
                          run.scene, grouped(static_cast<int64_t>(run.finished_rays)),
                          grouped(static_cast<int64_t>(run.all_rays)));
    }
  }
  return text;
}

}  // namespace cuesta
