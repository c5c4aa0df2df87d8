#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/common/statistics.h"
#include "models/oracle/verdict.h"
#include "models/rays/hit.h"
#include "models/work/workload.h"

namespace cuesta {

/// How the hits of an approximate search stand to the true ones, ray by ray.
struct Judgement {
  /// Per ray, in the order of the trace; nothing for one that ended without an answer.
  std::vector<std::optional<Verdict>> verdicts;
  VerdictCounts counts;
  int64_t not_numbers = 0, unfinished = 0;  ///< rays without an answer

  /// Says whether a ray has a wrong answer or none.
  bool wrong(size_t ray) const { return !verdicts[ray] || is_wrong(*verdicts[ray]); }
  /// Of the rays that hit and truly hit: how far along the ray the found place lies from the true one, as the
  /// difference in height (height LSBs) and on the plane (texels).
  std::vector<double> height_errors, texel_errors;
};

/// Errors are counted in 256ths, of a height LSB or of a texel, rounded to nearest.
inline constexpr double kErrorParts = 256;
int64_t in_error_parts(double error);
Histogram error_histogram(std::string name, std::span<const double> errors);

/// Holds hits against exact arithmetic on the ray as it enters the machine.
class HitJudge {
 public:
  /// Takes pyramid (max, from the leaves), map, rays and their format from `work`; what that points to must outlive the
  /// judge.
  explicit HitJudge(const Workload& work);

  /// `hits`: one per ray, all finished, with times as `arithmetic` has them. A ray whose cell the walk in double
  /// finds as well is exact (verify oracle holds that walk against exact arithmetic); every other ray is judged by
  /// the oracle.
  Judgement judge(std::span<const HitRecord> hits, Arithmetic arithmetic);

  /// Returns the true hits, in double.
  std::span<const HitRecord> truth() const { return truth_; }
  /// Returns how far down the slab a hit lies, 0 where rays enter to 1 at the ground; 1 for a ray that misses.
  /// Descending rays.
  double depth_of(size_t ray, const HitRecord& hit, Arithmetic arithmetic) const;

 private:
  /// In machine time units.
  double time_of(const HitRecord& hit, Arithmetic arithmetic) const;
  const OracleHit<Int128>& exact_hit(size_t ray, const ExactRay<Int128>& exact);

  Workload work_;
  OracleMap map_;
  std::vector<HitRecord> truth_;
  std::vector<std::optional<OracleHit<Int128>>> exact_;  ///< per ray, once it was asked for
};

}  // namespace cuesta
