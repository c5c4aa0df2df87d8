#include "sim/verify/oracle/oracle_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "sim/session/parallel.h"

namespace cuesta {
namespace {

constexpr int64_t kRaysPerBatch = 1000;  ///< between two looks at the observer
constexpr int kRaysPerMap = 50;
constexpr int64_t kLatticeShare = 5;  ///< one precision ray in so many
constexpr int64_t kBorderShare = 10;  ///< one bilinear ray in so many is swept across borders as well

/// Small maps, whose every cell brute force can ask, and one batch in four of larger ones.
int side_of(uint64_t batch, int max_side) { return batch % 4 == 3 ? max_side : std::max(1, max_side / 4); }

class Checker {
 public:
  Checker(const OracleRequest& request, Observer& observer, OracleCounts& counts)
      : request_(request), observer_(observer), counts_(counts) {}

  void traversal() {
    counts_.traversal = in_batches<TraversalCheck>(
        "verify oracle", request_.rays,
        [this](uint64_t batch, int64_t rays) {
          return check_random_traversals(Random::mix(request_.seed + batch), rays,
                                         side_of(batch, request_.max_side), kRaysPerMap, {});
        },
        [](const TraversalCheck& counts) { return counts.passed(); });
  }

  void precision() {
    const int64_t on_lattice = request_.precision_rays / kLatticeShare;
    counts_.free = precision("precision", request_.precision_rays - on_lattice, PrecisionRays::kFree);
    counts_.lattice = precision("precision, lattice", on_lattice, PrecisionRays::kLattice);
  }

  void bilinear() {
    counts_.walks = bilinear("bilinear", request_.bilinear_rays, check_bilinear_walks);
    counts_.borders =
        bilinear("bilinear, borders", request_.bilinear_rays / kBorderShare, check_bilinear_borders);
    counts_.exact = bilinear("bilinear, exact", request_.bilinear_exact_rays, check_bilinear_exactly);
  }

 private:
  /// Gives the sum of check(batch, rays of it) over batches of `rays` rays, as long as it is `good`.
  template <class Counts, class Check, class Good>
  Counts in_batches(const std::string& what, int64_t rays, Check check, Good good) {
    Counts counts;
    Stage stage(observer_, what, "rays", static_cast<uint64_t>(rays));
    int64_t planned = 0;
    uint64_t batch = 0;
    bool begun = false;
    ordered_groups(
        request_.threads,
        [&] {
          const int64_t size = std::min(kRaysPerBatch, rays - planned);
          const auto task = [check, size, number = batch] { return check(number, size); };
          planned += size;
          ++batch;
          return size > 0 ? std::optional(task) : std::nullopt;
        },
        [&](const Counts& found) {
          counts.add(found);
          return good(counts);
        },
        [&] {
          if (begun) counts_.stopped = !stage.update(static_cast<uint64_t>(counts.rays));
          begun = true;
          return counts.rays < rays && good(counts) && !counts_.stopped;
        });
    return counts;
  }

  PrecisionCheck precision(const std::string& what, int64_t rays, PrecisionRays kind) {
    return in_batches<PrecisionCheck>(
        what, rays,
        [this, kind](uint64_t batch, int64_t size) {
          return check_precision(Random::mix(~request_.seed + batch), size, request_.max_side, kind);
        },
        [](const PrecisionCheck&) { return true; });
  }

  template <class Check>
  BilinearCheck bilinear(const std::string& what, int64_t rays, Check check) {
    return in_batches<BilinearCheck>(
        what, rays,
        [this, check](uint64_t batch, int64_t size) {
          return check(Random::mix(request_.seed ^ (batch << 20)), size, side_of(batch, request_.max_side));
        },
        [](const BilinearCheck& counts) { return counts.passed(); });
  }

  const OracleRequest& request_;
  Observer& observer_;
  OracleCounts& counts_;
};

}  // namespace

int64_t OracleCounts::rays() const {
  return traversal.rays + free.rays + lattice.rays + walks.rays + borders.rays + exact.rays;
}

int64_t OracleCounts::comparisons() const { return traversal.comparisons + walks.comparisons; }

std::string fault_of(const OracleCounts& counts, OraclePart part, uint64_t seed) {
  if (part == OraclePart::kTraversal) {
    const TraversalCheck& c = counts.traversal;
    if (c.passed()) return "";
    return fmt::format(
        "{} mismatches, {} endless walks, {} oracle errors, {} step errors, {} quad errors and {} lane "
        "errors "
        "with seed {}",
        c.mismatches, c.endless, c.oracle_errors, c.step_errors, c.quad_errors, c.lane_errors, seed);
  }
  if (part == OraclePart::kPrecision) {
    const int64_t inexact = counts.free.errors() + counts.lattice.errors();
    if (inexact == 0) return "";
    return fmt::format("{} fixed-point answers are not exact for the ray as set up, with seed {}", inexact,
                       seed);
  }
  const BilinearCheck &walks = counts.walks, &borders = counts.borders;
  if (walks.passed() && borders.passed()) return "";
  return fmt::format(
      "on bilinear surfaces {} mismatches, {} endless walks, {} borders on which two patches disagree and {} "
      "gaps, with seed {}",
      walks.mismatches, walks.endless, borders.border_differences, borders.gaps, seed);
}

OracleCounts check_oracle(const OracleRequest& request, Observer& observer,
                          const OracleListener& after_part) {
  OracleCounts counts;
  Checker checker(request, observer, counts);
  constexpr void (Checker::*kParts[])() = {&Checker::traversal, &Checker::precision, &Checker::bilinear};
  for (size_t k = 0; k < std::size(kParts); ++k) {
    const auto part = static_cast<OraclePart>(k);
    (checker.*kParts[k])();
    if (after_part) after_part(counts, part);
    if (!fault_of(counts, part, request.seed).empty()) break;
  }
  return counts;
}

}  // namespace cuesta
