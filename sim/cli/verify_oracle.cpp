#include <fmt/core.h>

#include "models/common/error.h"
#include "sim/cli/options.h"
#include "sim/cli/oracle_tables.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"
#include "sim/verify/oracle/oracle_check.h"

namespace cuesta {
namespace {

/// Random maps and rays under every schedule and arithmetic, and both exact oracles.
class VerifyOracleCommand : public Command {
 public:
  void declare(Options& options) override {
    options
        .add("--rays", request_.rays,
             "Rays to check; each is walked under 109 schedules in 3 arithmetics, on maps in every "
             "address mode, "
             "some stopped above the texels")
        .range(int64_t{0}, int64_t{1000000000})
        .with_default();
    options
        .add("--precision-rays", request_.precision_rays,
             "Rays whose answer is judged in each number format, as quantised and as traced; one in "
             "five lies on "
             "the lattice")
        .range(int64_t{0}, int64_t{1000000000})
        .with_default();
    options
        .add("--bilinear-rays", request_.bilinear_rays,
             "Rays over bilinear surfaces; each is walked under the same schedules in float and double. A "
             "tenth of them, in fans, is swept across the borders of patches")
        .range(int64_t{0}, int64_t{1000000000})
        .with_default();
    options
        .add("--bilinear-exact-rays", request_.bilinear_exact_rays,
             "Rays over bilinear surfaces whose answer is held against exact arithmetic")
        .range(int64_t{0}, int64_t{1000000000})
        .with_default();
    options.add("--seed", request_.seed, "Seed of maps and rays").with_default();
    options.add("--max-side", request_.max_side, "Longest side of a map, texels")
        .range(1, 1024)
        .with_default();
    options
        .add("--threads", request_.threads, "Threads that share the work; the counts do not depend on them")
        .range(1, 256)
        .with_default();
  }

  ExitCode run(const Session& session) override {
    if (request_.rays == 0 && request_.precision_rays == 0 && request_.bilinear_rays == 0 &&
        request_.bilinear_exact_rays == 0) {
      throw usage_error(
          "--rays, --precision-rays, --bilinear-rays and --bilinear-exact-rays are all 0, which leaves "
          "nothing to "
          "check; accepted is more than 0 for one of them at least.");
    }
    TerminalObserver observer(session);
    const OracleCounts counts =
        check_oracle(request_, observer, [this](const OracleCounts& so_far, OraclePart part) {
          print_oracle_part(so_far, part);
          const std::string fault = fault_of(so_far, part, request_.seed);
          if (fault.empty()) return;
          throw Error(ExitCode::kMismatch, "verify oracle: " + fault + "; the first is decoded above.");
        });
    fmt::print("verify oracle: {} rays, {} comparisons, 0 mismatches, 0 endless walks, 0 oracle errors{}\n",
               counts.rays(), counts.comparisons(), counts.stopped ? "; stopped before the end" : "");
    return counts.stopped ? ExitCode::kIncomplete : ExitCode::kOk;
  }

 private:
  OracleRequest request_;
};

}  // namespace

std::unique_ptr<Command> make_verify_oracle_command() { return make_command<VerifyOracleCommand>(); }

}  // namespace cuesta
