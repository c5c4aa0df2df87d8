#include "sim/explore/adversary/adversary_score.h"

#include <array>
#include <cmath>

#include "models/oracle/checked_walks.h"
#include "models/oracle/oracle.h"
#include "models/oracle/verdict.h"
#include "models/rays/hit_time.h"
#include "models/rays/map_shape.h"
#include "models/traversal/arithmetic.h"
#include "models/traversal/traversal.h"
#include "models/work/functional_run.h"
#include "sim/config/on_architecture.h"

namespace cuesta {
namespace {

constexpr std::string_view kNames[] = {"steps", "cycles", "error"};
constexpr std::string_view kUnits[] = {"steps per ray", "cycles per ray",
                                       "slabs of height, mean over the rays"};

}  // namespace

std::span<const std::string_view> maximise_names() { return kNames; }
std::string_view unit_of(Maximise maximise) { return kUnits[static_cast<size_t>(maximise)]; }

/// A case as the machine takes it.
struct AdversaryScorer::Prepared {
  const HeightGrid& grid;
  Pyramid pyramid;
  MapShape shape;
  NumberFormat format;
  std::vector<MachineRay> rays;
  std::vector<uint32_t> pixels;
  int64_t most_steps = 0;  ///< that any walk can need
};

AdversaryScorer::AdversaryScorer(Algorithm algorithm, const Architecture& architecture, AddressMode mode,
                                 Maximise maximise)
    : algorithm_(std::move(algorithm)), architecture_(architecture), mode_(mode), maximise_(maximise) {}

AdversaryScorer::Prepared AdversaryScorer::prepare(const HeightGrid& grid,
                                                   std::span<const TracedRay> rays) const {
  Prepared prepared{grid, build_max_pyramid(grid), {}, {}, {}, {}, 0};
  prepared.shape = {grid.width, grid.height, prepared.pyramid.root_level(), grid.bits, mode_};
  prepared.format = number_format(architecture_.traverse, prepared.shape);
  prepared.most_steps = cuesta::most_steps(prepared.shape, prepared.format);
  for (const TracedRay& ray : rays) {
    prepared.rays.push_back(quantise(ray, prepared.shape, prepared.format));
    prepared.pixels.push_back(static_cast<uint32_t>(prepared.pixels.size()));
  }
  return prepared;
}

std::vector<HitRecord> AdversaryScorer::hits_of(const Schedule& schedule, Arithmetic arithmetic,
                                                const Prepared& prepared) const {
  std::vector<HitRecord> hits;
  hits.reserve(prepared.rays.size());
  with_traversal_types(arithmetic, prepared.shape, [&]<class A, class G>() {
    const Walk<A, G> walk(prepared.shape, prepared.format, schedule, prepared.pyramid.highest());
    for (const MachineRay& input : prepared.rays) {
      RayState<A, G> ray;
      Visit now = start(walk, input, ray);
      while (now == Visit::kContinue && int64_t{ray.steps} <= prepared.most_steps) {
        const int i = static_cast<int>(ray.gx.fetch_index(walk.x, ray.level));
        const int j = static_cast<int>(ray.gy.fetch_index(walk.y, ray.level));
        now = visit(walk, ray, prepared.pyramid.at(ray.level, i, j));
      }
      hits.push_back(hit_record(walk, ray, input.id, now));
      if (now == Visit::kContinue) hits.back().status = HitStatus::kDidNotFinish;
    }
  });
  return hits;
}

std::string AdversaryScorer::fault_of(const Prepared& prepared) const {
  const OracleMap map = oracle_map(prepared.grid, prepared.shape);
  const Schedule leaf_walk = find_algorithm("dda")->schedule;
  for (const Arithmetic arithmetic : {Arithmetic::kFixed, Arithmetic::kFloat, Arithmetic::kDouble}) {
    const std::string name(kArithmeticNames[static_cast<size_t>(arithmetic)]);
    const std::vector<HitRecord> plain = hits_of(leaf_walk, arithmetic, prepared);
    for (size_t k = 0; k < plain.size() && arithmetic == Arithmetic::kFixed; ++k) {
      const auto ray = exact_ray(prepared.rays[k], prepared.shape, prepared.format, OracleInput::kSetup);
      const HitRecord exact = to_record(oracle_leaf_walk(ray, map), prepared.rays[k].id, 0);
      if (!same_answer(plain[k], exact)) {
        return "ray " + std::to_string(k) + ": the leaf walk in fixed point finds " + describe(plain[k]) +
               ", exact arithmetic " + describe(exact);
      }
    }
    if (!algorithm_.exact() || algorithm_.schedule.stop_level != 0) continue;
    const std::vector<HitRecord> hits = hits_of(algorithm_.schedule, arithmetic, prepared);
    for (size_t k = 0; k < hits.size(); ++k) {
      if (!same_answer(hits[k], plain[k])) {
        return "ray " + std::to_string(k) + ": " + algorithm_.id + " in " + name + " finds " +
               describe(hits[k]) + ", the leaf walk " + describe(plain[k]);
      }
    }
  }
  return {};
}

double AdversaryScorer::score_of(const Algorithm& algorithm, const Prepared& prepared) const {
  Workload work;
  const int stop = algorithm.schedule.stop_level;
  const Pyramid stopped = stop > 0 ? build_stopped_pyramid(prepared.pyramid, stop) : Pyramid();
  work.pyramid = stop > 0 ? &stopped : &prepared.pyramid;
  work.map = prepared.shape;
  set_numbers(work, architecture_);
  work.rays = prepared.rays;
  work.pixel_of_ray = prepared.pixels;
  work.width = static_cast<int>(prepared.rays.size());
  work.height = 1;
  work.schedule = algorithm.schedule;
  std::optional<SearchMap> search_map;
  if (algorithm.search) {
    work.search = algorithm.search;
    search_map.emplace(*algorithm.search, prepared.pyramid, mode_);
    work.search_map = &*search_map;
  }
  const auto rays = static_cast<double>(prepared.rays.size());
  if (maximise_ == Maximise::kCycles) {
    const Outcome outcome = run_cycle(work, architecture_);
    return static_cast<double>(outcome.measurements.counters.get("machine.cycles")) / rays;
  }
  const Outcome outcome = run_functional(work);
  if (maximise_ == Maximise::kSteps) {
    return static_cast<double>(outcome.measurements.counters.get("machine.steps")) / rays;
  }
  const OracleMap map = oracle_map(prepared.grid, prepared.shape);
  const Arithmetic arithmetic = work.arithmetic;
  const double unit = DoubleArithmetic::format(prepared.shape, prepared.format).unit_of_time;
  double errors = 0;
  for (size_t k = 0; k < prepared.rays.size(); ++k) {
    const MachineRay& ray = prepared.rays[k];
    const HitRecord& found = outcome.hits[k];
    const auto exact = exact_ray(ray, prepared.shape, prepared.format, OracleInput::kMachineInput);
    const auto truth = oracle_leaf_walk(exact, map);
    const bool hit = found.status == HitStatus::kHit;
    const double t = recorded_time(found, arithmetic) / (arithmetic == Arithmetic::kFixed ? 1 : unit);
    const Verdict verdict = judge(exact, map, truth, {hit, found.i, found.j, hit ? t : 0});
    if (verdict == Verdict::kTie) continue;
    if (hit != truth.hit) {
      errors += 1;
    } else if (hit) {
      const double apart = std::abs(t - static_cast<double>(exact.in_machine_units(truth.t))) * unit;
      errors += std::min(1.0, apart * std::abs(static_cast<double>(ray.dz)) /
                                  static_cast<double>(prepared.shape.full_scale()));
    }
  }
  return errors / rays;
}

double AdversaryScorer::score_of(const Algorithm& algorithm, const HeightGrid& grid,
                                 std::span<const TracedRay> rays) const {
  return score_of(algorithm, prepare(grid, rays));
}

AdversaryScore AdversaryScorer::score(const HeightGrid& grid, std::span<const TracedRay> rays) const {
  const Prepared prepared = prepare(grid, rays);
  AdversaryScore scored;
  scored.fault = fault_of(prepared);  // first: it gives up on a walk without end
  if (scored.fault.empty()) scored.score = score_of(algorithm_, prepared);
  return scored;
}

}  // namespace cuesta
