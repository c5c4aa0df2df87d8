#include <benchmark/benchmark.h>

#include <vector>

#include "models/common/elementary.h"
#include "models/common/random.h"
#include "models/heightmap/generator.h"
#include "models/traversal/lanes.h"
#include "models/traversal/traversal.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/cycle_machine.h"

// Steps per second of one core, fixed point, on a fractal map of 1024 x 1024 texels and 8 bits: functional (value
// alone), cycle (value, L1, DRAM, every unit in time) and whole_run (also histograms, planes, digests). 512 x 512
// rays: coherent (parallel, a tile's breadth) or random in place and direction. `lanes`: 16 rays at a time (AVX-512);
// `scalar`: one at a time.

namespace cuesta {
namespace {

constexpr int kSide = 512;

struct Bench {
  Pyramid pyramid;
  MapShape map;
  Architecture architecture;
  std::vector<MachineRay> coherent, random;
  std::vector<uint32_t> pixels;

  explicit Bench(int size) : pyramid(build_max_pyramid(generate("fractal", size, size, 8, 1))) {
    map = {size, size, pyramid.root_level(), 8, AddressMode::kWrap};
    const NumberFormat format = number_format(architecture.traverse, map);
    Random seeds(5);
    const double angle = 60 * 3.14159265358979323846 / 180, depth = 0.1;
    for (uint32_t k = 0; k < kSide * kSide; ++k) {
      TracedRay ray;
      ray.id = k;
      ray.origin[0] = (k % kSide + 0.5) / kSide;
      ray.origin[1] = (static_cast<double>(k / kSide) + 0.5) / kSide;
      ray.origin[2] = 1;
      ray.direction[0] = elementary::sin(angle) * elementary::cos(0.4);
      ray.direction[1] = elementary::sin(angle) * elementary::sin(0.4);
      ray.direction[2] = -elementary::cos(angle) / depth;
      coherent.push_back(quantise(ray, map, format));
      const double turn = seeds.unit() * 6.283185307179586;
      ray.origin[0] = seeds.unit();
      ray.origin[1] = seeds.unit();
      ray.direction[0] = elementary::sin(angle) * elementary::cos(turn);
      ray.direction[1] = elementary::sin(angle) * elementary::sin(turn);
      random.push_back(quantise(ray, map, format));
      pixels.push_back(k);
    }
  }

  Workload work(const Algorithm& algorithm, bool coherent_rays) const {
    return {.pyramid = &pyramid,
            .map = map,
            .format = number_format(architecture.traverse, map),
            .rays = coherent_rays ? coherent : random,
            .pixel_of_ray = pixels,
            .width = kSide,
            .height = kSide,
            .schedule = algorithm.schedule};
  }
};

const Bench& bench(int size) {
  static const Bench large(1024), small(256);
  return size == 1024 ? large : small;
}

void functional(benchmark::State& state, const Algorithm& algorithm, bool coherent_rays, bool lanes) {
  const Bench& b = bench(1024);
  const Workload work = b.work(algorithm, coherent_rays);
  const Walk<FixedArithmetic, PlainAxis> walk(b.map, work.format, work.schedule,
                                              b.pyramid.at(b.pyramid.root_level(), 0, 0));
  if (lanes && !lanes_can(walk)) return state.SkipWithError("this processor has no AVX-512");
  std::vector<HitRecord> hits(work.rays.size());
  int64_t steps = 0;
  for (auto _ : state) {
    if (lanes) {
      traverse_lanes(walk, b.pyramid, work.rays, {}, hits, nullptr);
    } else {
      for (size_t k = 0; k < hits.size(); ++k) {
        hits[k] = traverse_ray(walk, work.rays[k], [&](int level, int64_t i, int64_t j) -> int64_t {
          return b.pyramid.at(level, static_cast<int>(i), static_cast<int>(j));
        });
      }
    }
    for (const HitRecord& hit : hits) steps += hit.steps;
  }
  state.counters["steps/s"] = benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsRate);
}

void cycle(benchmark::State& state, const Algorithm& algorithm, int size, bool coherent_rays,
           bool whole_run) {
  const Bench& b = bench(size);
  const Workload work = b.work(algorithm, coherent_rays);
  int64_t steps = 0;
  for (auto _ : state) {
    CycleHooks hooks;
    hooks.counters_only = !whole_run;
    const Outcome outcome = run_cycle_detailed(work, b.architecture, {}, hooks, nullptr);
    steps += outcome.measurements.counters.get("traverse[0].slots_step");
  }
  state.counters["steps/s"] = benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsRate);
}

void add_all() {
  for (const Algorithm& algorithm : algorithms()) {
    const std::string& id = algorithm.id;
    auto add = [&](const std::string& name, auto&& body) {
      benchmark::RegisterBenchmark((name + "/" + id).c_str(), body)->Unit(benchmark::kMillisecond);
    };
    for (const bool coherent : {true, false}) {
      const std::string rays = coherent ? "coherent" : "random";
      add("functional/lanes/" + rays,
          [&, coherent](benchmark::State& s) { functional(s, algorithm, coherent, true); });
      add("functional/scalar/" + rays,
          [&, coherent](benchmark::State& s) { functional(s, algorithm, coherent, false); });
      add("cycle/1024/" + rays,
          [&, coherent](benchmark::State& s) { cycle(s, algorithm, 1024, coherent, false); });
    }
    add("cycle/256/coherent", [&](benchmark::State& s) { cycle(s, algorithm, 256, true, false); });
    add("whole_run/256/coherent", [&](benchmark::State& s) { cycle(s, algorithm, 256, true, true); });
  }
}

}  // namespace
}  // namespace cuesta

int main(int argc, char** argv) {
  cuesta::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
