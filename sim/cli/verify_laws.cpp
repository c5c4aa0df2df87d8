#include <cstdio>

#include "models/algorithms/schedule.h"
#include "sim/cli/names.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"
#include "sim/verify/laws/laws_check.h"
#include "traces/scene_library.h"

namespace cuesta {
namespace {

/// Every run checks its own laws; here many small runs do, and all fidelities must find the same hits and steps.
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
    LawsRequest request;
    request.size = size_;
    request.scenes = split_at_commas(scenes_, "--scene");
    std::vector<std::string> machines = split_at_commas(machines_, "--arch");
    if (request.scenes.empty()) {
      for (const BuiltInScene& scene : built_in_scenes()) request.scenes.emplace_back(scene.name);
    }
    if (machines.empty()) {
      for (const Preset& preset : presets()) machines.emplace_back(preset.name);
    }
    request.machines = resolve_machines(machines, {}, Fidelity::kCycle);

    TerminalObserver observer(session);
    const LawsCounts counts = check_laws(request, observer);
    using Number = unsigned long long;
    if (counts.stopped) {
      std::printf("Stopped: %llu of %llu runs, 0 broken laws among them.\n", static_cast<Number>(counts.runs),
                  static_cast<Number>(counts.planned));
      return ExitCode::kIncomplete;
    }
    std::printf(
        "%llu runs over %llu rays (%zu scenes, %zu machines, %zu algorithms, functional, transaction and "
        "cycle): 0 broken laws, 0 different hits.\n",
        static_cast<Number>(counts.runs), static_cast<Number>(counts.rays), request.scenes.size(),
        request.machines.size(), algorithms().size());
    return ExitCode::kOk;
  }

 private:
  int size_ = 64;
  std::vector<std::string> scenes_, machines_;
};

}  // namespace

std::unique_ptr<Command> make_verify_laws_command() { return make_command<VerifyLawsCommand>(); }

}  // namespace cuesta
