#include "sim/hit_judge.h"

#include <bit>
#include <cmath>

#include "models/oracle/exact_ray.h"
#include "models/traversal/arithmetic.h"
#include "sim/machine.h"

namespace cuesta {
namespace {

bool same_answer(const HitRecord& a, const HitRecord& b) {
  return a.status == b.status && (a.status != HitStatus::kHit || (a.i == b.i && a.j == b.j));
}

}  // namespace

HitJudge::HitJudge(const Workload& work, const NumberFormat& format) : work_(work), format_(format) {
  work_.search.reset();
  work_.schedule = find_algorithm("yun2013")->schedule;
  Architecture architecture;
  architecture.traverse.arithmetic = Arithmetic::kDouble;
  architecture.traverse.fraction_bits = format.fraction_bits;
  architecture.traverse.direction_bits = format.direction_bits;
  architecture.traverse.mantissa_bits = format.mantissa_bits;
  architecture.traverse.tile_bits = format.tile_bits;
  truth_ = run_functional(work_, architecture).hits;
}

double HitJudge::time_of(const HitRecord& hit, Arithmetic arithmetic) const {
  const double unit = DoubleArithmetic::format(work_.map, format_).unit_of_time;
  switch (arithmetic) {
    case Arithmetic::kFloat:
      return static_cast<double>(std::bit_cast<float>(static_cast<uint32_t>(hit.t))) / unit;
    case Arithmetic::kDouble:
      return std::bit_cast<double>(hit.t) / unit;
    case Arithmetic::kFixed:
      break;
  }
  return static_cast<double>(hit.t);
}

Judgement HitJudge::judge(std::span<const HitRecord> hits, Arithmetic arithmetic) const {
  const Pyramid& pyramid = *work_.pyramid;
  OracleMap map;
  map.values = pyramid.level(0);
  map.width = pyramid.width(0);
  map.height = pyramid.height(0);
  map.highest = pyramid.highest();
  map.shape = work_.map;
  const double unit = DoubleArithmetic::format(work_.map, format_).unit_of_time;

  Judgement judgement;
  judgement.verdicts.reserve(hits.size());
  for (size_t k = 0; k < hits.size(); ++k) {
    const HitRecord& hit = hits[k];
    const MachineRay& ray = work_.rays[k];
    const bool is_hit = hit.status == HitStatus::kHit;
    Verdict verdict = Verdict::kExact;
    if (!same_answer(hit, truth_[k])) {
      const ExactRay<Int128> exact = exact_ray(ray, work_.map, format_, OracleInput::kMachineInput);
      verdict = cuesta::judge(exact, map, oracle_leaf_walk(exact, map),
                              {is_hit, hit.i, hit.j, is_hit ? time_of(hit, arithmetic) : 0.0});
    }
    judgement.verdicts.push_back(verdict);
    judgement.counts.add(verdict);
    if (!is_hit || truth_[k].status != HitStatus::kHit) continue;
    const double apart = std::abs(time_of(hit, arithmetic) - time_of(truth_[k], Arithmetic::kDouble)) * unit;
    const auto dx = static_cast<double>(ray.dx), dy = static_cast<double>(ray.dy);
    judgement.height_errors.push_back(apart * std::abs(static_cast<double>(ray.dz)));
    judgement.texel_errors.push_back(apart * std::sqrt(dx * dx + dy * dy));
  }
  return judgement;
}

}  // namespace cuesta
