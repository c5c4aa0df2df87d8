#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <optional>
#include <set>
#include <vector>

#include "models/common/words.h"
#include "reports/result_folder.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/result_output.h"
#include "sim/cli/run_options.h"
#include "sim/cli/verbs.h"
#include "sim/config/on_architecture.h"
#include "sim/verify/lockstep/case_files.h"
#include "sim/verify/lockstep/lockstep.h"
#include "sim/verify/lockstep/rtl_sides.h"
#include "sim/verify/lockstep/shrink.h"

namespace cuesta {
namespace {

constexpr int kMostRays = 400;  ///< of a random machine

/// The model and the Verilated hardware side by side: on random machines over all compiled sets, or on a user's own
/// rays and machine.
class VerifyRtlCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("scene", scene_,
                "Scene file or name: its rays on the machine of --arch. Without one (and without "
                "--heightmap): random machines with random rays");
    options.add("--unit", unit_, "What is hardware: hmt_top (ray_setup, traverse and height_l1) or traverse")
        .with_default();
    seconds_option_ = options.add("--seconds", seconds_, "Random machines: so long")
                          .range(int64_t{1}, int64_t{1000000})
                          .with_default();
    count_option_ =
        options
            .add("--ray-count", ray_count_, "Random machines: until so many rays, in the place of --seconds")
            .range(int64_t{1}, int64_t{1000000000000});
    seed_option_ = options.add("--seed", seed_, "Random machines: seed of the first; the next has the next")
                       .with_default();
    sets_option_ = options.add(
        "--sets", sets_, "Random machines: only of these compiled sets, joined by commas; default: all");
    workers_option_ = options
                          .add("--workers", workers_,
                               "Random machines that run at a time; what is found does not depend on it")
                          .range(1, 256)
                          .with_default();
    options.add("--rays", options_.rays_file,
                "Rays from a .rays or .csv file, over the scene's heights (default's without one)");
    options.add("--heightmap", options_.heightmap, "Heights from an image, as `cuesta run` takes them");
    algorithm_option_ = options
                            .add("--algorithm", algorithm_,
                                 "With a scene: one out of `cuesta list algorithms`, or a schedule")
                            .with_default();
    architecture_option_ =
        options.add("--arch", architecture_, "With a scene: preset or architecture file").with_default();
    options.add("--set", options_.settings,
                "With a scene: one value of the architecture: height_l1.ways=4; may be repeated");
    options.add("--size", options_.size, "With a scene: pixels: 256 or 640x480");
    options.add("--crop", options_.crop, "With a scene: only the pixels x,y,width,height of the frame");
    options.add(
        "--stalls", stalls_,
        "With a scene: SEED:p,p,p,p,p,p,p,p, chances of a stall per mille at the ports trace, "
        "dispatch, setup (with --unit traverse), memory request, memory response, hit stream, result, write");
    options.add("--memory", memory_,
                "With a scene: SEED:LEAST,MOST,GAP: rays come up to GAP cycles apart, memory answers "
                "after LEAST to MOST cycles, in any order");
    register_seed_option_ = options
                                .add("--register-seed", register_seed_,
                                     "With a scene: what registers without a reset begin with; 0: zeros")
                                .range(0, 1 << 30);
    options.add("-o,--output", options_.folder,
                "New folder for the smallest failing case; default: the next free results/verify-rtl-NNN");
  }

  ExitCode run(const Session& session) override {
    sides_ = rtl_sides(parse_hardware_unit(unit_));
    const bool own = !scene_.empty() || !options_.heightmap.empty() || !options_.rays_file.empty();
    refuse_unused(own);
    if (!options_.folder.empty()) {  // known before the work
      refuse_existing_folder();
      folder_.emplace(open_result_folder(options_, ""));
    }
    return own ? compare_own(session) : compare_random(session);
  }

 private:
  struct Totals {
    uint64_t rays = 0, cycles = 0, requests = 0, machines = 0;

    void add(const LockstepResult& result) {
      rays += result.rays;
      cycles += static_cast<uint64_t>(result.cycles);
      requests += result.requests;
      ++machines;
    }
  };

  /// Nothing here replaces an older folder, as `cuesta run` does when it is told to.
  void refuse_existing_folder() const {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::file_type type = fs::symlink_status(options_.folder, ignored).type();
    if (type == fs::file_type::none || type == fs::file_type::not_found) return;
    if (type == fs::file_type::directory && fs::is_empty(options_.folder, ignored)) return;
    throw usage_error("-o " + printable(options_.folder, 200) +
                      " exists and stays as it is; accepted is the name of a new folder or an empty one.");
  }

