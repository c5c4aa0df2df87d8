#include <algorithm>
#include <cstdio>

#include "models/files/image_codec.h"
#include "sim/cli/cycle_host.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/result_output.h"
#include "sim/cli/run_options.h"
#include "sim/cli/verbs.h"
#include "sim/session/measure.h"

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
    const Fidelity fidelity = parse_fidelity(options_.fidelity);
    waves_.check();
    const Host host = parse_host(options_.host, fidelity);
    if (waves_.wanted() && (fidelity == Fidelity::kFunctional || fidelity == Fidelity::kTransaction)) {
      throw usage_error("--waves shows the hardware cycle by cycle, and --fidelity " + options_.fidelity +
                        " has none; accepted with it are --fidelity cycle, rtl.");
    }
    const auto algorithms = parse_algorithms({algorithm_});
    const auto machines = parse_architectures({architecture_}, options_.settings, fidelity);
    if (algorithms.size() != 1 || machines.size() != 1) {
      throw usage_error(
          "`cuesta run` takes one algorithm and one architecture; `cuesta compare` takes several.");
    }
    check_searches(algorithms, machines, host);
    const CycleRunner cycle_runner = make_cycle_runner(session, host, vcd_, waves_, machines);
    const std::string scene = scene_or_default(scene_, options_);
    const SceneChanges changes = scene_changes(options_);
    check_surface(changed_scene(scene, changes), algorithms[0], machines[0].architecture);
    Result result = begin_result("run", session);
    result.manifest.environment.emplace_back("simulation_host", options_.host);
    image_codec();  // for the planes: what cannot be loaded is found before the work
    ResultFolder folder = open_result_folder(
        options_, changed_scene(scene, changes).name + "-" + folder_name(algorithms[0].id));
    const Job job = prepare_job(scene, changes, watched(session, "making rays", 0));
    add_inputs(job, result);
    add_inputs(machines, result);
    remark_inputs(session, job, machines);

    Measurer measurer(job, cycle_runner);
    {
      ProgressBar bar(session, algorithms[0].id, "rays", job.trace.rays.size());
      result.runs.push_back(measurer.run(algorithms[0], machines[0].architecture, fidelity,
                                         [&](uint64_t finished, uint64_t) { return bar.update(finished); }));
    }
    add_preprocessing(session, measurer, result);
    return finish_result(result, 1, machines, fidelity, folder, options_, start);
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
