#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "models/common/words.h"
#include "reports/result_folder.h"
#include "sim/cli/map_size.h"
#include "sim/cli/names.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"
#include "sim/config/on_architecture.h"
#include "sim/explore/adversary/adversary.h"
#include "sim/explore/adversary/adversary_files.h"

namespace cuesta {
namespace {

constexpr int kLongestSide = 64;
constexpr AddressMode kModes[] = {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kMirror,
                                  AddressMode::kClamp};

template <class E>
E choice(const char* option, const std::string& text, std::span<const std::string_view> names) {
  for (size_t k = 0; k < names.size(); ++k) {
    if (names[k] == text) return static_cast<E>(k);
  }
  const std::string near = did_you_mean(text, names);
  throw usage_error(std::string(option) + " " + printable(text) + " is not accepted; accepted are " +
                    joined(names) + (near.empty() ? "." : near));
}

/// Searches for the map and the rays that are worst for an algorithm, and writes them as a scene.
class AdversaryCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("--algorithm", algorithm_, "One out of `cuesta list algorithms`, or a schedule")
        .with_default();
    options
        .add("--maximise", maximise_,
             "steps or cycles per ray, or error: how far the found place lies from the exact one")
        .with_default();
    options.add("--arch", architecture_, "Preset or architecture file").with_default();
    options.add("--set", settings_,
                "One value of the architecture: traverse.arithmetic=float; may be repeated");
    options.add("--address", address_, "border, wrap, mirror or clamp").with_default();
    options.add("--size", size_, "Texels: 16 or 24x16, 1 to 64 on a side").with_default();
    options.add("--bits", options_.bounds.bits, "Bits of a height, 1 to 16").range(1, 16).with_default();
    options.add("--rays", options_.bounds.rays, "Rays of a case").range(1, 4096).with_default();
    options
        .add("--reach", options_.bounds.reach,
             "Tiles that a ray moves at most, along u and along v, from the slab's top to its floor")
        .range(0.001, 7.0)
        .with_default();
    options.add("--seed", options_.seed, "Another seed, another search").with_default();
    const Option tries = options.add("--tries", tries_, "Cases to score; the same number finds the same case")
                             .range(uint64_t{1}, uint64_t{1000000000});
    options
        .add("--seconds", seconds_, "Ends after so many seconds in the place of so many tries; default: 60")
        .range(1, 1000000)
        .excludes(tries);
    options
        .add("-o,--output", folder_, "Folder to write: scene.toml, map.png, rays.csv, case.toml, README.md")
        .required();
    options.add_flag("--force,--overwrite", force_, "Replace an older folder of that kind");
  }

  ExitCode run(const Session& session) override {
    const auto maximise = choice<Maximise>("--maximise", maximise_, maximise_names());
    const Fidelity fidelity = maximise == Maximise::kCycles ? Fidelity::kCycle : Fidelity::kFunctional;
    const auto algorithms = parse_algorithms({algorithm_});
    const auto machines = parse_architectures({architecture_}, settings_, fidelity);
    if (algorithms.size() != 1 || machines.size() != 1) {
      throw usage_error("`cuesta adversary` takes one algorithm and one architecture.");
    }
    const Architecture& architecture = machines[0].architecture;
    check_searches(algorithms, machines);
    const Algorithm algorithm = algorithm_on(algorithms[0], architecture.traverse);
    const AddressMode mode = address_mode();
    AdversaryBounds& bounds = options_.bounds;
    if (!std::isfinite(bounds.reach))
      throw usage_error("--reach is no number; accepted are 0.001 to 7 tiles.");
    parse_map_size(size_, bounds.width, bounds.height, kLongestSide);
    if (algorithm.schedule.stop_level > 0) {
      throw usage_error("--algorithm " + algorithm.id +
                        " stops above the texels; accepted are schedules that stop at level 0.");
    }
    if (algorithm.search && is_printed(algorithm.search->kind)) {
      throw usage_error(
          "--algorithm " + algorithm.id +
          " has faults that need no search, and runs on square powers of two alone; accepted are the "
          "others.");
    }
    ResultFolder folder = ResultFolder::create(folder_, force_);

    const AdversaryScorer scorer(algorithm, architecture, mode, maximise);
    bool stopped = false;
    const AdversaryResult result = search(session, scorer, stopped);
    if (result.tries == 0)
      throw Error(ExitCode::kIncomplete, "Stopped before the first case was scored; nothing is kept.");

    AdversaryRecord record;
    record.algorithm = algorithm.id;
    record.maximise = maximise;
    record.architecture = architecture_;
    record.settings = settings_;
    record.address_mode = mode;
    record.options = options_;
    record.leaf_walk = scorer.score_of(*find_algorithm("dda"), result.best.grid, result.best.traced());
    write_adversary_files(record, result, folder);
    folder.commit();
    fmt::print("{}: {} {}, {:.6g} by the leaf walk; the best of {} cases was number {}\nReproduce: {}\n{}\n",
               algorithm.id, shortest_text(result.score), unit_of(maximise), record.leaf_walk, result.tries,
               result.best_try, reproducing_command(record, folder.final_path().string()),
               place_of_score(record));
    if (maximise == Maximise::kError)
      fmt::print("Search again: {} -o again\n", finding_command(record, result.best_try));
    if (!result.fault.empty()) {
      throw Error(ExitCode::kMismatch, "An exact algorithm is not exact in the case kept in " +
                                           folder.final_path().string() + ": " + result.fault +
                                           "; a fault of the simulator; please report it.");
    }
    return stopped ? ExitCode::kIncomplete : ExitCode::kOk;
  }

 private:
  AddressMode address_mode() const {
    std::string_view names[std::size(kModes)];
    for (size_t k = 0; k < std::size(kModes); ++k) names[k] = name_of(kModes[k]);
    return choice<AddressMode>("--address", address_, names);
  }

  AdversaryResult search(const Session& session, const AdversaryScorer& scorer, bool& stopped) const {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::seconds(seconds_);
    ProgressBar bar(session, algorithm_ + ", " + maximise_, "cases", tries_);
    return run_adversary(scorer, options_, [&](uint64_t tries, double) {
      if (!bar.update(tries)) {
        stopped = true;
        return false;
      }
      return tries_ > 0 ? tries < tries_ : Clock::now() < end;
    });
  }

  std::string algorithm_ = "yun2013", maximise_ = "steps", architecture_ = "tiny", address_ = "wrap",
              size_ = "16";
  std::vector<std::string> settings_;
  std::string folder_;
  AdversaryOptions options_;
  uint64_t tries_ = 0;
  int seconds_ = 60;
  bool force_ = false;
};

}  // namespace

std::unique_ptr<Command> make_adversary_command() { return make_command<AdversaryCommand>(); }

}  // namespace cuesta
