#include "models/work/hit_judge.h"

#include <algorithm>
#include <cmath>

#include "models/oracle/exact_ray.h"
#include "models/rays/hit_time.h"
#include "models/traversal/arithmetic.h"
#include "models/work/functional_run.h"

namespace cuesta {
namespace {

bool same_answer(const HitRecord& a, const HitRecord& b) {
  return a.status == b.status && (a.status != HitStatus::kHit || (a.i == b.i && a.j == b.j));
}

}  // namespace

int64_t in_error_parts(double error) {
  constexpr double kMost = 1e15;
  return std::llround(std::min(error * kErrorParts, kMost));
}

Histogram error_histogram(std::string name, std::span<const double> errors) {
  std::vector<int64_t> parts;
  parts.reserve(errors.size());
  for (const double error : errors) parts.push_back(in_error_parts(error));
  return make_histogram(std::move(name), std::move(parts));
}

HitJudge::HitJudge(const Workload& work) : work_(work) {
  work_.search.reset();
  work_.schedule = find_algorithm("yun2013")->schedule;
  work_.arithmetic = Arithmetic::kDouble;
  const Pyramid& pyramid = *work_.pyramid;
  map_.values = pyramid.level(0);
  map_.width = pyramid.width(0);
  map_.height = pyramid.height(0);
  map_.highest = pyramid.highest();
  map_.shape = work_.map;
  exact_.resize(work_.rays.size());
  truth_ = run_functional(work_).hits;
}

double HitJudge::time_of(const HitRecord& hit, Arithmetic arithmetic) const {
  const double unit = DoubleArithmetic::format(work_.map, work_.format).unit_of_time;
  const double t = recorded_time(hit, arithmetic);
  return arithmetic == Arithmetic::kFixed ? t : t / unit;
}

double HitJudge::depth_of(size_t ray, const HitRecord& hit, Arithmetic arithmetic) const {
  if (hit.status != HitStatus::kHit) return 1;
  const MachineRay& input = work_.rays[ray];
  const double unit = DoubleArithmetic::format(work_.map, work_.format).unit_of_time;
  const double start =
      static_cast<double>(input.z0) / static_cast<double>(int64_t{1} << work_.format.fraction_bits);
  const double height = start + time_of(hit, arithmetic) * unit * static_cast<double>(input.dz);
  return 1 - height / static_cast<double>(work_.map.full_scale());
}

const OracleHit<Int128>& HitJudge::exact_hit(size_t ray, const ExactRay<Int128>& exact) {
  if (!exact_[ray]) exact_[ray] = oracle_leaf_walk(exact, map_);
  return *exact_[ray];
}

Judgement HitJudge::judge(std::span<const HitRecord> hits, Arithmetic arithmetic) {
  const double unit = DoubleArithmetic::format(work_.map, work_.format).unit_of_time;

  Judgement judgement;
  judgement.verdicts.reserve(hits.size());
  for (size_t k = 0; k < hits.size(); ++k) {
    const HitRecord& hit = hits[k];
    const MachineRay& ray = work_.rays[k];
    const bool is_hit = hit.status == HitStatus::kHit;
    if (hit.status == HitStatus::kNotANumber || hit.status == HitStatus::kDidNotFinish) {
      ++(hit.status == HitStatus::kNotANumber ? judgement.not_numbers : judgement.unfinished);
      judgement.verdicts.emplace_back();
      continue;
    }
    Verdict verdict = Verdict::kExact;
    if (!same_answer(hit, truth_[k])) {
      const ExactRay<Int128> exact = exact_ray(ray, work_.map, work_.format, OracleInput::kMachineInput);
      verdict = cuesta::judge(exact, map_, exact_hit(k, exact),
                              {is_hit, hit.i, hit.j, is_hit ? time_of(hit, arithmetic) : 0.0});
    }
    judgement.verdicts.emplace_back(verdict);
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
