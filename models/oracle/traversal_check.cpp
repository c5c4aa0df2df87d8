#include "models/oracle/traversal_check.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <vector>

#include "models/common/error.h"
#include "models/heightmap/pyramid.h"
#include "models/oracle/schedule_walk.h"
#include "models/traversal/lanes.h"
#include "models/traversal/traversal.h"

namespace cuesta {
namespace {

constexpr std::array<std::string_view, 3> kArithmeticNames = {"fixed", "float", "double"};

std::string describe(const HitRecord& r) {
  if (r.status == HitStatus::kDidNotFinish) return "did not finish";
  if (r.status != HitStatus::kHit) return "miss, " + std::to_string(r.steps) + " steps";
  constexpr std::array<std::string_view, 5> kFaces = {"none", "top", "wall x", "wall y", "inside"};
  return "hit (" + std::to_string(r.i) + ", " + std::to_string(r.j) + "), t " + std::to_string(r.t) + ", " +
         std::string(kFaces[static_cast<size_t>(r.face)]) + ", " + std::to_string(r.steps) + " steps";
}

std::string describe(const Schedule& s) {
  return "start " + std::string(name_of(s.start)) + ", down " + std::string(name_of_down(s.down)) + ", up " +
         std::string(name_of(s.up)) + ", stop " + std::to_string(s.stop_level);
}

/// Hit, cell, t and face; not the steps.
bool same_answer(const HitRecord& a, const HitRecord& b) {
  return a.status == b.status && a.i == b.i && a.j == b.j && a.t == b.t && a.face == b.face;
}

std::vector<Schedule> schedules(const TraversalCheckOptions& options) {
  std::vector<Schedule> list;
  for (const Algorithm& algorithm : algorithms()) list.push_back(algorithm.schedule);
  if (options.all_combinations) {
    for (int start = 0; start < 3; ++start) {
      for (const int down : down_values()) {
        for (int up = 0; up < 8; ++up) {
          list.push_back({static_cast<StartRule>(start), down, static_cast<UpRule>(up), 0});
        }
      }
    }
  }
  for (Schedule& schedule : list) schedule.stop_level = options.stop_level;
  return list;
}

/// The machine's time as machine units, for judging only.
long double machine_time(const HitRecord& record, Arithmetic arithmetic, const NumberFormat& format) {
  const int shift = format.fraction_bits + format.direction_bits - 1 + format.mantissa_bits;
  switch (arithmetic) {
    case Arithmetic::kFixed:
      break;
    case Arithmetic::kFloat:
      return std::ldexp(std::bit_cast<float>(static_cast<uint32_t>(record.t)), shift);
    case Arithmetic::kDouble:
      return std::ldexp(std::bit_cast<double>(record.t), shift);
  }
  return static_cast<long double>(record.t);
}

/// Every second step at least is a crossing, but for descents, of which each level above the leaves is repaid by
/// an ascent; crossings are as many as there are planes in 2^w2 tiles.
int64_t most_steps(const RandomMap& map) {
  const int64_t planes = int64_t{map.shape.width} + map.shape.height;
  return 4 * (planes << map.format.tile_bits) + 4 * map.shape.root_level + 64;
}

template <class A, class G>
HitRecord limited_walk(const RandomMap& map, const Schedule& schedule, const Pyramid& bounds,
                       const Pyramid& leaves, const MachineRay& input) {
  const Walk<A, G> walk(map.shape, map.format, schedule, bounds.at(bounds.root_level(), 0, 0));
  RayState<A, G> ray;
  const int64_t limit = most_steps(map);
  Visit state = start(walk, input, ray);
  while (state == Visit::kContinue) {
    const Pyramid& pyramid = ray.level == schedule.stop_level ? leaves : bounds;
    state = visit(walk, ray,
                  pyramid.at(ray.level, static_cast<int>(ray.gx.fetch_index(walk.x, ray.level)),
                             static_cast<int>(ray.gy.fetch_index(walk.y, ray.level))));
    if (ray.steps > limit) {
      HitRecord record;
      record.status = HitStatus::kDidNotFinish;
      return record;
    }
  }
  return hit_record(walk, ray, input.id, state);
}

}  // namespace

struct TraversalChecker::State {
  RandomMap map;
  TraversalCheckOptions options;
  Pyramid max_pyramid, leaves;
  OracleMap oracle;
  std::vector<Schedule> schedules;
  std::vector<HitRecord> fixed;  ///< by schedule, of the ray at hand
  std::vector<TracedRay> traced_rays;
  std::vector<MachineRay> rays;
  std::vector<std::vector<HitRecord>> records;  ///< by schedule and ray: fixed, one ray at a time

  HitRecord walk(Arithmetic arithmetic, const Schedule& schedule, const MachineRay& ray) const {
    return with_traversal_types(arithmetic, map.shape, [&]<class A, class G>() {
      return limited_walk<A, G>(map, schedule, max_pyramid, leaves, ray);
    });
  }

