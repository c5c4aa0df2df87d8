#include "models/oracle/traversal_check.h"

#include <algorithm>
#include <vector>

#include "models/common/error.h"
#include "models/heightmap/pyramid.h"
#include "models/oracle/checked_walks.h"
#include "models/oracle/schedule_walk.h"
#include "models/rays/map_shape.h"
#include "models/traversal/fetch.h"
#include "models/traversal/lanes.h"
#include "models/traversal/traversal.h"

namespace cuesta {
namespace {

constexpr size_t kQuadEvery = 7;  // schedules: one in so many is walked again through kept siblings

/// Heights through the siblings that a ray keeps: read when they are fetched, and only then.
class QuadReader {
 public:
  int64_t read(const Pyramid& pyramid, int level, int i, int j) {
    if (kept_.fetches(level, i, j)) {
      const Quad quad = Quad::of(pyramid, level, i, j);
      values_.fill(-1);
      for (int y = 0; y < quad.height; ++y) {
        for (int x = 0; x < quad.width; ++x) values_[place(x, y)] = pyramid.at(level, quad.i + x, quad.j + y);
      }
    }
    return values_[place(i, j)];
  }

 private:
  static size_t place(int i, int j) { return static_cast<size_t>(i & 1) + 2 * static_cast<size_t>(j & 1); }
  KeptQuad kept_;
  std::array<int64_t, 4> values_{};
};

template <class A, class G>
HitRecord limited_walk(const RandomMap& map, const Schedule& schedule, const Pyramid& pyramid,
                       const MachineRay& input) {
  const Walk<A, G> walk(map.shape, map.format, schedule, pyramid.highest());
  const bool quads = schedule.fetch == FetchRule::kQuad;
  QuadReader reader;
  RayState<A, G> ray;
  const int64_t limit = most_steps(map.shape, map.format);
  Visit state = start(walk, input, ray);
  while (state == Visit::kContinue) {
    const int i = static_cast<int>(ray.gx.fetch_index(walk.x, ray.level));
    const int j = static_cast<int>(ray.gy.fetch_index(walk.y, ray.level));
    state = visit(walk, ray, quads ? reader.read(pyramid, ray.level, i, j) : pyramid.at(ray.level, i, j));
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
  Pyramid pyramid;  ///< stopped at the options' level
  OracleMap oracle;
  std::vector<Schedule> schedules;
  std::vector<uint16_t> means;   ///< of the oracle
  std::vector<HitRecord> fixed;  ///< by schedule, of the ray at hand
  std::vector<TracedRay> traced_rays;
  std::vector<MachineRay> rays;
  std::vector<std::vector<HitRecord>> records;  ///< by schedule and ray: fixed, one ray at a time

  HitRecord walk(Arithmetic arithmetic, const Schedule& schedule, const MachineRay& ray) const {
    return with_traversal_types(arithmetic, map.shape, [&]<class A, class G>() {
      return limited_walk<A, G>(map, schedule, pyramid, ray);
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
};

TraversalChecker::TraversalChecker(const RandomMap& map, const TraversalCheckOptions& options)
    : state_(new State{map,
                       options,
                       build_stopped_pyramid(build_max_pyramid(map.grid), options.stop_level),
                       {},
                       checked_schedules(options.all_combinations, options.stop_level),
                       {},
                       {},
                       {},
                       {},
                       {}}) {
  State& s = *state_;
  const int level = options.stop_level;
  const Pyramid means = build_mean_pyramid(map.grid);  // the pyramid's own at this level, made otherwise
  s.means.assign(means.level(level),
                 means.level(level) + static_cast<ptrdiff_t>(means.width(level)) * means.height(level));
  s.oracle = oracle_map(s.means.data(), means.width(level), means.height(level), level, map.shape);
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
      if ((static_cast<size_t>(counts.rays) + s) % kQuadEvery == 0) {
        Schedule with_quads = schedules[s];
        with_quads.fetch = FetchRule::kQuad;
        const HitRecord again = walk(static_cast<Arithmetic>(a), with_quads, ray);
        ++counts.quad_comparisons;
        if (!(again == found)) {
          ++counts.quad_errors;
          fail(counts, traced, ray,
               std::string(kArithmeticNames[a]) + ", " + describe(schedules[s]) +
                   ": other steps or hits through kept siblings",
               found, again);
        }
      }
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

void TraversalChecker::check(const TracedRay& traced, TraversalCheck& counts) {
  State& s = *state_;
  const MachineRay ray = quantise(traced, s.map.shape, s.map.format);
  s.fixed.resize(s.schedules.size());
  s.check_schedules(traced, ray, counts);
  s.check_oracle(traced, ray, counts);
  const bool steps = s.options.step_check_every > 0;
  if (steps && counts.rays % s.options.step_check_every == 0) s.check_steps(traced, ray, counts);
  s.traced_rays.push_back(traced);
  s.rays.push_back(ray);
  s.records.resize(s.schedules.size());
  for (size_t k = 0; k < s.schedules.size(); ++k) s.records[k].push_back(s.fixed[k]);
  ++counts.rays;
  const auto mode = static_cast<size_t>(s.map.shape.address_mode);
  ++counts.rays_by_mode[mode];
  if (s.options.stop_level > 0) ++counts.stopped_by_mode[mode];
  if (s.fixed[0].status == HitStatus::kHit) ++counts.hits;
}

void TraversalChecker::check_lanes(TraversalCheck& counts) const {
  const State& s = *state_;
  if (!s.map.shape.is_square_power_of_two() || s.rays.empty()) return;
  std::vector<HitRecord> found(s.rays.size());
  for (size_t k = 0; k < s.schedules.size(); ++k) {
    const Walk<FixedArithmetic, PlainAxis> walk(s.map.shape, s.map.format, s.schedules[k],
                                                s.pyramid.highest());
    if (!lanes_can(walk)) continue;
    traverse_lanes(walk, s.pyramid, s.rays, {}, found, nullptr);
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
  quad_comparisons += other.quad_comparisons;
  quad_errors += other.quad_errors;
  for (size_t mode = 0; mode < rays_by_mode.size(); ++mode) {
    rays_by_mode[mode] += other.rays_by_mode[mode];
    stopped_by_mode[mode] += other.stopped_by_mode[mode];
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
    if (random.chance(0.25)) here.stop_level = static_cast<int>(random.between(0, map.shape.root_level));
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
