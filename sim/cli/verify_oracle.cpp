#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <future>
#include <string_view>
#include <vector>

#include "models/oracle/bilinear_check.h"
#include "models/oracle/precision_check.h"
#include "models/oracle/traversal_check.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"

namespace cuesta {
namespace {

constexpr int64_t kRaysPerBatch = 1000;  ///< between two looks at the clock and at Ctrl-C
constexpr int kRaysPerMap = 50;

void print_head(std::string_view what) {
  fmt::print("  {:<28}", what);
  for (int v = 0; v < kVerdicts; ++v) fmt::print("{:>12}", name_of(static_cast<Verdict>(v)));
  fmt::print("{:>13}\n", "not exact");
}

/// A tie is right under another reading of edges; what is neither exact nor a tie is wrong.
void print_row(std::string_view name, const VerdictCounts& counts) {
  fmt::print("  {:<28}", name);
  for (const int64_t count : counts.of) fmt::print("{:>12}", count);
  const int64_t wrong = counts.total() - counts.count(Verdict::kExact);
  fmt::print("{:>11.4f} %\n", counts.total() > 0
                                  ? 100.0 * static_cast<double>(wrong) / static_cast<double>(counts.total())
                                  : 0);
}

/// Random maps and rays under every schedule and arithmetic, and both exact oracles.
class VerifyOracleCommand : public Command {
 public:
  void declare(Options& options) override {
    options
        .add("--rays", rays_,
             "Rays to check; each is walked under 109 schedules in 3 arithmetics, on maps in every "
             "address mode, "
             "some stopped above the texels")
        .range(int64_t{0}, int64_t{1000000000})
        .with_default();
    options
        .add("--precision-rays", precision_rays_,
             "Rays whose answer is judged in each number format, as quantised and as traced; one in "
             "five lies on "
             "the lattice")
        .range(int64_t{0}, int64_t{1000000000})
        .with_default();
    options
        .add("--bilinear-rays", bilinear_rays_,
             "Rays over bilinear surfaces; each is walked under the same schedules in float and double. A "
             "tenth of them, in fans, is swept across the borders of patches")
        .range(int64_t{0}, int64_t{1000000000})
        .with_default();
    options
        .add("--bilinear-exact-rays", bilinear_exact_rays_,
             "Rays over bilinear surfaces whose answer is held against exact arithmetic")
        .range(int64_t{0}, int64_t{1000000000})
        .with_default();
    options.add("--seed", seed_, "Seed of maps and rays").with_default();
    options.add("--max-side", max_side_, "Longest side of a map, texels").range(1, 1024).with_default();
    options.add("--threads", threads_, "Threads that share the work; the counts do not depend on them")
        .range(1, 256)
        .with_default();
  }

  ExitCode run(const Session& session) override {
    if (rays_ == 0 && precision_rays_ == 0 && bilinear_rays_ == 0 && bilinear_exact_rays_ == 0) {
      throw usage_error(
          "--rays, --precision-rays, --bilinear-rays and --bilinear-exact-rays are all 0, which leaves "
          "nothing to "
          "check; accepted is more than 0 for one of them at least.");
    }
    const TraversalCheck counts = check_traversals(session);
    if (rays_ > 0) print(counts);
    if (!counts.passed()) {
      throw Error(
          ExitCode::kMismatch,
          fmt::format("verify oracle: {} mismatches, {} endless walks, {} oracle errors, {} step errors, {} "
                      "quad errors and {} lane errors with seed {}; the first is decoded above.",
                      counts.mismatches, counts.endless, counts.oracle_errors, counts.step_errors,
                      counts.quad_errors, counts.lane_errors, seed_));
    }
    const int64_t on_lattice = precision_rays_ / 5;
    const PrecisionCheck free = check_precisions(session, precision_rays_ - on_lattice, PrecisionRays::kFree);
    const PrecisionCheck lattice = check_precisions(session, on_lattice, PrecisionRays::kLattice);
    if (free.rays > 0) print(free, "of any place and direction");
    if (lattice.rays > 0) print(lattice, "on planes, corners and heights, where the last bit decides");
    const int64_t inexact = free.errors() + lattice.errors();
    if (inexact > 0) {
      throw Error(ExitCode::kMismatch,
                  fmt::format("verify oracle: {} fixed-point answers are not exact for the ray as "
                              "set up, with seed {}; the first is decoded above.",
                              inexact, seed_));
    }
    const BilinearCheck walks = check_bilinear(session, "bilinear", bilinear_rays_, check_bilinear_walks);
    const BilinearCheck borders =
        check_bilinear(session, "bilinear, borders", bilinear_rays_ / 10, check_bilinear_borders);
    const BilinearCheck exact =
        check_bilinear(session, "bilinear, exact", bilinear_exact_rays_, check_bilinear_exactly);
    print(walks, borders, exact);
    if (!walks.passed() || !borders.passed()) {
      throw Error(
          ExitCode::kMismatch,
          fmt::format("verify oracle: on bilinear surfaces {} mismatches, {} endless walks, {} borders "
                      "on which two patches disagree and {} gaps, with seed {}; the first is decoded "
                      "above.",
                      walks.mismatches, walks.endless, borders.border_differences, borders.gaps, seed_));
    }
    fmt::print("verify oracle: {} rays, {} comparisons, 0 mismatches, 0 endless walks, 0 oracle errors{}\n",
               counts.rays + free.rays + lattice.rays + walks.rays + borders.rays + exact.rays,
               counts.comparisons + walks.comparisons, stopped_ ? "; stopped before the end" : "");
    return stopped_ ? ExitCode::kIncomplete : ExitCode::kOk;
  }

