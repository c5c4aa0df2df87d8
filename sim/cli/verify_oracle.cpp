#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "models/oracle/traversal_check.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"

namespace cuesta {
namespace {

constexpr int64_t kRaysPerBatch = 1000;  ///< between two looks at the clock and at Ctrl-C
constexpr int kRaysPerMap = 50;

/// Random maps and rays under every schedule and arithmetic, and both exact oracles.
class VerifyOracleCommand : public Command {
 public:
  void declare(CLI::App& app) override {
    app.add_option("--rays", rays_, "Rays to check; each is walked under 104 schedules in 3 arithmetics")
        ->check(CLI::Range(int64_t{1}, int64_t{1000000000}))
        ->capture_default_str();
    app.add_option("--seed", seed_, "Seed of maps and rays")->capture_default_str();
    app.add_option("--max-side", max_side_, "Longest side of a map, texels")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
  }

  ExitCode run(const Session& session) override {
    TraversalCheck counts;
    bool stopped = false;
    {
      ProgressBar progress(session, "verify oracle", "rays", static_cast<uint64_t>(rays_));
      for (uint64_t batch = 0; counts.rays < rays_ && counts.passed() && !stopped; ++batch) {
        const int64_t size = std::min(kRaysPerBatch, rays_ - counts.rays);
        // Small maps, whose every cell brute force can ask, and one batch in four of larger ones.
        const int side = batch % 4 == 3 ? max_side_ : std::max(1, max_side_ / 4);
        counts.add(check_random_traversals(Random::mix(seed_ + batch), size, side, kRaysPerMap, {}));
        stopped = !progress.update(static_cast<uint64_t>(counts.rays));
      }
    }
    print(counts);
    if (!counts.passed()) {
      throw Error(ExitCode::kMismatch, fmt::format("verify oracle: {} mismatches, {} endless walks, {} "
                                                   "oracle errors, {} step errors and {} lane errors "
                                                   "with seed {}; the first is decoded above.",
                                                   counts.mismatches, counts.endless, counts.oracle_errors,
                                                   counts.step_errors, counts.lane_errors, seed_));
    }
    fmt::print("verify oracle: {} rays, {} comparisons, 0 mismatches, 0 endless walks, 0 oracle errors{}\n",
               counts.rays, counts.comparisons, stopped ? "; stopped before the end" : "");
    return stopped ? ExitCode::kIncomplete : ExitCode::kOk;
  }

 private:
  static void print(const TraversalCheck& c) {
    fmt::print("{} maps, {} rays, {} of them hit\n", c.maps, c.rays, c.hits);
    fmt::print("every schedule against dda, in the same arithmetic (hit, cell, t, face):\n");
    fmt::print("  {} comparisons, {} mismatches, {} endless walks\n", c.comparisons, c.mismatches, c.endless);
    fmt::print("fixed-point dda against exact arithmetic (hit, cell, t, face, of the ray as set up):\n");
    fmt::print("  {} leaf walks, {} by brute force over all cells, {} errors\n", c.oracle_walks,
               c.oracle_brute, c.oracle_errors);
    fmt::print("fixed-point steps against the same schedule walked exactly:\n");
    fmt::print("  {} comparisons, {} errors\n", c.step_comparisons, c.step_errors);
    if (c.lane_comparisons > 0) {
      fmt::print("many rays at a time (AVX-512) against one at a time (whole records):\n");
      fmt::print("  {} comparisons, {} errors\n", c.lane_comparisons, c.lane_errors);
    }
    fmt::print("dda against the exact answer to the machine's input (rays in the default number format):\n");
    fmt::print("  {:<8}", "");
    for (int v = 0; v < kVerdicts; ++v) fmt::print("{:>12}", name_of(static_cast<Verdict>(v)));
    fmt::print("{:>12}\n", "other face");
    constexpr std::string_view kNames[] = {"fixed", "float", "double"};
    for (size_t a = 0; a < 3; ++a) {
      fmt::print("  {:<8}", kNames[a]);
      for (const int64_t count : c.verdicts[a].of) fmt::print("{:>12}", count);
      fmt::print("{:>12}\n", c.other_face[a]);
    }
    if (!c.first_failure.empty()) fmt::print("first failure: {}\n", c.first_failure);
  }

  int64_t rays_ = 25000;
  uint64_t seed_ = 1;
  int max_side_ = 96;
};

}  // namespace

std::unique_ptr<Command> make_verify_oracle_command() { return make_command<VerifyOracleCommand>(); }

}  // namespace cuesta