  void fail(TraversalCheck& counts, const TracedRay& traced, const MachineRay& ray, const std::string& what,
            const HitRecord& expected, const HitRecord& found) const {
    if (!counts.first_failure.empty()) return;
    counts.first_failure = what + "\n  " + describe(map) + "\n  " + describe(traced) +
                           "\n  machine ray: " + describe(ray) + "\n  expected: " + describe(expected) +
                           "\n  found:    " + describe(found);
  }

  void check_schedules(const TracedRay& traced, const MachineRay& ray, TraversalCheck& counts);
  void check_oracle(const TracedRay& traced, const MachineRay& ray, TraversalCheck& counts) const;
  void check_steps(const TracedRay& traced, const MachineRay& ray, TraversalCheck& counts) const;
  void judge_all(const TracedRay& traced, const MachineRay& ray, TraversalCheck& counts) const;
};

TraversalChecker::TraversalChecker(const RandomMap& map, const TraversalCheckOptions& options)
    : state_(
          new State{map, options, build_max_pyramid(map.grid), {}, {}, schedules(options), {}, {}, {}, {}}) {
  State& s = *state_;
  s.leaves = options.stop_level > 0 ? build_mean_pyramid(map.grid) : s.max_pyramid;
  const int level = options.stop_level;
  s.oracle =
      oracle_map(s.leaves.level(level), s.leaves.width(level), s.leaves.height(level), level, map.shape);
  s.oracle.highest = oracle_map(map.grid, map.shape).highest;
}

TraversalChecker::~TraversalChecker() { delete state_; }

void TraversalChecker::State::check_schedules(const TracedRay& traced, const MachineRay& ray,
                                              TraversalCheck& counts) {
  for (size_t a = 0; a < 3; ++a) {
    HitRecord plain;
    for (size_t s = 0; s < schedules.size(); ++s) {
      const HitRecord found = walk(static_cast<Arithmetic>(a), schedules[s], ray);
      if (a == 0) fixed[s] = found;
      if (found.status == HitStatus::kDidNotFinish) ++counts.endless;
      if (s == 0) {
        plain = found;
        if (found.status != HitStatus::kDidNotFinish) continue;
      }
      ++counts.comparisons;
      if (same_answer(found, plain) && found.status != HitStatus::kDidNotFinish) continue;
      ++counts.mismatches;
      fail(counts, traced, ray,
           std::string(kArithmeticNames[a]) + ", " + describe(schedules[s]) +
               ": another answer than the leaf walk's",
           plain, found);
    }
  }
}

void TraversalChecker::State::check_oracle(const TracedRay& traced, const MachineRay& ray,
                                           TraversalCheck& counts) const {
  const auto exact = exact_ray(ray, map.shape, map.format, OracleInput::kSetup);
  const auto walked = oracle_leaf_walk(exact, oracle);
  HitRecord expected = to_record(walked, ray.id, options.stop_level);
  ++counts.oracle_walks;
  if (!same_answer(fixed[0], expected) || fixed[0].steps != expected.steps) {
    ++counts.oracle_errors;
    fail(counts, traced, ray, "fixed, leaf walk: another answer than the exact leaf walk's", expected,
         fixed[0]);
  }
  if (const auto brute = oracle_brute_force(exact, oracle)) {
    ++counts.oracle_brute;
    expected = to_record(*brute, ray.id, options.stop_level);
    if (!same_answer(fixed[0], expected)) {
      ++counts.oracle_errors;
      fail(counts, traced, ray, "fixed, leaf walk: another answer than brute force over all cells", expected,
           fixed[0]);
    }
  }
}

void TraversalChecker::State::check_steps(const TracedRay& traced, const MachineRay& ray,
                                          TraversalCheck& counts) const {
  OracleScheduleWalk<Int128> exact(exact_ray(ray, map.shape, map.format, OracleInput::kSetup), map.grid,
                                   oracle);
  const int64_t t_end = (int64_t{1} << time_bits(map.shape, map.format)) - 1;
  for (size_t s = 0; s < schedules.size(); ++s) {
    // Saturated, every far plane lies at t_end: the span of a ray without end is not defined by exact times.
    const bool looks_ahead = schedules[s].start == StartRule::kSpan || schedules[s].down == kDownCommon;
    if (looks_ahead && ray.t_max == t_end) continue;
    const HitRecord expected = to_record(exact.walk(schedules[s]), ray.id, options.stop_level);
    ++counts.step_comparisons;
    if (same_answer(fixed[s], expected) && fixed[s].steps == expected.steps) continue;
    ++counts.step_errors;
    fail(counts, traced, ray,
         "fixed, " + describe(schedules[s]) + ": other steps than the same schedule walked exactly", expected,
         fixed[s]);
  }
}

void TraversalChecker::State::judge_all(const TracedRay& traced, const MachineRay& ray,
                                        TraversalCheck& counts) const {
  const auto exact = exact_ray(ray, map.shape, map.format, OracleInput::kMachineInput);
  const auto truth = oracle_leaf_walk(exact, oracle);
  for (size_t a = 0; a < 3; ++a) {
    const auto arithmetic = static_cast<Arithmetic>(a);
    const HitRecord found = a == 0 ? fixed[0] : walk(arithmetic, schedules[0], ray);
    const JudgedAnswer answer{found.status == HitStatus::kHit, found.i, found.j,
                              machine_time(found, arithmetic, map.format)};
    const Verdict verdict = judge(exact, oracle, truth, answer);
    counts.verdicts[a].add(verdict);
    if (verdict == Verdict::kExact && truth.hit && truth.face != found.face) ++counts.other_face[a];
    if (verdict == Verdict::kExact || verdict == Verdict::kTie || !counts.first_other[a].empty()) continue;
    counts.first_other[a] =
        std::string(name_of(verdict)) + "\n  " + describe(map) + "\n  " + describe(traced) +
        "\n  machine ray: " + describe(ray) + "\n  exact: " +
        (truth.hit ? "hit (" + std::to_string(truth.i) + ", " + std::to_string(truth.j) + ")" : "miss") +
        "\n  found: " + describe(found);
  }
}

void TraversalChecker::check(const TracedRay& traced, TraversalCheck& counts) {
  State& s = *state_;
  const MachineRay ray = quantise(traced, s.map.shape, s.map.format);
  s.fixed.resize(s.schedules.size());
  s.check_schedules(traced, ray, counts);
  s.check_oracle(traced, ray, counts);
  const bool steps = s.options.step_check_every > 0;
  if (steps && counts.rays % s.options.step_check_every == 0) s.check_steps(traced, ray, counts);
  if (s.options.verdicts) s.judge_all(traced, ray, counts);
  s.traced_rays.push_back(traced);
  s.rays.push_back(ray);
  s.records.resize(s.schedules.size());
  for (size_t k = 0; k < s.schedules.size(); ++k) s.records[k].push_back(s.fixed[k]);
  ++counts.rays;
  if (s.fixed[0].status == HitStatus::kHit) ++counts.hits;
}

void TraversalChecker::check_lanes(TraversalCheck& counts) const {
  const State& s = *state_;
  if (!s.map.shape.is_square_power_of_two() || s.options.stop_level > 0 || s.rays.empty()) return;
  std::vector<HitRecord> found(s.rays.size());
  for (size_t k = 0; k < s.schedules.size(); ++k) {
    const Pyramid& pyramid = s.max_pyramid;
    const Walk<FixedArithmetic, PlainAxis> walk(s.map.shape, s.map.format, s.schedules[k],
                                                pyramid.at(pyramid.root_level(), 0, 0));
    if (!lanes_can(walk)) return;
    traverse_lanes(walk, pyramid, s.rays, {}, found, nullptr);
    for (size_t r = 0; r < found.size(); ++r) {
      ++counts.lane_comparisons;
      if (found[r] == s.records[k][r]) continue;
      ++counts.lane_errors;
      s.fail(counts, s.traced_rays[r], s.rays[r],
             "fixed, " + describe(s.schedules[k]) + ": many rays at a time differ from one at a time",
             s.records[k][r], found[r]);
    }
  }
}

void TraversalCheck::add(const TraversalCheck& other) {
  maps += other.maps;
  rays += other.rays;
  hits += other.hits;
  comparisons += other.comparisons;
  mismatches += other.mismatches;
  endless += other.endless;
  oracle_walks += other.oracle_walks;
  oracle_brute += other.oracle_brute;
  oracle_errors += other.oracle_errors;
  step_comparisons += other.step_comparisons;
  step_errors += other.step_errors;
  lane_comparisons += other.lane_comparisons;
  lane_errors += other.lane_errors;
  for (size_t a = 0; a < 3; ++a) {
    for (size_t v = 0; v < kVerdicts; ++v) verdicts[a].of[v] += other.verdicts[a].of[v];
    other_face[a] += other.other_face[a];
    if (first_other[a].empty()) first_other[a] = other.first_other[a];
  }
  if (first_failure.empty()) first_failure = other.first_failure;
}

TraversalCheck check_random_traversals(uint64_t seed, int64_t rays, int max_side, int rays_per_map,
                                       const TraversalCheckOptions& options) {
  TraversalCheck counts;
  Random random(seed);
  while (counts.rays < rays) {
    const RandomMap map = random_map(random.next(), max_side);
    TraversalCheckOptions here = options;
    if (random.chance(0.15)) here.stop_level = static_cast<int>(random.between(0, map.shape.root_level));
    // Verdicts speak of the machine's precision, not of reciprocals of 2 bits.
    here.verdicts = options.verdicts && here.stop_level == 0 && map.format.direction_bits == 32 &&
                    map.format.fraction_bits == 8 && map.format.mantissa_bits == map.grid.bits + 4;
    TraversalChecker checker(map, here);
    ++counts.maps;
    for (int r = 0; r < rays_per_map && counts.rays < rays; ++r) {
      const TracedRay ray = random_ray(random, map, static_cast<uint64_t>(counts.rays));
      try {
        checker.check(ray, counts);
      } catch (const Error&) {
        // An origin outside the tiles that this format can hold: refused, as it should be.
      }
    }
    checker.check_lanes(counts);
  }
  return counts;
}

}  // namespace cuesta
