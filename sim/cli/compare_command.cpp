#include <chrono>
#include <optional>

#include "sim/cli/names.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/result_output.h"
#include "sim/cli/run_options.h"
#include "sim/cli/verbs.h"
#include "sim/session/hosts.h"
#include "sim/session/manifest.h"
#include "sim/session/measure_scenes.h"

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
    RunRequest wanted;
    wanted.fidelity = parse_fidelity(options_.fidelity);
    const Host& host = find_host(options_.host);
    host.check_fidelity(wanted.fidelity);
    wanted.algorithms = parse_algorithms(algorithms_);
    if (architectures_.empty()) architectures_.push_back("mobile");
    wanted.machines = parse_architectures(architectures_, options_.settings, wanted.fidelity);
    for (const Algorithm& algorithm : wanted.algorithms) host.check_algorithm(algorithm);
    check_searches(wanted.algorithms, wanted.machines);
    if (scenes_.empty()) scenes_.push_back(scene_or_default("", options_));
    if (scenes_.size() > 1 && !options_.heightmap.empty()) {
      throw usage_error("--heightmap takes the place of one scene's heights, and " +
                        std::to_string(scenes_.size()) + " scenes are given; accepted is one.");
    }
    wanted.scenes = scenes_;
    wanted.changes = scene_changes(options_);
    check_surfaces(wanted);

    Result result = begin_result("compare", session.command_line);
    result.manifest.environment.emplace_back("simulation_host", options_.host);
    TerminalObserver observer(session);
    HostRequest request;
    request.pipelines = most_pipelines(wanted.machines);
    request.warnings = !session.quiet;
    const CycleRunner cycle_runner = host.make(request, observer);
    add_inputs(wanted.machines, result);
    remark_same_schedules(wanted, observer);
    // Every scene file is read and the folder is made before the work, so that a fault shows at once.
    const std::vector<std::string> names = scene_names(wanted);
    const std::string stem = names.size() == 1 ? names[0] : std::to_string(names.size()) + "-scenes";
    ResultFolder folder = open_folder(options_, stem + "-compare");

    const std::optional<Error> failure = measure_scenes(wanted, cycle_runner, observer, result);
    if (failure) result.manifest.environment.emplace_back("failed", failure->what());
    const Completion done = finish_result(wanted, start, result, folder);
    const ExitCode code = print_result(result, done, folder, options_.json);
    if (failure) throw *failure;  // after what was measured before it is safe
    return code;
  }

 private:
  std::vector<std::string> scenes_, algorithms_, architectures_;
  RunOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_compare_command() { return make_command<CompareCommand>(); }

}  // namespace cuesta