  /// An option that this run does not use is an error.
  void refuse_unused(bool own) const {
    const std::pair<const char*, bool> of_random[] = {{"--seconds", seconds_option_.count() > 0},
                                                      {"--ray-count", count_option_.count() > 0},
                                                      {"--seed", seed_option_.count() > 0},
                                                      {"--sets", sets_option_.count() > 0},
                                                      {"--workers", workers_option_.count() > 0}};
    const std::pair<const char*, bool> of_own[] = {{"--algorithm", algorithm_option_.count() > 0},
                                                   {"--arch", architecture_option_.count() > 0},
                                                   {"--set", !options_.settings.empty()},
                                                   {"--size", !options_.size.empty()},
                                                   {"--crop", !options_.crop.empty()},
                                                   {"--stalls", !stalls_.empty()},
                                                   {"--memory", !memory_.empty()},
                                                   {"--register-seed", register_seed_option_.count() > 0}};
    if (seconds_option_.count() > 0 && count_option_.count() > 0) {
      throw usage_error("--seconds and --ray-count both say when to stop; accepted is one of the two.");
    }
    for (const auto& [option, given] : of_random) {
      if (own && given)
        throw usage_error(std::string(option) +
                          " is about random machines, and a scene is given; accepted is one of the two.");
    }
    for (const auto& [option, given] : of_own) {
      if (!own && given)
        throw usage_error(
            std::string(option) +
            " is about a scene's rays, and no scene is given; accepted is a scene's name or file before it.");
    }
  }

  ExitCode compare_own(const Session& session) {
    const auto algorithms = parse_algorithms({algorithm_});
    const auto machines = parse_architectures({architecture_}, options_.settings, Fidelity::kCycle);
    if (algorithms.size() != 1 || machines.size() != 1)
      throw usage_error("`cuesta verify rtl` takes one algorithm and one architecture.");
    if (!algorithms[0].exact()) {
      throw usage_error("The hardware has exact algorithms, and " + algorithms[0].id +
                        " is a search; accepted by `cuesta verify rtl` are exact algorithms and schedules.");
    }
    LockstepCase one;
    one.machine.architecture = machines[0].architecture;
    if (!stalls_.empty()) one.machine.stalls = parse_stalls(stalls_, "--stalls");
    if (unit_ == "hmt_top" && one.machine.stalls.per_mille[static_cast<int>(Port::kSetup)] != 0) {
      throw usage_error(
          "--stalls " + stalls_ +
          ": the third port, setup, is inside hmt_top, where nothing can hold it back; accepted is 0 "
          "there, or --unit traverse.");
    }
    one.machine.register_seed = register_seed_;
    if (!memory_.empty()) one.machine.memory = parse_memory_timing(memory_, "--memory");
    Job job = prepare_job(scene_.empty() ? "default" : scene_, scene_changes(options_),
                          watched(session, "making rays", 0));
    one.machine.schedule = algorithm_on(algorithms[0], machines[0].architecture.traverse).schedule;
    if (one.machine.schedule.stop_level > job.map.root_level) {
      throw usage_error(fmt::format(
          "Algorithm {} stops at level {}, above the root of the map; accepted are levels 0 to {}.",
          algorithms[0].id, one.machine.schedule.stop_level, job.map.root_level));
    }
    one.address_mode = job.map.address_mode;
    one.width = job.trace.width;
    one.height = job.trace.height;
    one.rays = std::move(job.trace.rays);
    one.pyramid = std::make_shared<Pyramid>(std::move(job.pyramid));

    Totals totals;
    LockstepResult result;
    {
      ProgressBar bar(session, "verify rtl", "rays", one.rays.size());
      result = run_lockstep(one, sides_[0], sides_[1], LockstepDepth::kFirstCycle,
                            [&](uint64_t rays) { return bar.update(rays); });
    }
    totals.add(result);
    if (!result.equal()) fail(session, one, result, totals);
    if (result.stuck) refuse_standstill(*result.stuck);
    return finish(totals, result.stopped);
  }

