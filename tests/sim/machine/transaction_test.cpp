#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/heightmap/generator.h"
#include "sim/config/architecture_file.h"
#include "sim/session/measure.h"
#include "sim/verify/lockstep/random_architecture.h"
#include "traces/ray_sets.h"
#include "traces/scene_library.h"

// Fidelity transaction against functional and cycle.

namespace cuesta {
namespace {

Job job_of(AddressMode mode, const std::string& ray_set, int rays, int side = 64) {
  Job job;
  job.scene.name = "made";
  job.pyramid = build_max_pyramid(generate("rocks", side, side, 8, 3));
  job.map = {side, side, job.pyramid.root_level(), 8, mode};
  job.trace = make_ray_set({ray_set, static_cast<uint64_t>(rays), 7}, job.map);
  for (const TracedRay& ray : job.trace.rays) {
    job.pixel_of_ray.push_back(ray.pixel_y * static_cast<uint32_t>(job.trace.width) + ray.pixel_x);
  }
  return job;
}

int64_t cycles_of(const RunEntry& run) { return run.measurements.counters.get("machine.cycles"); }

double error_of(int64_t estimate, int64_t truth) {
  return std::abs(static_cast<double>(estimate) / static_cast<double>(truth) - 1);
}

TEST(Transaction, FindsTheHitsAndStepsOfFunctionalWithEverySchedule) {
  for (const AddressMode mode : {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kMirror}) {
    const Job job = job_of(mode, "stratified", 400);
    Measurer measurer(job);
    std::vector<std::string> names = {"yun2013:quad", "root:common:never", "span:3:coherent:stop=2:quad",
                                      "dda:stop=2", "oh2006:stop=6"};
    for (const auto list : {algorithms(), algorithm_parts()}) {
      for (const Algorithm& algorithm : list) names.push_back(algorithm.id);
    }
    for (const std::string& name : names) {
      const RunEntry plain = measurer.run(parse_algorithm(name), {}, Fidelity::kFunctional);
      const RunEntry loose = measurer.run(parse_algorithm(name), {}, Fidelity::kTransaction);
      EXPECT_EQ(plain.hits_digest, loose.hits_digest) << name;
      EXPECT_EQ(loose.fidelity, "transaction");
      for (const char* counter :
           {"machine.steps", "machine.fetches", "machine.fetched_texels", "machine.texel_bytes"}) {
        EXPECT_EQ(plain.measurements.counters.get(counter), loose.measurements.counters.get(counter)) << name;
      }
    }
  }
}

TEST(Transaction, WithOneRayAtATimeEveryCounterIsThatOfCycle) {
  const Job job = job_of(AddressMode::kWrap, "stratified", 300);
  Measurer measurer(job);
  for (const char* name : {"yun2013", "dda", "oh2006:quad"}) {
    for (const int latency : {1, 40}) {
      Architecture machine;
      machine.traverse.stages = machine.traverse.contexts = 1;
      machine.height_l1.size_bytes = 1024;
      machine.dram.response_latency_cycles = latency;
      const RunEntry cycle = measurer.run(parse_algorithm(name), machine, Fidelity::kCycle);
      const RunEntry loose = measurer.run(parse_algorithm(name), machine, Fidelity::kTransaction);
      EXPECT_GT(cycle.measurements.counters.get("height_l1[0].evictions"), 20);
      for (const auto& [path, value] : cycle.measurements.counters.all()) {
        if (path.find(".bubble_") != std::string::npos) continue;  // the reason is that of their end
        EXPECT_EQ(loose.measurements.counters.get(path), value) << name << " " << path;
      }
    }
  }
}

TEST(Transaction, TheLawsHoldOnRandomMachines) {
  Random random(11);
  const Job job = job_of(AddressMode::kWrap, "random", 250);
  Measurer measurer(job);
  const std::vector<std::string> names = {"yun2013", "dda", "oh2006:quad", "tevs2008:stop=1"};
  for (int k = 0; k < 120; ++k) {
    // Measurer throws for a law that is broken, and for hits that differ.
    const Architecture machine = random_architecture(random);
    const Algorithm algorithm = parse_algorithm(names[static_cast<size_t>(k) % names.size()]);
    const RunEntry loose = measurer.run(algorithm, machine, Fidelity::kTransaction);
    EXPECT_EQ(loose.digest, measurer.run(algorithm, machine, Fidelity::kTransaction).digest);
    EXPECT_EQ(loose.hits_digest, measurer.run(algorithm, machine, Fidelity::kFunctional).hits_digest);
  }
}

/// A machine in which one thing alone decides, and how near the estimate must be.
struct Bound {
  const char* name;
  double within;
  void (*set)(Architecture& machine);
};

constexpr Bound kBounds[] = {
    {"compute", 0.01,
     [](Architecture& m) {
       m.height_l1.size_bytes = 65536;
       m.ray_setup.interval_cycles = 1;
       m.ray_setup.queue_depth = 32;
     }},
    {"set-up", 0.005, [](Architecture& m) { m.ray_setup.interval_cycles = 200; }},
    {"bandwidth", 0.05,
     [](Architecture& m) {
       m.dram.bus_bytes = 1;
       m.height_l1.size_bytes = 2048;
     }},
    {"latency", 0.05,
     [](Architecture& m) {
       m.dram.response_latency_cycles = 400;
       m.height_l1.mshrs = 2;
     }},
    {"contexts", 0.05,
     [](Architecture& m) {
       m.dram.response_latency_cycles = 200;
       m.traverse.contexts = 8;
     }},
    {"writes", 0.01,
     [](Architecture& m) {
       m.result_writer.outstanding = 1;
       m.result_writer.burst_bytes = 32;
       m.dram.response_latency_cycles = 300;
       m.height_l1.size_bytes = 65536;
     }},
};

TEST(Transaction, IsTightWhereOneThingDecides) {
  const Job job = job_of(AddressMode::kWrap, "stratified", 3000);
  Measurer measurer(job);
  for (const Bound& bound : kBounds) {
    for (const char* name : {"yun2013", "oh2006"}) {
      Architecture machine;
      bound.set(machine);
      const int64_t cycle = cycles_of(measurer.run(*find_algorithm(name), machine, Fidelity::kCycle));
      const int64_t loose = cycles_of(measurer.run(*find_algorithm(name), machine, Fidelity::kTransaction));
      EXPECT_LE(error_of(loose, cycle), bound.within)
          << bound.name << " " << name << ": " << loose << " for " << cycle;
    }
  }
}

TEST(Transaction, OverScenesAlgorithmsAndMachinesTheMedianErrorIsBelowFiveAndTheLargestBelowFifteenPerCent) {
  std::vector<double> errors;
  for (const BuiltInScene& scene : built_in_scenes()) {
    SceneChanges changes;
    const Scene wanted = changed_scene(std::string(scene.name), changes);
    if (wanted.rays_file.empty() && wanted.ray_set.kind.empty()) changes.size = {40, 40};
    const Job job = prepare_job(std::string(scene.name), changes);
    Measurer measurer(job);
    for (const char* preset : {"tiny", "mobile", "desktop"}) {
      const Architecture machine = resolve_architecture(preset, {}, true).architecture;
      for (const Algorithm& algorithm : algorithms()) {
        const int64_t cycle = cycles_of(measurer.run(algorithm, machine, Fidelity::kCycle));
        const int64_t loose = cycles_of(measurer.run(algorithm, machine, Fidelity::kTransaction));
        errors.push_back(error_of(loose, cycle));
        EXPECT_LT(errors.back(), 0.15) << scene.name << " " << algorithm.id << " on " << preset;
      }
    }
  }
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2),
                   errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.05);
}

}  // namespace
}  // namespace cuesta
