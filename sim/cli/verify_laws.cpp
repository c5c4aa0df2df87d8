#include <cstdio>

#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/run_options.h"
#include "sim/cli/verbs.h"
#include "sim/config/architecture_file.h"
#include "sim/session/measure.h"
#include "traces/scene_library.h"

namespace cuesta {
namespace {

/// Every run checks its own laws; here many small runs do, and both fidelities must find the same hits and steps.
class VerifyLawsCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("--size", size_, "Pixels on a side of each scene's frame: 1 to 1024").with_default();
    options.add("--scene", scenes_, "Only these scenes, joined by commas; default: all built-in ones");
    options.add("--arch", machines_, "Only these machines, joined by commas; default: all presets");
  }

  ExitCode run(const Session& session) override {
    if (size_ < 1 || size_ > 1024) {
      throw usage_error("--size is " + std::to_string(size_) +
                        "; accepted is a whole number from 1 to 1024.");
    }
    std::vector<std::string> scenes = split_at_commas(scenes_, "--scene"),
                             machines = split_at_commas(machines_, "--arch");
    if (scenes.empty()) {
      for (const BuiltInScene& scene : built_in_scenes()) scenes.emplace_back(scene.name);
    }
    if (machines.empty()) {
      for (const Preset& preset : presets()) machines.emplace_back(preset.name);
    }
    const auto resolved = parse_architectures(machines, {}, Fidelity::kCycle);

    const uint64_t planned = scenes.size() * resolved.size() * algorithms().size() * 3;
    uint64_t runs = 0, rays = 0;
    {
      ProgressBar bar(session, "laws", "runs", planned);
      for (const std::string& scene : scenes) {
        SceneChanges changes;
        const Scene wanted = changed_scene(scene, changes);
        if (wanted.rays_file.empty() && wanted.ray_set.kind.empty()) changes.size = {size_, size_};
        const Job job = prepare_job(scene, changes);
        Measurer measurer(job);
        for (const ResolvedArchitecture& machine : resolved) {
          for (const Algorithm& algorithm : algorithms()) {
            if (!bar.update(runs)) return stopped(runs, planned);
            const RunEntry plain = measurer.run(algorithm, machine.architecture, Fidelity::kFunctional);
            const RunEntry timed = measurer.run(algorithm, machine.architecture, Fidelity::kCycle);
            const RunEntry loose = measurer.run(algorithm, machine.architecture, Fidelity::kTransaction);
            if (plain.hits_digest != timed.hits_digest || plain.hits_digest != loose.hits_digest) {
              throw Error(ExitCode::kMismatch,
                          "functional, transaction and cycle fidelity differ in hits or steps: " +
                              plain.algorithm + " on " + plain.architecture + ", scene " + plain.scene + ".");
            }
            runs += 3;
            rays += plain.all_rays + timed.all_rays + loose.all_rays;
          }
        }
      }
    }
    std::printf(
        "%llu runs over %llu rays (%zu scenes, %zu machines, %zu algorithms, functional, transaction and "
        "cycle): 0 broken "
        "laws, "
        "0 different hits.\n",
        static_cast<unsigned long long>(runs), static_cast<unsigned long long>(rays), scenes.size(),
        resolved.size(), algorithms().size());
    return ExitCode::kOk;
  }

 private:
  static ExitCode stopped(uint64_t runs, uint64_t planned) {
    std::printf("Stopped: %llu of %llu runs, 0 broken laws among them.\n",
                static_cast<unsigned long long>(runs), static_cast<unsigned long long>(planned));
    return ExitCode::kIncomplete;
  }

  int size_ = 64;
  std::vector<std::string> scenes_, machines_;
};

}  // namespace

std::unique_ptr<Command> make_verify_laws_command() { return make_command<VerifyLawsCommand>(); }

}  // namespace cuesta
