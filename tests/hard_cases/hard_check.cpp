#include "tests/hard_cases/hard_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "models/oracle/bilinear_oracle.h"
#include "models/oracle/checked_walks.h"
#include "models/rays/hit_time.h"
#include "models/rays/map_shape.h"
#include "models/search/search_walk.h"
#include "models/traversal/bilinear.h"

namespace cuesta {
namespace {

constexpr int64_t kCombinationsEvery = 17;  ///< rays
constexpr int64_t kBruteEvery = 4;
constexpr int64_t kBilinearOracleEvery = 8;
constexpr uint64_t kMostPatchesAsked = 500;  ///< by the bilinear oracle

std::string named(std::string_view algorithm, Arithmetic arithmetic) {
  return std::string(algorithm) + " " + std::string(kArithmeticNames[static_cast<size_t>(arithmetic)]);
}

struct Nobody {
  void node(int, int, int) {}
  void patch(const PatchCorners&) {}
  void read(uint64_t) {}
  void compute() {}
  void end_step() {}
};

HitRecord given_up() {
  HitRecord record;
  record.status = HitStatus::kDidNotFinish;
  return record;
}

JudgedAnswer to_judge(const HitRecord& found, Arithmetic arithmetic, const MapShape& shape,
                      const NumberFormat& format) {
  const bool hit = found.status == HitStatus::kHit;
  long double t = hit ? static_cast<long double>(recorded_time(found, arithmetic)) : 0;
  if (arithmetic != Arithmetic::kFixed) t /= DoubleArithmetic::format(shape, format).unit_of_time;
  return {hit, found.i, found.j, t};
}

}  // namespace

HardChecker::HardChecker(HeightGrid grid, AddressMode mode, const NumberFormat& format, bool with_searches)
    : grid_(std::move(grid)), format_(format), pyramid_(build_max_pyramid(grid_)) {
  shape_ = {grid_.width, grid_.height, pyramid_.root_level(), grid_.bits, mode};
  most_steps_ = most_steps(shape_, format_);
  for (const Algorithm& algorithm : cuesta::algorithms()) algorithms_.push_back(algorithm);
  for (const Algorithm& part : algorithm_parts()) algorithms_.push_back(part);
  combinations_ = checked_schedules(true, 0);
  leaves_.resize(static_cast<size_t>(shape_.root_level) + 1);
  if (!with_searches) return;
  for (const SearchRow& row : search_rows()) {
    if (is_printed(row.search.kind)) continue;  // faults and all
    searches_.push_back(row.search);
    search_maps_.emplace_back(row.search, pyramid_, mode);
  }
}

const HardChecker::Leaves& HardChecker::leaves(int stop_level) {
  Leaves& here = leaves_[static_cast<size_t>(stop_level)];
  if (here.oracle.values != nullptr) return here;
  if (stop_level == 0) {
    here.oracle = oracle_map(grid_, shape_);
    here.pyramid = &pyramid_;
    return here;
  }
  here.stopped = build_stopped_pyramid(pyramid_, stop_level);
  here.pyramid = &here.stopped;
  const Pyramid means = build_mean_pyramid(grid_);
  const int width = means.width(stop_level), height = means.height(stop_level);
  here.means.assign(means.level(stop_level), means.level(stop_level) + ptrdiff_t{width} * height);
  here.oracle = oracle_map(here.means.data(), width, height, stop_level, shape_);
  here.oracle.highest = pyramid_.highest();
  return here;
}

HitRecord HardChecker::walk(Arithmetic arithmetic, const Schedule& schedule, const Pyramid& pyramid,
                            const MachineRay& ray) const {
  return with_traversal_types(arithmetic, shape_, [&]<class A, class G>() {
    const Walk<A, G> walk(shape_, format_, schedule, pyramid.highest());
    RayState<A, G> state;
    Visit now = start(walk, ray, state);
    while (now == Visit::kContinue) {
      const int i = static_cast<int>(state.gx.fetch_index(walk.x, state.level));
      const int j = static_cast<int>(state.gy.fetch_index(walk.y, state.level));
      now = visit(walk, state, pyramid.at(state.level, i, j));
      if (state.steps > most_steps_) return given_up();
    }
    return hit_record(walk, state, ray.id, now);
  });
}

void HardChecker::fail(HardCounts& counts, const TracedRay& ray, const std::string& what,
                       const HitRecord& expected, const HitRecord& found) const {
  if (!counts.first_failure.empty()) return;
  counts.first_failure =
      what + "\n  " + std::to_string(grid_.width) + " x " + std::to_string(grid_.height) + ", " +
      std::to_string(grid_.bits) + " bits, " + std::string(name_of(shape_.address_mode)) + "; f " +
      std::to_string(format_.fraction_bits) + ", D " + std::to_string(format_.direction_bits) + ", M " +
      std::to_string(format_.mantissa_bits) + ", w2 " + std::to_string(format_.tile_bits) + "\n  " +
      describe(ray) + "\n  expected: " + describe(expected) + "\n  found:    " + describe(found);
}

void HardChecker::count(const std::string& name, const HitRecord& found, Arithmetic arithmetic,
                        const TracedRay& ray, HardCounts& counts, const Verdict* verdict) const {
  HardRow& row = counts.rows[name];
  const bool hit = found.status == HitStatus::kHit;
  ++row.runs;
  ++counts.runs;
  ++(hit ? row.hits : row.misses);
  ++(hit ? counts.hits : counts.misses);
  row.steps += found.steps;
  if (verdict != nullptr) row.verdicts.add(*verdict);
  if (found.status == HitStatus::kDidNotFinish) {
    ++counts.hangs;
    fail(counts, ray, name + " takes more steps than any walk can need", {}, found);
  }
  if (!hit) return;
  const double t = recorded_time(found, arithmetic);
  if (!(t >= 0) || std::isinf(t)) {
    ++counts.not_numbers;
    fail(counts, ray, name + " ends at a time that is not finite", {}, found);
  }
}

void HardChecker::check_exact(const TracedRay& traced, int stop_level, HardCounts& counts) {
  const MachineRay ray = quantise(traced, shape_, format_);
  const Leaves& surface = leaves(stop_level);
  const auto set_up = exact_ray(ray, shape_, format_, OracleInput::kSetup);
  const auto quantised = exact_ray(ray, shape_, format_, OracleInput::kMachineInput);
  const auto truth = oracle_leaf_walk(quantised, surface.oracle);
  const bool all = asked_++ % kCombinationsEvery == kCombinationsEvery / 2 && stop_level == 0;
  for (const Arithmetic arithmetic : {Arithmetic::kFixed, Arithmetic::kFloat, Arithmetic::kDouble}) {
    HitRecord plain;
    Verdict verdict = Verdict::kExact;
    const auto held = [&](const std::string& name, Schedule schedule, bool first) {
      schedule.stop_level = stop_level;
      const HitRecord found = walk(arithmetic, schedule, *surface.pyramid, ray);
      if (first) {
        plain = found;
        verdict = judge(quantised, surface.oracle, truth, to_judge(found, arithmetic, shape_, format_));
      } else if (!same_answer(found, plain)) {
        ++counts.differences;
        fail(counts, traced, named(name, arithmetic) + " differs from the leaf walk", plain, found);
      }
      count(named(name, arithmetic), found, arithmetic, traced, counts, &verdict);
    };
    for (size_t a = 0; a < algorithms_.size(); ++a) held(algorithms_[a].id, algorithms_[a].schedule, a == 0);
    if (all)
      for (const Schedule& schedule : combinations_) held("every combination", schedule, false);
    if (arithmetic != Arithmetic::kFixed) continue;
    const auto hold = [&](const OracleHit<Int128>& exact, const char* who) {
      const HitRecord expected = to_record(exact, ray.id, stop_level);
      if (same_answer(plain, expected)) return;
      ++counts.inexact;
      fail(counts, traced, std::string("fixed point is not exact: ") + who, expected, plain);
    };
    hold(oracle_leaf_walk(set_up, surface.oracle), "leaf walk");
    if (asked_ % kBruteEvery != 0) continue;
    if (const auto brute = oracle_brute_force(set_up, surface.oracle, 1 << 12)) hold(*brute, "brute force");
  }
}

void HardChecker::check_searches(const TracedRay& traced, HardCounts& counts) {
  const MachineRay ray = quantise(traced, shape_, format_);
  const OracleMap& surface = leaves(0).oracle;
  const auto exact = exact_ray(ray, shape_, format_, OracleInput::kMachineInput);
  const auto truth = oracle_leaf_walk(exact, surface);
  const Schedule leaf_walk = find_algorithm("dda")->schedule;
  const auto run = [&]<class Real>(Arithmetic times, const HitRecord& walked) {
    for (size_t k = 0; k < searches_.size(); ++k) {
      for (const SearchFilter filter : {SearchFilter::kTexel, SearchFilter::kBilinear}) {
        Search search = searches_[k];
        search.filter = filter;
        const Searcher<Real> searcher(search, search_maps_[k], shape_, format_, 0.1);
        Nobody nobody;
        const HitRecord found = searcher.trace(ray, times, nobody);
        const std::string name = named(cuesta::name_of(search), times);
        if (filter == SearchFilter::kBilinear) {  // another surface: no truth of constant texels
          count(name, found, times, traced, counts);
        } else {
          const Verdict verdict = judge(exact, surface, truth, to_judge(found, times, shape_, format_));
          count(name, found, times, traced, counts, &verdict);
        }
        if (found.steps > static_cast<uint32_t>(2 + search.steps + search.refinements)) {
          ++counts.hangs;
          fail(counts, traced, name + " takes more steps than it has", {}, found);
        }
        const bool guarded = search.kind == SearchKind::kCone || search.kind == SearchKind::kSafetyRadius;
        if (!guarded || filter != SearchFilter::kTexel || times == Arithmetic::kFixed) continue;
        // Never later than the exact walk in the same arithmetic, nor without a hit that the walk has.
        if (walked.status != HitStatus::kHit) continue;
        if (found.status == HitStatus::kHit && recorded_time(found, times) <= recorded_time(walked, times))
          continue;
        ++counts.broken;
        fail(counts, traced, name + " is later than the surface", walked, found);
      }
    }
  };
  run.template operator()<float>(Arithmetic::kFixed, {});
  run.template operator()<float>(Arithmetic::kFloat, walk(Arithmetic::kFloat, leaf_walk, pyramid_, ray));
  run.template operator()<double>(Arithmetic::kDouble, walk(Arithmetic::kDouble, leaf_walk, pyramid_, ray));
}

void HardChecker::check_bilinear(const TracedRay& traced, HardCounts& counts) {
  if (shape_.address_mode == AddressMode::kMirror || format_.fraction_bits < 1) return;
  MapShape shape = shape_;
  shape.surface = Surface::kBilinear;
  const MachineRay ray = quantise(traced, shape, format_);
  ++asked_;
  if (corners_.empty()) {
    corners_.push_back(
        build_four_corner_pyramid(build_max_pyramid(grid_), shape_.address_mode == AddressMode::kWrap));
  }
  const Pyramid& pyramid = corners_.front();
  for (const Arithmetic arithmetic : {Arithmetic::kFloat, Arithmetic::kDouble}) {
    HitRecord plain;
    for (size_t a = 0; a < algorithms_.size(); ++a) {
      const HitRecord found = with_bilinear_types(arithmetic, shape, [&]<class A, class G>() {
        const Walk<A, G> walk(shape, format_, algorithms_[a].schedule, pyramid.highest());
        BilinearState<A, G> state;
        Nobody nobody;
        Visit now = start_bilinear(walk, ray, state);
        while (now == Visit::kContinue) {
          now = step_bilinear(walk, pyramid, state, nobody);
          if (state.ray.steps > most_steps_) return given_up();
        }
        return hit_record(walk, state.ray, ray.id, now);
      });
      const std::string name = named(algorithms_[a].id + " bilinear", arithmetic);
      if (a == 0) {
        plain = found;
      } else if (!same_answer(found, plain)) {
        ++counts.differences;
        fail(counts, traced, name + " differs from the leaf walk", plain, found);
      }
      if (a != 0 || asked_ % kBilinearOracleEvery != 0 || found.steps > kMostPatchesAsked) {
        count(name, found, arithmetic, traced, counts);
        continue;
      }
      const BilinearOracle oracle(ray, grid_, shape, format_);
      const BilinearHit truth = oracle.walk(60);
      const bool hit = found.status == HitStatus::kHit;
      const bool right = hit == truth.hit && (!hit || (found.i == truth.i && found.j == truth.j));
      const Verdict verdict = right                                  ? Verdict::kExact
                              : oracle.is_tie(hit, found.i, found.j) ? Verdict::kTie
                              : !hit                                 ? Verdict::kMissed
                                                                     : Verdict::kWrongCell;
      count(name, found, arithmetic, traced, counts, &verdict);
    }
  }
}

std::string describe(const HardCounts& counts) {
  char line[256];
  std::snprintf(
      line, sizeof line,
      "%lld cases, %lld rays, %lld refused; %lld runs: %lld hits, %lld misses; %lld hangs, %lld not "
      "numbers, %lld differences, %lld inexact, %lld broken guarantees\n",
      static_cast<long long>(counts.cases), static_cast<long long>(counts.rays),
      static_cast<long long>(counts.refused), static_cast<long long>(counts.runs),
      static_cast<long long>(counts.hits), static_cast<long long>(counts.misses),
      static_cast<long long>(counts.hangs), static_cast<long long>(counts.not_numbers),
      static_cast<long long>(counts.differences), static_cast<long long>(counts.inexact),
      static_cast<long long>(counts.broken));
  std::string text = line;
  std::snprintf(line, sizeof line, "%-34s %9s %9s %9s %9s %9s %7s %7s %7s %7s\n", "", "runs", "hits",
                "misses", "steps", "exact", "tie", "missed", "behind", "wrong");
  text += line;
  for (const auto& [name, row] : counts.rows) {
    const auto verdicts = [&](Verdict v) { return static_cast<long long>(row.verdicts.count(v)); };
    std::snprintf(line, sizeof line, "%-34s %9lld %9lld %9lld %9.1f %9lld %7lld %7lld %7lld %7lld\n",
                  name.c_str(), static_cast<long long>(row.runs), static_cast<long long>(row.hits),
                  static_cast<long long>(row.misses),
                  static_cast<double>(row.steps) / static_cast<double>(std::max<int64_t>(1, row.runs)),
                  verdicts(Verdict::kExact), verdicts(Verdict::kTie), verdicts(Verdict::kMissed),
                  verdicts(Verdict::kBehind), verdicts(Verdict::kWrongCell));
    text += line;
  }
  return text;
}

}  // namespace cuesta
