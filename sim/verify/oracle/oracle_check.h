#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "models/oracle/bilinear_check.h"
#include "models/oracle/precision_check.h"
#include "models/oracle/traversal_check.h"
#include "sim/session/progress.h"

namespace cuesta {

/// How many random rays are held against exact arithmetic, and over what.
struct OracleRequest {
  int64_t rays = 25000;            ///< walked under every schedule in every arithmetic
  int64_t precision_rays = 10000;  ///< judged in every format of numbers; one in five lies on the lattice
  int64_t bilinear_rays =
      5000;  ///< walked over bilinear surfaces; a tenth again, in fans, across borders of patches
  int64_t bilinear_exact_rays = 2000;  ///< over bilinear surfaces, against exact arithmetic
  uint64_t seed = 1;                   ///< of maps and rays
  int max_side = 96;                   ///< texels of the longest side of a map
  int threads = 1;                     ///< that share the work; the counts do not depend on them
};

/// Everything that was counted. A part that was not reached, or of which no ray was asked for, has counted none.
struct OracleCounts {
  TraversalCheck traversal;
  PrecisionCheck free;     ///< rays of any place and direction
  PrecisionCheck lattice;  ///< rays on planes, corners and heights
  BilinearCheck walks;
  BilinearCheck borders;
  BilinearCheck exact;
  bool stopped = false;  ///< the observer ended it before its end

  int64_t rays() const;         ///< of all parts
  int64_t comparisons() const;  ///< of schedules with the leaf walk
};

/// One of the three parts, in their order.
enum class OraclePart : uint8_t { kTraversal, kPrecision, kBilinear };

/// Says in a sentence what of a part contradicts the oracle, with the seed that shows it again; empty: nothing.
std::string fault_of(const OracleCounts& counts, OraclePart part, uint64_t seed);

/// Called after each part with all that is counted so far.
using OracleListener = std::function<void(const OracleCounts& counts, OraclePart part)>;

/// Walks random rays over random maps and holds them against exact arithmetic, one part after the other, batch after
/// batch. It ends after the first part with a fault, and where the observer wants it to; a batch with a fault is the
/// last one that is counted. The same request gives the same counts.
OracleCounts check_oracle(const OracleRequest& request, Observer& observer,
                          const OracleListener& after_part = {});

}  // namespace cuesta
