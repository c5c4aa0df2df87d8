#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sim/explore/adversary/adversary_case.h"
#include "sim/explore/adversary/adversary_score.h"

namespace cuesta {

/// What a search is asked for.
struct AdversaryOptions {
  AdversaryBounds bounds;
  uint64_t seed = 1;
  bool learns = true;  ///< false: random cases only, to hold the search against
};

/// What a search has found.
struct AdversaryResult {
  AdversaryCase best;
  double score = -1;
  uint64_t tries = 0;     ///< cases scored
  uint64_t best_try = 0;  ///< which of them was the best, from 1
  uint64_t restarts = 0;
  std::string fault;  ///< not empty: `best` is the case in which an exact algorithm was not exact
};

/// Is called before each try with tries made and the best score; returning false ends the search.
using AdversaryWatch = std::function<bool(uint64_t tries, double best)>;

/// Looks for the case of the highest score: a small population whose members are changed and crossed, the
/// better child in the worst one's place, begun anew when it stands still. The same options and number of
/// tries give the same case.
AdversaryResult run_adversary(const AdversaryScorer& scorer, const AdversaryOptions& options,
                              const AdversaryWatch& watch);

}  // namespace cuesta
