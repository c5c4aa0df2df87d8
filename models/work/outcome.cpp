#include "models/work/outcome.h"

#include <algorithm>

#include "models/common/digest.h"
#include "models/common/error.h"

namespace cuesta {

NumberFormat number_format(const TraverseParameters& traverse, const MapShape& map) {
  NumberFormat format;
  format.fraction_bits = traverse.fraction_bits;
  format.direction_bits = traverse.direction_bits;
  format.mantissa_bits = traverse.mantissa_bits == 0 ? map.bits + 4 : traverse.mantissa_bits;
  format.tile_bits = traverse.tile_bits;
  // Products carry two bits more than a time; hit records hold a cell's index in 32 bits.
  if (time_bits(map, format) > 60 || map.root_level + format.tile_bits > 29) {
    throw usage_error("traverse.fraction_bits = " + std::to_string(format.fraction_bits) +
                      ", mantissa_bits = " + std::to_string(format.mantissa_bits) +
                      " and tile_bits = " + std::to_string(format.tile_bits) + " make times of " +
                      std::to_string(time_bits(map, format)) + " bits and cell indices of " +
                      std::to_string(map.root_level + format.tile_bits) +
                      " bits on this map; at most 60 and 29 are accepted.");
  }
  if (map.surface == Surface::kBilinear && traverse.arithmetic == Arithmetic::kFixed) {
    throw usage_error(
        "The scene's surface is bilinear and traverse.arithmetic is fixed, the hardware's, which has no "
        "bilinear "
        "leaf; accepted with it are float, double: --set traverse.arithmetic=float.");
  }
  if (map.surface == Surface::kBilinear && format.fraction_bits == 0) {
    throw usage_error(
        "The scene's surface is bilinear and traverse.fraction_bits = 0 cannot hold the half texel by which "
        "its "
        "patches are shifted; accepted with it are 1 to 12.");
  }
  return format;
}

Algorithm algorithm_on(const Algorithm& algorithm, const TraverseParameters& traverse) {
  if (algorithm.search) {
    if (traverse.start || traverse.down || traverse.up || traverse.stop_level || traverse.fetch) {
      throw usage_error(
          "The architecture's [traverse] section sets parts of a schedule (start, down, up, "
          "stop_level or fetch), and " +
          algorithm.id + " is a search, which has none; accepted with it are exact algorithms.");
    }
    return algorithm;
  }
  Schedule schedule = algorithm.schedule;
  schedule.start = traverse.start.value_or(schedule.start);
  schedule.down = traverse.down.value_or(schedule.down);
  schedule.up = traverse.up.value_or(schedule.up);
  schedule.stop_level = traverse.stop_level.value_or(schedule.stop_level);
  schedule.fetch = traverse.fetch.value_or(schedule.fetch);
  return schedule == algorithm.schedule ? algorithm : parse_algorithm(name_of(schedule));
}

std::vector<Algorithm> distinct_on(const Architecture& architecture, std::span<const Algorithm> algorithms) {
  std::vector<Algorithm> distinct;
  for (const Algorithm& algorithm : algorithms) {
    Algorithm here = algorithm_on(algorithm, architecture.traverse);
    const bool known = std::any_of(distinct.begin(), distinct.end(),
                                   [&](const Algorithm& other) { return other.id == here.id; });
    if (!known) distinct.push_back(std::move(here));
  }
  return distinct;
}

namespace {

/// A plane from one value per ray.
template <class Value>
Plane plane_of(const Workload& work, const char* name, Value&& value) {
  Plane plane;
  plane.name = name;
  plane.values.assign(static_cast<size_t>(work.width) * static_cast<size_t>(work.height), 0);
  for (size_t k = 0; k < work.rays.size(); ++k)
    plane.values[work.pixel_of_ray[k]] += static_cast<uint32_t>(value(k));
  return plane;
}

}  // namespace

void add_hit_measurements(const Workload& work, std::span<const HitRecord> hits, const FetchCounts& fetches,
                          Measurements& measurements) {
  Counters& counters = measurements.counters;
  int64_t hit = 0, miss = 0, dead = 0, unfinished = 0, steps = 0;
  std::vector<int64_t> per_ray;
  per_ray.reserve(hits.size());
  for (const HitRecord& record : hits) {
    hit += record.status == HitStatus::kHit;
    miss += record.status == HitStatus::kMiss;
    dead += record.status == HitStatus::kMiss && record.steps == 0;
    const bool early = record.status == HitStatus::kDidNotFinish && record.steps == 0;
    unfinished += early;
    steps += record.steps;
    if (!early) per_ray.push_back(record.steps);
  }
  counters.set("machine.rays", static_cast<int64_t>(hits.size()) - unfinished);
  counters.set("machine.hits", hit);
  counters.set("machine.misses", miss);
  counters.set("machine.dead_rays", dead);
  counters.set("machine.unfinished_rays", unfinished);
  counters.set("machine.steps", steps);
  counters.set("machine.fetches", fetches.fetches);
  counters.set("machine.fetched_texels", fetches.texels);
  counters.set("machine.texel_bytes", fetches.texels * work.texel_bytes());
  measurements.histograms.push_back(make_histogram("steps", std::move(per_ray)));
  measurements.plane_width = work.width;
  measurements.plane_height = work.height;
  measurements.planes.push_back(plane_of(work, "plane.steps", [&](size_t k) { return hits[k].steps; }));
}

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

void add_error_measurements(const Workload& work, const Judgement& judgement, Measurements& measurements) {
  Counters& counters = measurements.counters;
  const auto count = [&](Verdict verdict) { return judgement.counts.count(verdict); };
  counters.set("error.exact", count(Verdict::kExact));
  counters.set("error.tie", count(Verdict::kTie));
  counters.set("error.missed", count(Verdict::kMissed));
  counters.set("error.behind", count(Verdict::kBehind));
  counters.set("error.wrong_cell", count(Verdict::kWrongCell));
  counters.set("error.wrong", judgement.counts.wrong());
  if (is_printed(work.search->kind)) {
    counters.set("error.nan", judgement.not_numbers);
    counters.set("error.unfinished", judgement.unfinished);
  }
  const PreprocessingCost& cost = work.search_map->cost();
  counters.set("preprocessing.texels_read", static_cast<int64_t>(cost.texels_read));
  counters.set("preprocessing.records", static_cast<int64_t>(cost.records_written));
  counters.set("preprocessing.bytes", static_cast<int64_t>(work.search_map->size_bytes()));
  measurements.histograms.push_back(error_histogram("height_error", judgement.height_errors));
  measurements.histograms.push_back(error_histogram("texel_error", judgement.texel_errors));
  measurements.planes.push_back(plane_of(work, "plane.wrong", [&](size_t k) { return judgement.wrong(k); }));
}

void add_answer(Digest& digest, const HitRecord& hit) {
  digest.u64(hit.ray_id);
  digest.u8(static_cast<uint8_t>(hit.status));
  digest.u8(static_cast<uint8_t>(hit.face));
  digest.u8(hit.stop_level);
  digest.u32(static_cast<uint32_t>(hit.i));
  digest.u32(static_cast<uint32_t>(hit.j));
  digest.i64(hit.t);
}

void seal(const Workload& work, bool finished, Outcome& outcome) {
  Digest hits;
  hits.u64(work.rays.size());
  for (const MachineRay& ray : work.rays) {
    for (int64_t value : {ray.x0, ray.y0, ray.z0, ray.dx, ray.dy, ray.dz, ray.t_max}) hits.i64(value);
    hits.u64(ray.id);
    hits.u32(static_cast<uint32_t>(ray.exponent));
    hits.u8(ray.dead ? 1 : 0);
  }
  for (const HitRecord& hit : outcome.hits) {
    add_answer(hits, hit);
    hits.u32(hit.steps);
  }
  outcome.hits_digest = hits.hex();
  if (!finished) return;
  Digest all;
  all.text(outcome.hits_digest);
  for (const auto& [path, value] : outcome.measurements.counters.all()) {
    all.text(path);
    all.i64(value);
  }
  for (const Plane& plane : outcome.measurements.planes) {
    all.text(plane.name);
    for (uint32_t value : plane.values) all.u32(value);
    all.i64(plane.nobody);
  }
  outcome.digest = all.hex();
}

}  // namespace cuesta