  ExitCode compare_random(const Session& session) {
    const std::vector<rtl::RtlSet> sets = compiled_sets(split_at_commas(sets_, "--sets"));
    const HardwareUnit unit = parse_hardware_unit(unit_);
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(seconds_);
    const bool by_rays = count_option_.count() > 0;
    ProgressBar bar(session, "verify rtl", "rays", by_rays ? ray_count_ : 0);
    Totals totals;
    bool stopped = false;
    auto wanted = [&] { return by_rays ? totals.rays < ray_count_ : Clock::now() < end; };
    for (uint64_t number = 0; !stopped && wanted();) {
      // A batch of machines at a time, compared in their order.
      std::vector<std::pair<LockstepCase, std::future<LockstepResult>>> running;
      for (int k = 0; k < workers_; ++k, ++number) {
        const rtl::RtlParameters& parameters = sets[number % sets.size()].parameters;
        running.emplace_back(random_rtl_case(structure_of(parameters, unit), seed_ + number, kMostRays),
                             std::future<LockstepResult>());
      }
      for (auto& [one, result] : running) {
        result = std::async(workers_ > 1 ? std::launch::async : std::launch::deferred,
                            [&one = one, this] { return run_lockstep(one, sides_[0], sides_[1]); });
      }
      for (auto& [one, future] : running) {
        const LockstepResult result = future.get();
        totals.add(result);
        if (!result.equal()) fail(session, one, result, totals);
        if (result.stuck) refuse_standstill(*result.stuck);
      }
      stopped = !bar.update(totals.rays);
    }
    sets_compared_ = sets.size();
    return finish(totals, stopped);
  }

  [[noreturn]] static void refuse_standstill(const Error& stuck) {
    throw Error(stuck.code(), "verify rtl: no difference, but model and RTL alike stand still: " +
                                  std::string(stuck.what()) +
                                  (std::string_view(stuck.what()).ends_with(".") ? "" : "."));
  }

  ExitCode finish(const Totals& totals, bool stopped) const {
    if (sets_compared_ > 0)
      fmt::print("{} machines over {} compiled set{}; ", totals.machines, sets_compared_,
                 sets_compared_ == 1 ? "" : "s");
    fmt::print("verify rtl: {} rays, {} cycles, {} memory requests, 0 differences{}\n", totals.rays,
               totals.cycles, totals.requests, stopped ? "; stopped before the end" : "");
    return stopped ? ExitCode::kIncomplete : ExitCode::kOk;
  }

  /// Prints the difference, makes the case smaller and leaves it as files.
  [[noreturn]] void fail(const Session& session, const LockstepCase& one, const LockstepResult& result,
                         const Totals& totals) {
    const std::string names[2] = {sides_[0].name, sides_[1].name};
    const std::string first = report(result.differences, names);
    fmt::print("{}", first);
    if (!session.quiet)
      fmt::print(stderr, "verify rtl: looking for the smallest workload that differs ...\n");
    const ShrunkCase shrunk = shrink(
        one,
        [&](const LockstepCase& candidate) {
          return !stop_requested() &&
                 !run_lockstep(candidate, sides_[0], sides_[1], LockstepDepth::kWhether).equal();
        },
        result.rays);
    const LockstepResult smallest = run_lockstep(shrunk.smallest, sides_[0], sides_[1]);
    if (!folder_) folder_.emplace(open_result_folder(options_, "verify-rtl"));
    ResultFolder& folder = *folder_;
    const std::string arguments =
        write_case(shrunk.smallest, folder.file("scene.toml").parent_path(), folder.final_path());
    const std::string small = "\nthe smallest workload that differs, after " + std::to_string(shrunk.runs) +
                              " tries:\n" + describe(shrunk.smallest) + report(smallest.differences, names) +
                              "again: cuesta verify rtl " + arguments +
                              (unit_ == "hmt_top" ? "" : " --unit " + unit_) + "\n";
    fmt::print("{}", small);
    leave_waves(shrunk.smallest, sides_[1], smallest.differences.at(0),
                folder.file("first_difference.fst").string());
    folder.write("difference.txt", describe(one) + first + small);
    folder.commit();
    fmt::print("files, and waves around the difference: {}\n", folder.final_path().string());
    throw Error(
        ExitCode::kMismatch,
        fmt::format(
            "verify rtl: {} rays, {} cycles, 1 difference: cycle {}, {}.{}, seed {}; it is decoded above.",
            totals.rays, totals.cycles, result.differences[0].cycle, result.differences[0].unit,
            result.differences[0].field, one.seed));
  }

  std::string scene_, unit_ = "hmt_top", algorithm_ = "yun2013", architecture_ = "mobile", stalls_, memory_;
  std::vector<std::string> sets_;
  RunOptions options_;
  int64_t seconds_ = 20;
  uint64_t ray_count_ = 0;
  uint64_t seed_ = 1;
  int workers_ = 1;
  int register_seed_ = 0;
  Option seconds_option_, count_option_, seed_option_, sets_option_, workers_option_, algorithm_option_,
      architecture_option_, register_seed_option_;
  std::optional<ResultFolder> folder_;  ///< of -o
  std::array<LockstepSide, 2> sides_;
  size_t sets_compared_ = 0;
};

}  // namespace

std::unique_ptr<Command> make_verify_rtl_command() { return make_command<VerifyRtlCommand>(); }

}  // namespace cuesta