 private:
  /// Batch after batch, `threads_` at a time, counted in their order: sum(check(batch, rays of it)).
  template <class Counts, class Check, class Good>
  Counts in_batches(const Session& session, const char* what, int64_t rays, Check&& check, Good&& good) {
    Counts counts;
    ProgressBar progress(session, what, "rays", static_cast<uint64_t>(rays));
    int64_t planned = 0;
    for (uint64_t batch = 0; counts.rays < rays && good(counts) && !stopped_;) {
      std::vector<std::future<Counts>> running;
      while (static_cast<int>(running.size()) < threads_ && planned < rays) {
        const int64_t size = std::min(kRaysPerBatch, rays - planned);
        planned += size;
        running.push_back(std::async(std::launch::async, check, batch++, size));
      }
      for (auto& result : running) {
        const Counts found = result.get();
        if (good(counts)) counts.add(found);
      }
      stopped_ = !progress.update(static_cast<uint64_t>(counts.rays));
    }
    return counts;
  }

  TraversalCheck check_traversals(const Session& session) {
    // Small maps, whose every cell brute force can ask, and one batch in four of larger ones.
    return in_batches<TraversalCheck>(
        session, "verify oracle", rays_,
        [this](uint64_t batch, int64_t size) {
          const int side = batch % 4 == 3 ? max_side_ : std::max(1, max_side_ / 4);
          return check_random_traversals(Random::mix(seed_ + batch), size, side, kRaysPerMap, {});
        },
        [](const TraversalCheck& counts) { return counts.passed(); });
  }

  PrecisionCheck check_precisions(const Session& session, int64_t rays, PrecisionRays kind) {
    return in_batches<PrecisionCheck>(
        session, kind == PrecisionRays::kFree ? "precision" : "precision, lattice", rays,
        [this, kind](uint64_t batch, int64_t size) {
          return check_precision(Random::mix(~seed_ + batch), size, max_side_, kind);
        },
        [](const PrecisionCheck&) { return true; });
  }

  template <class Check>
  BilinearCheck check_bilinear(const Session& session, const char* what, int64_t rays, Check&& check) {
    return in_batches<BilinearCheck>(
        session, what, rays,
        [this, &check](uint64_t batch, int64_t size) {
          const int side = batch % 4 == 3 ? max_side_ : std::max(1, max_side_ / 4);
          return check(Random::mix(seed_ ^ (batch << 20)), size, side);
        },
        [](const BilinearCheck& counts) { return counts.passed(); });
  }

