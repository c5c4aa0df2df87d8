#include <algorithm>
#include <chrono>

#include "sim/cli/names.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/result_output.h"
#include "sim/cli/run_options.h"
#include "sim/cli/verbs.h"
#include "sim/cli/wave_options.h"
#include "sim/session/hosts.h"
#include "sim/session/manifest.h"
#include "sim/session/measure_scenes.h"

namespace cuesta {
namespace {

/// "root:2:never:stop=1" without what shells and other systems read otherwise.
std::string folder_name(std::string id) {
  std::erase(id, '=');
  std::replace(id.begin(), id.end(), ':', '-');
  return id;
}

class RunCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("scene", scene_,
                "Scene file, or the name of a built-in scene; `default` with --heightmap alone");
    options
        .add("--algorithm", algorithm_,
             "One out of `cuesta list algorithms`, or a schedule such as root:common:never:quad")
        .with_default();
    options.add("--arch", architecture_, "Preset or architecture file").with_default();
    options.add("--vcd", vcd_, "With --host systemc: the machine's signals into a VCD file; slow");
    waves_.declare(options);
    options_.declare(options);
  }

  ExitCode run(const Session& session) override {
    const auto start = std::chrono::steady_clock::now();
    RunRequest wanted;
    wanted.fidelity = parse_fidelity(options_.fidelity);
    HostRequest request;
    request.waves = waves_.request();
    const Host& host = find_host(options_.host);
    host.check_fidelity(wanted.fidelity);
    if (request.waves.wanted() && !runs_every_cycle(wanted.fidelity)) {
      throw usage_error("--waves shows the hardware cycle by cycle, and --fidelity " + options_.fidelity +
                        " has none; accepted with it are --fidelity cycle, rtl.");
    }
    wanted.algorithms = parse_algorithms({algorithm_});
    wanted.machines = parse_architectures({architecture_}, options_.settings, wanted.fidelity);
    if (wanted.algorithms.size() != 1 || wanted.machines.size() != 1) {
      throw usage_error(
          "`cuesta run` takes one algorithm and one architecture; `cuesta compare` takes several.");
    }
    for (const Algorithm& algorithm : wanted.algorithms) host.check_algorithm(algorithm);
    check_searches(wanted.algorithms, wanted.machines);
    request.vcd = vcd_;
    request.pipelines = most_pipelines(wanted.machines);
    request.warnings = !session.quiet;
    TerminalObserver observer(session);
    const CycleRunner cycle_runner = host.make(request, observer);
    wanted.scenes = {scene_or_default(scene_, options_)};
    wanted.changes = scene_changes(options_);
    check_surfaces(wanted);

    Result result = begin_result("run", session.command_line);
    result.manifest.environment.emplace_back("simulation_host", options_.host);
    ResultFolder folder =
        open_folder(options_, scene_names(wanted)[0] + "-" + folder_name(wanted.algorithms[0].id));
    measure_scenes(wanted, cycle_runner, observer, result);
    add_inputs(wanted.machines, result);
    const Completion done = finish_result(wanted, start, result, folder);
    return print_result(result, done, folder, options_.json);
  }

 private:
  std::string scene_;
  std::string algorithm_ = "yun2013";
  std::string architecture_ = "mobile";
  std::string vcd_;
  WaveOptions waves_;
  RunOptions options_;
};

}  // namespace

std::unique_ptr<Command> make_run_command() { return make_command<RunCommand>(); }

}  // namespace cuesta
