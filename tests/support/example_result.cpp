#include "tests/support/example_result.h"

#include <algorithm>
#include <string>

#include "models/common/random.h"

namespace cuesta::tests {
namespace {

std::string digest_like(uint64_t seed) {
  std::string digits;
  Random random(seed);
  while (digits.size() < 64) digits += "0123456789abcdef"[random.below(16)];
  return digits;
}

/// Steps of a pixel: smooth hills, more of them the slower the algorithm, some noise, a few outliers.
uint32_t steps_at(int x, int y, int width, int height, int slowness, Random& random) {
  const int64_t u = 64 * x / width - 32, v = 64 * y / height - 32;
  const int64_t hills = (u * u + 2 * v * v) / 48 + (u * v % 23) / 3 + 8;
  const int64_t steps = 4 + hills * slowness / 12 + static_cast<int64_t>(random.below(3));
  return static_cast<uint32_t>(std::max<int64_t>(1, random.chance(0.002) ? 3 * steps : steps));
}

Plane plane_like(const std::string& name, const std::vector<uint32_t>& steps, int per_step, int noise,
                 Random& random) {
  Plane plane{name, {}, 17, true};
  for (uint32_t count : steps) {
    plane.values.push_back(count * static_cast<uint32_t>(per_step) +
                           static_cast<uint32_t>(random.below(static_cast<uint64_t>(noise) + 1)));
  }
  return plane;
}

void count_pipeline(Counters& counters, int p, int64_t rays, int64_t steps, int64_t cycles, Random& random) {
  auto set = [&](const std::string& unit, const std::string& name, int64_t value) {
    counters.set(unit + "[" + std::to_string(p) + "]." + name, value);
  };
  const int64_t misses = steps / 9, retries = misses / 7, dead = rays / 50;
  set("traverse", "cycles", cycles);
  set("traverse", "slots_step", steps);
  set("traverse", "slots_miss", misses);
  set("traverse", "slots_refused", retries);
  set("traverse", "slots_dead", dead);
  const int64_t rest = cycles - steps - misses - retries - dead;
  const int64_t no_ray = rest * static_cast<int64_t>(random.between(2, 5)) / 10, full = rest * 3 / 10;
  set("traverse", "bubble_no_ray", no_ray);
  set("traverse", "bubble_contexts_full", full);
  set("traverse", "bubble_drain", (rest - no_ray - full) / 4);
  set("traverse", "stall_hit_queue", rest - no_ray - full - (rest - no_ray - full) / 4);
  set("height_l1", "accesses", steps + misses + retries);
  set("height_l1", "hits", steps);
  set("height_l1", "misses", misses);
  set("height_l1", "refused", retries);
  set("height_l1", "fill_bytes", misses * 64);
  set("height_l1", "unique_lines", misses / 4 + 300);
}

void count_memory(RunEntry& run) {
  Counters& counters = run.measurements.counters;
  const int64_t reads = counters.sum("height_l1", "fill_bytes") / 64,
                writes = counters.get("machine.rays") / 2;
  counters.set("dram.reads", reads);
  counters.set("dram.writes", writes);
  counters.set("dram.read_bytes", reads * 64);
  counters.set("dram.write_bytes", writes * 64);
  counters.set("dram.row_hits", reads * 6 / 10 + writes);
}

RunEntry run_like(const ExampleShape& shape, size_t scene, size_t algorithm) {
  Random random(Random::mix(1000 * scene + algorithm));
  RunEntry run;
  run.scene = shape.scenes[scene];
  run.algorithm = shape.algorithms[algorithm];
  run.architecture = "mobile";
  run.fidelity = shape.timed ? "cycle" : "functional";
  run.hits_digest = digest_like(10 * scene + algorithm);
  run.digest = digest_like(1000 + 10 * scene + algorithm);
  const int64_t rays = int64_t{shape.width} * shape.height;
  run.finished_rays = run.all_rays = static_cast<uint64_t>(rays);
  const int slowness =
      (run.algorithm == "dda" ? 60 : 14 - static_cast<int>(algorithm)) * static_cast<int>(scene + 1);
  std::vector<uint32_t> steps;
  int64_t all_steps = 0;
  for (int y = 0; y < shape.height; ++y) {
    for (int x = 0; x < shape.width; ++x) {
      steps.push_back(steps_at(x, y, shape.width, shape.height, slowness, random));
      all_steps += steps.back();
    }
  }
  Measurements& measurements = run.measurements;
  measurements.plane_width = shape.width;
  measurements.plane_height = shape.height;
  measurements.planes.push_back({"plane.steps", steps, 0, true});
  Counters& counters = measurements.counters;
  counters.set("machine.rays", rays);
  counters.set("machine.steps", all_steps);
  counters.set("machine.hits", rays * 9 / 10);
  counters.set("machine.texel_bytes", all_steps);
  if (!shape.timed) return run;
  run.machine = {{{"machine.pipelines", shape.pipelines, ""},
                  {"machine.clock_mhz", 500, "MHz"},
                  {"height_l1.line_bytes", 64, "bytes"},
                  {"dram.channels", 2, ""},
                  {"dram.bus_bytes", 4, "bytes"},
                  {"dram.clock_num", 8, ""},
                  {"dram.clock_den", 5, ""}},
                 1};
  const int64_t cycles = all_steps * 13 / 8 / shape.pipelines + 900;
  counters.set("machine.cycles", cycles);
  for (int p = 0; p < shape.pipelines; ++p) {
    count_pipeline(counters, p, rays / shape.pipelines, all_steps / shape.pipelines, cycles, random);
  }
  count_memory(run);
  measurements.planes.push_back(plane_like("plane.issue_slots", steps, 1, 2, random));
  measurements.planes.push_back(plane_like("plane.l1_misses", steps, 0, 3, random));
  measurements.planes.push_back(plane_like("plane.latency", steps, 9, 60, random));
  measurements.planes.back().adds_up = false;
  const std::vector<uint32_t>& latency = measurements.planes.back().values;
  measurements.histograms.push_back(make_histogram("latency", {latency.begin(), latency.end()}));
  return run;
}

}  // namespace

Result example_result(const ExampleShape& shape) {
  Result result;
  result.command = shape.algorithms.size() > 1 ? "compare" : "run";
  result.inputs = {{"scene", "rocks.toml", digest_like(1)}, {"heightmap", "rocks.png", digest_like(2)}};
  for (size_t scene = 0; scene < shape.scenes.size(); ++scene) {
    for (size_t algorithm = 0; algorithm < shape.algorithms.size(); ++algorithm) {
      result.runs.push_back(run_like(shape, scene, algorithm));
    }
  }
  result.manifest.version = "0.1.0";
  result.manifest.commit = "unknown";
  result.manifest.compiler = "GNU 12.2.0";
  result.manifest.seeds = {{"heightmap", "7"}};
  result.manifest.environment = {{"host", "example"}, {"started", "2000-01-01T00:00:00Z"}};
  return result;
}

}  // namespace cuesta::tests
