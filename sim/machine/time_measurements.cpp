#include "sim/machine/time_measurements.h"

#include <vector>

namespace cuesta {

void add_ray_measurements(const Workload& work, std::span<const HitRecord> hits,
                          std::span<const RayTiming> timing, std::span<const MemoryCost> memory,
                          int64_t traverse_cycles, bool dram_inside, Measurements& measurements) {
  FetchCounts fetches;
  for (const RayTiming& ray : timing) fetches.add(ray.fetches);
  add_hit_measurements(work, hits, fetches, measurements);
  std::vector<int64_t> latencies;
  latencies.reserve(timing.size());
  int64_t slots = 0;
  for (const RayTiming& ray : timing) {
    if (ray.completed >= 0) latencies.push_back(ray.latency);
    slots += ray.issue_slots;
  }
  measurements.histograms.push_back(make_histogram("latency", std::move(latencies)));
  auto add = [&](const char* name, auto&& value) {
    measurements.planes.push_back(plane_of(work, name, value));
  };
  add("plane.issue_slots", [&](size_t k) { return timing[k].issue_slots; });
  measurements.planes.back().nobody = traverse_cycles - slots;
  add("plane.l1_misses", [&](size_t k) { return timing[k].misses; });
  add("plane.dram_read_bytes", [&](size_t k) { return memory[k].read_bytes; });
  add("plane.dram_write_bytes", [&](size_t k) { return memory[k].write_bytes; });
  if (dram_inside) {
    add("plane.dram_bus_clocks", [&](size_t k) { return memory[k].bus_clocks; });
    add("plane.dram_row_activations", [&](size_t k) { return memory[k].row_activations; });
  }
  add("plane.latency", [&](size_t k) { return timing[k].latency; });
  measurements.planes.back().adds_up = false;
}

}  // namespace cuesta
