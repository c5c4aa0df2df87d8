#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "models/oracle/random_cases.h"

namespace cuesta {

/// Counts of what was held against what.
struct TraversalCheck {
  int64_t maps = 0;
  int64_t rays = 0;
  int64_t hits = 0;          ///< of the rays, by the leaf walk in fixed point
  int64_t comparisons = 0;   ///< (ray, schedule, arithmetic) against `dda` in the same arithmetic
  int64_t mismatches = 0;    ///< of those: hit, cell, t or face differ
  int64_t endless = 0;       ///< walks stopped after more steps than any walk can need
  int64_t oracle_walks = 0;  ///< fixed-point `dda` against the exact leaf walk, of the ray as set up
  int64_t oracle_brute = 0;  ///< and against brute force over all cells
  int64_t oracle_errors = 0;
  int64_t step_comparisons = 0;  ///< fixed-point steps of a schedule against the same schedule walked exactly
  int64_t step_errors = 0;
  int64_t quad_comparisons = 0;  ///< heights read through the kept 2 x 2 siblings: hit and steps must stay
  int64_t quad_errors = 0;
  int64_t lane_comparisons = 0;  ///< many rays at a time against one at a time: whole records
  int64_t lane_errors = 0;
  std::array<int64_t, 4> rays_by_mode{};     ///< of the rays, by AddressMode
  std::array<int64_t, 4> stopped_by_mode{};  ///< of those, over the means of a level above the texels
  std::string first_failure;                 ///< decoded: map, ray, both answers

  bool passed() const {
    return mismatches == 0 && endless == 0 && oracle_errors == 0 && step_errors == 0 && lane_errors == 0 &&
           quad_errors == 0;
  }
  void add(const TraversalCheck& other);
};

struct TraversalCheckOptions {
  bool all_combinations = true;  ///< 3 starts x 4 downs x 8 ups besides the named algorithms
  int step_check_every = 8;      ///< rays; 0: never
  int stop_level = 0;            ///< > 0: leaves are the mean pyramid's texels
};

/// Holds `ray` on `map` under every schedule and arithmetic against the leaf walk, and fixed point against both
/// exact oracles. Throws input_error where `quantise` does.
class TraversalChecker {
 public:
  TraversalChecker(const RandomMap& map, const TraversalCheckOptions& options);
  ~TraversalChecker();
  TraversalChecker(const TraversalChecker&) = delete;
  TraversalChecker& operator=(const TraversalChecker&) = delete;

  void check(const TracedRay& ray, TraversalCheck& counts);
  /// Holds `traverse_lanes`, where this processor and map allow it, against all rays checked so far.
  void check_lanes(TraversalCheck& counts) const;

 private:
  struct State;
  State* state_;
};

/// Random maps and rays until `rays` have been checked; the same seed gives the same counts. `rays_per_map` >= 1.
TraversalCheck check_random_traversals(uint64_t seed, int64_t rays, int max_side, int rays_per_map,
                                       const TraversalCheckOptions& options);

}  // namespace cuesta
