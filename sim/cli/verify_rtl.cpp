#include <fmt/core.h>

#include <array>
#include <optional>

#include "sim/cli/names.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"
#include "sim/cli/verify_rtl_options.h"
#include "sim/session/result_files.h"
#include "sim/verify/lockstep/campaign.h"
#include "sim/verify/lockstep/case_files.h"
#include "sim/verify/lockstep/leave_difference.h"
#include "sim/verify/lockstep/own_case.h"

namespace cuesta {
namespace {

/// The model and the Verilated hardware side by side: on random machines over all compiled sets, or on a user's own
/// rays and machine.
class VerifyRtlCommand : public Command {
 public:
  void declare(Options& options) override { options_.declare(options); }

  ExitCode run(const Session& session) override {
    unit_ = parse_hardware_unit(options_.unit);
    sides_ = rtl_sides(unit_);
    options_.refuse_unused();
    std::optional<ResultFolder> folder;
    if (!options_.run.folder.empty()) {  // known before the work
      options_.refuse_existing_folder();
      folder.emplace(open_result_folder(options_.run.folder, "", false));
    }
    TerminalObserver observer(session);
    const LockstepReport report = options_.own() ? compare_own(observer) : compare_random(observer);
    if (report.differs()) fail(report, observer, folder);
    if (report.failing) refuse_standstill(*report.last.stuck);
    fmt::print("verify rtl: {} rays, {} cycles, {} memory requests, 0 differences{}\n", report.rays,
               report.cycles, report.requests, report.stopped ? "; stopped before the end" : "");
    return report.stopped ? ExitCode::kIncomplete : ExitCode::kOk;
  }

 private:
  LockstepReport compare_own(Observer& observer) const {
    const auto algorithms = parse_algorithms({options_.algorithm});
    const auto machines =
        parse_architectures({options_.architecture}, options_.run.settings, Fidelity::kCycle);
    if (algorithms.size() != 1 || machines.size() != 1)
      throw usage_error("`cuesta verify rtl` takes one algorithm and one architecture.");
    check_hardware_algorithm(algorithms[0]);
    LockstepMachine machine;
    machine.architecture = machines[0].architecture;
    if (!options_.stalls.empty()) machine.stalls = parse_stalls(options_.stalls, "--stalls");
    check_hardware_stalls(machine.stalls, unit_, "--stalls " + options_.stalls);
    machine.register_seed = options_.register_seed;
    if (!options_.memory.empty()) machine.memory = parse_memory_timing(options_.memory, "--memory");
    Job job = watched_job(options_.scene.empty() ? "default" : options_.scene, scene_changes(options_.run),
                          observer);
    return compare_case(own_case(std::move(job), algorithms[0], machine), sides_, observer);
  }

  LockstepReport compare_random(Observer& observer) const {
    LockstepCampaign campaign;
    campaign.sets = compiled_sets(split_at_commas(options_.sets, "--sets"));
    campaign.unit = unit_;
    campaign.seed = options_.seed;
    campaign.workers = options_.workers;
    campaign.seconds = options_.seconds;
    if (options_.count_option.count() > 0) campaign.ray_count = options_.ray_count;
    LockstepReport report = run_campaign(campaign, sides_, observer);
    if (report.failing) return report;
    fmt::print("{} machines over {} compiled set{}; ", report.machines, campaign.sets.size(),
               campaign.sets.size() == 1 ? "" : "s");
    return report;
  }

  [[noreturn]] static void refuse_standstill(const Error& stuck) {
    throw Error(stuck.code(), "verify rtl: no difference, but model and RTL alike stand still: " +
                                  std::string(stuck.what()) +
                                  (std::string_view(stuck.what()).ends_with(".") ? "" : "."));
  }

  /// Prints the difference, makes the case smaller and leaves it as files.
  [[noreturn]] void fail(const LockstepReport& report, Observer& observer,
                         std::optional<ResultFolder>& folder) const {
    fmt::print("{}", first_difference(report.last, sides_));
    const SmallestDifference smallest = shrink_difference(report, sides_, observer);
    if (!folder) folder.emplace(open_result_folder("", "verify-rtl", false));
    fmt::print("{}", leave_difference(report, smallest, sides_, unit_, *folder));
    fmt::print("files, and waves around the difference: {}\n", folder->final_path().string());
    const Difference& first = report.last.differences[0];
    throw Error(
        ExitCode::kMismatch,
        fmt::format(
            "verify rtl: {} rays, {} cycles, 1 difference: cycle {}, {}.{}, seed {}; it is decoded above.",
            report.rays, report.cycles, first.cycle, first.unit, first.field, report.failing->seed));
  }

  VerifyRtlOptions options_;
  HardwareUnit unit_ = HardwareUnit::kHmtTop;
  std::array<LockstepSide, 2> sides_;
};

}  // namespace

std::unique_ptr<Command> make_verify_rtl_command() { return make_command<VerifyRtlCommand>(); }

}  // namespace cuesta