  static void print(const BilinearCheck& walks, const BilinearCheck& borders, const BilinearCheck& exact) {
    if (walks.rays > 0) {
      fmt::print("\nbilinear surfaces: {} maps, {} rays (", walks.maps, walks.rays);
      for (const AddressMode mode : {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kClamp}) {
        fmt::print("{} {}{}", name_of(mode), walks.rays_by_mode[static_cast<size_t>(mode)],
                   mode == AddressMode::kClamp ? "" : ", ");
      }
      fmt::print(
          "), {} of them hit\nevery schedule against dda, in float and in double (hit, cell, t, face):\n",
          walks.hits);
      fmt::print("  {} comparisons, {} mismatches, {} endless walks\n", walks.comparisons, walks.mismatches,
                 walks.endless);
    }
    if (borders.rays > 0) {
      fmt::print("{} rays in fans across borders and corners of patches, in float and in double:\n",
                 borders.rays);
      fmt::print(
          "  {} borders crossed, {} on which the two patches disagree; {} rays fall to the floor, {} find "
          "no surface\n",
          borders.borders, borders.border_differences, borders.falling, borders.gaps);
    }
    for (const BilinearCheck* c : {&walks, &borders}) {
      if (!c->first_failure.empty()) fmt::print("first failure: {}\n", c->first_failure);
    }
    if (exact.rays == 0) return;
    fmt::print("dda over {} rays, {} of them hit, against exact arithmetic:\n", exact.rays, exact.hits);
    print_head("as quantised at the input");
    constexpr std::string_view kNames[] = {"float", "double"};
    for (size_t a = 0; a < exact.exact.size(); ++a) print_row(kNames[a], exact.exact[a].verdicts);
    for (size_t a = 0; a < exact.exact.size(); ++a) {
      const BilinearCheck::Exact& e = exact.exact[a];
      fmt::print(
          "  {}: of {} times {} within 4 ulps, the largest error {:.4g} ulps; the farthest from the surface "
          "{:.3g} LSBs\n",
          kNames[a], e.times, e.within_4, e.largest_ulps, e.largest_height);
    }
  }

  static void print(const TraversalCheck& c) {
    fmt::print("{} maps, {} rays, {} of them hit\n", c.maps, c.rays, c.hits);
    for (size_t mode = 0; mode < c.rays_by_mode.size(); ++mode) {
      fmt::print("  {:<8}{:>10} rays, {} of them over means (stopped above the texels)\n",
                 name_of(static_cast<AddressMode>(mode)), c.rays_by_mode[mode], c.stopped_by_mode[mode]);
    }
    fmt::print("every schedule against dda, in the same arithmetic (hit, cell, t, face):\n");
    fmt::print("  {} comparisons, {} mismatches, {} endless walks\n", c.comparisons, c.mismatches, c.endless);
    fmt::print("the same walks through kept 2 x 2 siblings (whole records, steps too):\n");
    fmt::print("  {} comparisons, {} errors\n", c.quad_comparisons, c.quad_errors);
    fmt::print("fixed-point dda against exact arithmetic (hit, cell, t, face, of the ray as set up):\n");
    fmt::print("  {} leaf walks, {} by brute force over all cells, {} errors\n", c.oracle_walks,
               c.oracle_brute, c.oracle_errors);
    fmt::print("fixed-point steps against the same schedule walked exactly:\n");
    fmt::print("  {} comparisons, {} errors\n", c.step_comparisons, c.step_errors);
    if (c.lane_comparisons > 0) {
      fmt::print("many rays at a time (AVX-512) against one at a time (whole records):\n");
      fmt::print("  {} comparisons, {} errors\n", c.lane_comparisons, c.lane_errors);
    }
    if (!c.first_failure.empty()) fmt::print("first failure: {}\n", c.first_failure);
  }

  static void print(const PrecisionCheck& c, std::string_view which) {
    fmt::print("\nprecision: dda over {} rays {}\n", c.rays, which);
    int64_t set_up = 0;
    for (const PrecisionRow& row : c.rows) set_up += row.set_up.total();
    fmt::print("  against the ray as set up (reciprocals rounded): {} fixed-point answers, {} not exact\n",
               set_up, c.errors());
    print_head("as quantised at the input");
    for (size_t k = 0; k < c.rows.size(); ++k) print_row(kPrecisionFormats[k].name, c.rows[k].quantised);
    print_head("as traced, end to end");
    for (size_t k = 0; k < c.rows.size(); ++k) print_row(kPrecisionFormats[k].name, c.rows[k].traced);
    if (!c.first_failure.empty()) fmt::print("first failure: {}\n", c.first_failure);
  }

  int64_t rays_ = 25000;
  int64_t precision_rays_ = 10000;
  int64_t bilinear_rays_ = 5000;
  int64_t bilinear_exact_rays_ = 2000;
  uint64_t seed_ = 1;
  int max_side_ = 96;
  int threads_ = 1;
  bool stopped_ = false;
};

}  // namespace

std::unique_ptr<Command> make_verify_oracle_command() { return make_command<VerifyOracleCommand>(); }

}  // namespace cuesta
