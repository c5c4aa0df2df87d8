#include <algorithm>
#include <cstdio>
#include <optional>

#include "models/files/image_codec.h"
#include "sim/cli/cycle_host.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/result_output.h"
#include "sim/cli/run_options.h"
#include "sim/cli/verbs.h"
#include "sim/config/on_architecture.h"
#include "sim/session/measure.h"

namespace cuesta {
namespace {

class CompareCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("scenes", scenes_,
                "Scene files, or names of built-in scenes; `default` with --heightmap alone");
    options.add(
        "--algorithm", algorithms_,
        "Several, joined by commas: names out of `cuesta list algorithms`, schedules such as "
        "root:common:never:quad, all (default: every exact one), parts, searches, printed, all+searches");
    options.add("--arch", architectures_, "Presets or architecture files, joined by commas; default: mobile");
    options_.declare(options);
  }

  ExitCode run(const Session& session) override {
    const auto start = std::chrono::steady_clock::now();
    const Fidelity fidelity = parse_fidelity(options_.fidelity);
    const Host host = parse_host(options_.host, fidelity);
    const auto algorithms = parse_algorithms(algorithms_);
    if (architectures_.empty()) architectures_.push_back("mobile");
    const auto machines = parse_architectures(architectures_, options_.settings, fidelity);
    check_searches(algorithms, machines, host);
    if (scenes_.empty()) scenes_.push_back(scene_or_default("", options_));
    if (scenes_.size() > 1 && !options_.heightmap.empty()) {
      throw usage_error("--heightmap takes the place of one scene's heights, and " +
                        std::to_string(scenes_.size()) + " scenes are given; accepted is one.");
    }
    const SceneChanges changes = scene_changes(options_);
    for (const std::string& scene : scenes_) {
      for (const ResolvedArchitecture& machine : machines) {
        for (const Algorithm& algorithm : algorithms)
          check_surface(changed_scene(scene, changes), algorithm, machine.architecture);
      }
    }
    Result result = begin_result("compare", session);
    result.manifest.environment.emplace_back("simulation_host", options_.host);
    const CycleRunner cycle_runner = make_cycle_runner(session, host, "", {}, machines);
    add_inputs(machines, result);

    for (const ResolvedArchitecture& machine : machines) {
      const size_t runs = distinct_on(machine.architecture, algorithms).size();
      if (runs == algorithms.size() || session.quiet) continue;
      std::fprintf(stderr,
                   "On %s, whose [traverse] section sets parts of the schedule, %zu algorithms are %zu "
                   "different schedules: each is run once.\n",
                   machine.architecture.name.c_str(), algorithms.size(), runs);
    }

    // Every scene file is read and the folder is made before the work, so that a fault shows at once.
    const std::vector<std::string> names = scene_names(changes);
    const std::string stem = names.size() == 1 ? names[0] : std::to_string(names.size()) + "-scenes";
    image_codec();  // for the planes: what cannot be loaded is found before the work
    ResultFolder folder = open_result_folder(options_, stem + "-compare");
    std::optional<Error> failure;
    for (const std::string& scene : scenes_) {
      if (stop_requested()) break;
      try {
        const Job job = prepare_job(scene, changes, watched(session, "making rays", 0));
        add_inputs(job, result);
        remark_inputs(session, job, machines);
        measure_all(session, job, algorithms, machines, fidelity, cycle_runner, result);
      } catch (const Error& error) {
        if (result.runs.empty()) throw;
        failure = error;
        break;
      }
    }
    size_t planned = 0;
    for (const ResolvedArchitecture& machine : machines) {
      planned += scenes_.size() * distinct_on(machine.architecture, algorithms).size();
    }
    if (failure) result.manifest.environment.emplace_back("failed", failure->what());
    const ExitCode code = finish_result(result, planned, machines, fidelity, folder, options_, start);
    if (failure) throw *failure;  // after what was measured before it is safe
    return code;
  }

 private:
  std::vector<std::string> scene_names(const SceneChanges& changes) const {
    std::vector<std::string> names;
    for (const std::string& scene : scenes_) {
      const std::string name = changed_scene(scene, changes).name;
      if (std::find(names.begin(), names.end(), name) != names.end()) {
        throw usage_error("Two scenes are named " + name + "; accepted are different names.");
      }
      names.push_back(name);
    }
    return names;
  }

  static void measure_all(const Session& session, const Job& job, const std::vector<Algorithm>& algorithms,
                          const std::vector<ResolvedArchitecture>& machines, Fidelity fidelity,
                          const CycleRunner& cycle_runner, Result& result) {
    Measurer measurer(job, cycle_runner);
    for (const ResolvedArchitecture& machine : machines) {
      for (const Algorithm& algorithm : algorithms) measurer.check(algorithm, machine.architecture);
    }
    for (const ResolvedArchitecture& machine : machines) {
      for (const Algorithm& algorithm : distinct_on(machine.architecture, algorithms)) {
        if (stop_requested()) return;
        std::string label(algorithm.id);
        if (machines.size() > 1) label += " on " + machine.architecture.name;
        ProgressBar bar(session, label, "rays", job.trace.rays.size());
        result.runs.push_back(
            measurer.run(algorithm, machine.architecture, fidelity,
                         [&](uint64_t finished, uint64_t) { return bar.update(finished); }));
      }
    }
    add_preprocessing(session, measurer, result);
  }

  std::vector<std::string> scenes_, algorithms_, architectures_;
  RunOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_compare_command() { return make_command<CompareCommand>(); }

}  // namespace cuesta
