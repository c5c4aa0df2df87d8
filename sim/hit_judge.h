#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/oracle/verdict.h"
#include "models/traversal/hit.h"
#include "sim/machine.h"

namespace cuesta {

/// How the hits of an approximate search stand to the true ones, ray by ray.
struct Judgement {
  std::vector<Verdict> verdicts;  ///< per ray, in the order of the trace
  VerdictCounts counts;
  /// Of the rays that hit and truly hit: how far along the ray the found place lies from the true one, as the
  /// difference in height (height LSBs) and on the plane (texels).
  std::vector<double> height_errors, texel_errors;
};

/// Holds hits against exact arithmetic on the ray as it enters the machine.
class HitJudge {
 public:
  /// `work`: pyramid (max, from the leaves), map and rays, which must outlive the judge.
  HitJudge(const Workload& work, const NumberFormat& format);

  /// `hits`: one per ray, all finished, with times as `arithmetic` has them. A ray whose cell the walk in double finds as
  /// well is exact (verify oracle holds that walk against exact arithmetic); every other ray is judged by the oracle.
  Judgement judge(std::span<const HitRecord> hits, Arithmetic arithmetic) const;

  /// The true hits, in double.
  std::span<const HitRecord> truth() const { return truth_; }

 private:
  /// In machine time units.
  double time_of(const HitRecord& hit, Arithmetic arithmetic) const;

  Workload work_;
  NumberFormat format_;
  std::vector<HitRecord> truth_;
};

}  // namespace cuesta
