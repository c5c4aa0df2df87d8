#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "models/heightmap/pyramid.h"
#include "models/oracle/oracle.h"
#include "models/oracle/random_cases.h"
#include "models/oracle/verdict.h"
#include "models/rays/hit.h"
#include "models/search/search_map.h"

namespace cuesta {

/// What one algorithm in one arithmetic did with all rays.
struct HardRow {
  int64_t runs = 0, hits = 0, misses = 0;
  uint64_t steps = 0;
  VerdictCounts verdicts;  ///< against exact arithmetic on the ray as quantised; of some runs none is asked
};

struct HardCounts {
  int64_t cases = 0;  ///< map, address mode, numbers, family of rays
  int64_t rays = 0, refused = 0;
  int64_t runs = 0, hits = 0, misses = 0;
  int64_t hangs = 0;        ///< more steps than any walk over the map can need
  int64_t not_numbers = 0;  ///< times that are not finite, or negative
  int64_t differences =
      0;                ///< an exact algorithm against the leaf walk in its arithmetic: hit, cell, t, face
  int64_t inexact = 0;  ///< fixed point against exact arithmetic on the ray as set up
  int64_t broken = 0;   ///< guarantees of approximate algorithms
  std::map<std::string, HardRow> rows;  ///< by algorithm and arithmetic
  std::string first_failure;            ///< decoded

  int64_t faults() const { return hangs + not_numbers + differences + inexact + broken; }
};

/// One map in one address mode and number format, under every algorithm.
class HardChecker {
 public:
  /// `with_searches`: the approximate algorithms too; the maps they read are made from each texel's neighbourhood.
  HardChecker(HeightGrid grid, AddressMode mode, const NumberFormat& format, bool with_searches);

  const HeightGrid& grid() const { return grid_; }
  const MapShape& shape() const { return shape_; }

  /// Every published schedule and part in every arithmetic, now and then every combination; at the leaves, or stopped
  /// at a level above. The leaf walk in fixed point against the exact leaf walk and brute force. Throws where
  /// quantise does.
  void check_exact(const TracedRay& ray, int stop_level, HardCounts& counts);
  /// The approximate algorithms, over constant and filtered texels.
  void check_searches(const TracedRay& ray, HardCounts& counts);
  /// Every schedule over the bilinear surface, in float and double. Nothing in mirror mode, which has none.
  void check_bilinear(const TracedRay& ray, HardCounts& counts);

 private:
  struct Leaves {
    Pyramid stopped;
    const Pyramid* pyramid = nullptr;
    std::vector<uint16_t> means;
    OracleMap oracle;
  };
  const Leaves& leaves(int stop_level);
  HitRecord walk(Arithmetic arithmetic, const Schedule& schedule, const Pyramid& pyramid,
                 const MachineRay& ray) const;
  void count(const std::string& name, const HitRecord& found, Arithmetic arithmetic, const TracedRay& ray,
             HardCounts& counts, const Verdict* verdict = nullptr) const;
  void fail(HardCounts& counts, const TracedRay& ray, const std::string& what, const HitRecord& expected,
            const HitRecord& found) const;

  HeightGrid grid_;
  MapShape shape_;
  NumberFormat format_;
  Pyramid pyramid_;
  std::vector<Pyramid> corners_;  ///< of the bilinear surface, once it is asked for
  int64_t most_steps_;
  int64_t asked_ = 0;
  std::vector<Leaves> leaves_;  ///< by stop level, made when asked for
  std::vector<Algorithm> algorithms_;
  std::vector<Schedule> combinations_;
  std::vector<Search> searches_;
  std::vector<SearchMap> search_maps_;
};

/// The table that the tests print.
std::string describe(const HardCounts& counts);

}  // namespace cuesta
