#include "sim/session/measure_scenes.h"

#include <algorithm>
#include <cstdio>

#include "models/common/words.h"
#include "sim/config/on_architecture.h"
#include "sim/session/manifest.h"

namespace cuesta {
namespace {

constexpr double kLongPreprocessing = 1;  ///< seconds from which on a remark says so

void remark_scene(const Job& job, const std::vector<ResolvedArchitecture>& machines, Observer& observer) {
  observer.on_remark("Scene " + job.scene.name + ": " + std::to_string(job.trace.rays.size()) + " rays, " +
                     std::to_string(job.trace.width) + " x " + std::to_string(job.trace.height) +
                     " pixels; heights: " + job.heights_statement + ".");
  for (const ResolvedArchitecture& machine : machines) {
    if (machine.unused.empty()) continue;
    const std::vector<std::string_view> unused(machine.unused.begin(), machine.unused.end());
    observer.on_remark("Architecture " + machine.architecture.name +
                       ": not used by this run: " + joined(unused) + ".");
  }
}

/// Writes into the manifest how long the maps took that searches read, and remarks it where it was long.
void add_preprocessing(const Measurer& measurer, Observer& observer, Result& result) {
  for (const Measurer::Preprocessing& one : measurer.preprocessing()) {
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.3f", one.seconds);
    result.manifest.environment.emplace_back("preprocessing_seconds." + one.what, seconds);
    if (one.seconds < kLongPreprocessing) continue;
    observer.on_remark("The map that " + one.what + " reads took " + seconds + " s to make.");
  }
}

void measure_job(const RunRequest& wanted, const Job& job, const CycleRunner& cycle_runner,
                 Observer& observer, Result& result) {
  Measurer measurer(job, cycle_runner);
  for (const ResolvedArchitecture& machine : wanted.machines) {
    for (const Algorithm& algorithm : wanted.algorithms) measurer.check(algorithm, machine.architecture);
  }
  for (const ResolvedArchitecture& machine : wanted.machines) {
    for (const Algorithm& algorithm : distinct_on(machine.architecture, wanted.algorithms)) {
      if (observer.wants_stop()) return;
      std::string label(algorithm.id);
      if (wanted.machines.size() > 1) label += " on " + machine.architecture.name;
      Stage stage(observer, label, "rays", job.trace.rays.size());
      result.runs.push_back(
          measurer.run(algorithm, machine.architecture, wanted.fidelity,
                       [&](uint64_t finished, uint64_t) { return stage.update(finished); }));
    }
  }
  add_preprocessing(measurer, observer, result);
}

}  // namespace

void check_surfaces(const RunRequest& wanted) {
  for (const std::string& scene : wanted.scenes) {
    for (const ResolvedArchitecture& machine : wanted.machines) {
      for (const Algorithm& algorithm : wanted.algorithms)
        check_surface(changed_scene(scene, wanted.changes), algorithm, machine.architecture);
    }
  }
}

std::vector<std::string> scene_names(const RunRequest& wanted) {
  std::vector<std::string> names;
  for (const std::string& scene : wanted.scenes) {
    const std::string name = changed_scene(scene, wanted.changes).name;
    if (std::find(names.begin(), names.end(), name) != names.end()) {
      throw usage_error("Two scenes are named " + name + "; accepted are different names.");
    }
    names.push_back(name);
  }
  return names;
}

size_t planned_runs(const RunRequest& wanted) {
  size_t planned = 0;
  for (const ResolvedArchitecture& machine : wanted.machines) {
    planned += wanted.scenes.size() * distinct_on(machine.architecture, wanted.algorithms).size();
  }
  return planned;
}

void remark_same_schedules(const RunRequest& wanted, Observer& observer) {
  for (const ResolvedArchitecture& machine : wanted.machines) {
    const size_t runs = distinct_on(machine.architecture, wanted.algorithms).size();
    if (runs == wanted.algorithms.size()) continue;
    observer.on_remark("On " + machine.architecture.name +
                       ", whose [traverse] section sets parts of the schedule, " +
                       std::to_string(wanted.algorithms.size()) + " algorithms are " + std::to_string(runs) +
                       " different schedules: each is run once.");
  }
}

std::optional<Error> measure_scenes(const RunRequest& wanted, const CycleRunner& cycle_runner,
                                    Observer& observer, Result& result) {
  for (const std::string& scene : wanted.scenes) {
    if (observer.wants_stop()) break;
    try {
      const Job job = watched_job(scene, wanted.changes, observer);
      add_inputs(job, result);
      remark_scene(job, wanted.machines, observer);
      measure_job(wanted, job, cycle_runner, observer, result);
    } catch (const Error& error) {
      if (result.runs.empty()) throw;
      return error;
    }
  }
  return std::nullopt;
}

}  // namespace cuesta
