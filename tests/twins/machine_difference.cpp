#include "tests/twins/machine_difference.h"

#include <algorithm>
#include <sstream>

#include "models/units/ray_dispatch/dispatch_order.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/cycle_machine.h"

namespace cuesta::twins {
namespace {

void count_pipeline(const PipelineCounts& c, size_t p, const Architecture& architecture, Counters& counters) {
  auto set = [&](const char* unit, const char* statistic, int64_t value) {
    counters.set(std::string(unit) + "[" + std::to_string(p) + "]." + statistic, value);
  };
  auto cycles = [&](TraverseCycle kind) { return c.cycles[static_cast<size_t>(kind)]; };
  int64_t all = 0;
  for (const int64_t kind : c.cycles) all += kind;
  set("ray_setup", "rays", c.rays_entered);
  set("traverse", "cycles", all);
  set("traverse", "rays", c.rays_completed);
  set("traverse", "hits", c.rays_hit);
  set("traverse", "slots_step", cycles(TraverseCycle::kStep));
  set("traverse", "slots_part", cycles(TraverseCycle::kPart));
  set("traverse", "slots_compute", cycles(TraverseCycle::kCompute));
  set("traverse", "slots_miss", cycles(TraverseCycle::kMiss));
  set("traverse", "slots_refused", cycles(TraverseCycle::kRefused));
  set("traverse", "slots_dead", cycles(TraverseCycle::kDead));
  set("traverse", "bubble_contexts_full", cycles(TraverseCycle::kContextsFull));
  set("traverse", "bubble_no_ray", cycles(TraverseCycle::kNoRay));
  set("traverse", "bubble_drain", cycles(TraverseCycle::kDrain));
  set("traverse", "stall_hit_queue", cycles(TraverseCycle::kStalled));
  set("traverse", "replays", c.replays);
  set("traverse", "kept_steps", c.kept_steps);
  set("traverse", "line_accesses", c.hits + c.replays);
  set("traverse", "resident_cycles", c.resident_cycles);
  set("height_l1", "accesses", c.lookups);
  set("height_l1", "hits", c.hits);
  set("height_l1", "misses", c.allocated);
  set("height_l1", "merges", c.merged);
  set("height_l1", "refused", c.refused);
  set("height_l1", "fills", c.fills);
  set("height_l1", "fill_bytes", c.fills * architecture.height_l1.line_bytes);
  set("height_l1", "evictions", c.evictions);
  set("height_l1", "unique_lines", c.unique_lines);
  set("height_l1", "mshr_cycles", c.mshr_cycles);
  set("hit_queue", "pushes", c.pushes);
  set("hit_queue", "pops", c.pops);
  set("hit_queue", "waited_cycles", c.record_cycles);
  set("hit_queue", "max_fill", c.most_records);
  set("result_writer", "records", c.records);
  set("result_writer", "bursts", c.bursts);
  set("result_writer", "bytes", c.bursts * architecture.result_writer.burst_bytes);
}

Counters all_counters(const RandomMachine& machine, const TickingResult& result) {
  Counters counters;
  counters.set("machine.cycles", result.cycles);
  counters.set("machine.rays", static_cast<int64_t>(machine.rays.size()));
  for (const char* path : {"machine.hits", "machine.misses", "machine.dead_rays", "machine.steps"}) {
    counters.set(path, 0);
  }
  counters.set("machine.unfinished_rays", 0);
  for (const HitRecord& hit : result.hits) {
    counters.add("machine.hits", hit.status == HitStatus::kHit);
    counters.add("machine.misses", hit.status == HitStatus::kMiss);
    counters.add("machine.dead_rays", hit.status == HitStatus::kMiss && hit.steps == 0);
    counters.add("machine.steps", hit.steps);
  }
  int64_t sent = 0, kept = 0, texels = 0;
  for (size_t p = 0; p < result.pipelines.size(); ++p) {
    sent += result.pipelines[p].rays;
    kept += result.pipelines[p].kept_steps;
    texels += result.pipelines[p].fetched_texels;
    count_pipeline(result.pipelines[p], p, machine.architecture, counters);
  }
  counters.set("ray_dispatch.rays", sent);
  counters.set("machine.fetches", counters.get("machine.steps") - kept);
  counters.set("machine.fetched_texels", texels);
  counters.set("machine.texel_bytes", texels * machine.work().texel_bytes());
  const DramTwin::Counts& dram = result.dram;
  counters.set("dram.reads", dram.reads);
  counters.set("dram.writes", dram.writes);
  counters.set("dram.read_bytes", dram.reads * machine.architecture.height_l1.line_bytes);
  counters.set("dram.write_bytes", dram.writes * machine.architecture.result_writer.burst_bytes);
  counters.set("dram.row_hits", dram.row_hits);
  counters.set("dram.row_misses", dram.row_misses);
  counters.set("dram.row_conflicts", dram.row_conflicts);
  counters.set("dram.bus_clocks", dram.bus_clocks);
  return counters;
}

std::vector<Plane> all_planes(const RandomMachine& machine, const TwinRun& run) {
  std::vector<Plane> planes;
  auto add = [&](const char* name, auto&& value) {
    Plane plane;
    plane.name = name;
    plane.values.resize(static_cast<size_t>(machine.width) * static_cast<size_t>(machine.height));
    for (size_t k = 0; k < run.rays.size(); ++k) {
      plane.values[machine.pixels[k]] += static_cast<uint32_t>(value(run.rays[k]));
    }
    planes.push_back(std::move(plane));
  };
  add("plane.issue_slots", [](const RayTimes& r) { return r.issue_slots; });
  const Counters& c = run.counters;
  planes.back().nobody = c.sum("traverse", "bubble_contexts_full") + c.sum("traverse", "bubble_no_ray") +
                         c.sum("traverse", "bubble_drain") + c.sum("traverse", "stall_hit_queue");
  add("plane.l1_misses", [](const RayTimes& r) { return r.misses; });
  add("plane.dram_read_bytes", [](const RayTimes& r) { return r.fill_bytes; });
  add("plane.dram_write_bytes", [](const RayTimes& r) { return r.write_bytes; });
  add("plane.dram_bus_clocks", [](const RayTimes& r) { return r.bus_clocks; });
  add("plane.dram_row_activations", [](const RayTimes& r) { return r.row_activations; });
  add("plane.latency", [](const RayTimes& r) { return r.completed - r.sent; });
  return planes;
}

/// Collects the first difference.
class Comparison {
 public:
  template <class Value>
  void same(const std::string& what, const Value& fast, const Value& twin) {
    if (!text_.str().empty() || fast == twin) return;
    text_ << what << ": " << fast << " in the fast machine, " << twin << " in the ticking one\n";
  }
  void say(const std::string& text) {
    if (text_.str().empty()) text_ << text;
  }
  std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
};

void compare_ray(size_t k, const RayTimes& twin, const RayTiming& time, const MemoryCost& cost,
                 Comparison& comparison) {
  const std::string ray = "ray " + std::to_string(k) + " of the trace, ";
  comparison.same(ray + "completion cycle", time.completed, twin.completed);
  comparison.same<int64_t>(ray + "latency", time.latency, twin.completed - twin.sent);
  comparison.same<int64_t>(ray + "issue slots", time.issue_slots, twin.issue_slots);
  comparison.same<int64_t>(ray + "misses", time.misses, twin.misses);
  comparison.same<int64_t>(ray + "bytes read", cost.read_bytes, twin.fill_bytes);
  comparison.same<int64_t>(ray + "bytes written", cost.write_bytes, twin.write_bytes);
  comparison.same<int64_t>(ray + "bus clocks", cost.bus_clocks, twin.bus_clocks);
  comparison.same<int64_t>(ray + "row activations", cost.row_activations, twin.row_activations);
}

void compare_planes(const std::vector<Plane>& fast, const std::vector<Plane>& twin, Comparison& comparison) {
  for (const Plane& expected : twin) {
    const auto plane =
        std::find_if(fast.begin(), fast.end(), [&](const Plane& p) { return p.name == expected.name; });
    if (plane == fast.end()) {
      comparison.say(expected.name + " is missing in the fast machine\n");
      continue;
    }
    comparison.same(expected.name + ", nobody", plane->nobody, expected.nobody);
    comparison.same(expected.name + ", pixels", plane->values.size(), expected.values.size());
    for (size_t at = 0; at < std::min(plane->values.size(), expected.values.size()); ++at) {
      comparison.same(expected.name + ", pixel " + std::to_string(at), plane->values[at],
                      expected.values[at]);
    }
  }
}

}  // namespace

TwinRun run_ticking(const RandomMachine& machine, std::vector<int> evaluation_order) {
  const Architecture& architecture = machine.architecture;
  const Workload work = machine.work();
  const std::vector<uint32_t> order = dispatch_order(
      work.pixel_of_ray, work.width, architecture.ray_dispatch.order, architecture.ray_dispatch.tile_size);
  std::vector<MachineRay> rays;
  std::vector<uint32_t> pixels;
  for (const uint32_t k : order) {
    rays.push_back(machine.rays[k]);
    pixels.push_back(machine.pixels[k]);
  }
  const NumberFormat format = number_format(architecture.traverse, machine.map);
  auto values =
      machine.search
          ? make_search_values(architecture.traverse.arithmetic, *machine.search, *machine.search_map,
                               machine.map, format, machine.depth, rays)
          : make_ray_values(architecture, machine.pyramid, machine.map, format, work.schedule, rays);
  const uint64_t image_bytes = machine.search
                                   ? machine.search_map->size_bytes()
                                   : TexelLayout(architecture.texels.layout, machine.pyramid).size_bytes();
  const TickingResult result = TickingMachine(architecture, machine.stalls, *values, pixels, machine.width,
                                              image_bytes, std::move(evaluation_order))
                                   .run();
  TwinRun run;
  run.counters = all_counters(machine, result);
  run.rays.resize(order.size());
  run.hits.resize(order.size());
  for (size_t at = 0; at < order.size(); ++at) {
    run.rays[order[at]] = result.rays[at];
    run.hits[order[at]] = result.hits[at];
  }
  run.planes = all_planes(machine, run);
  return run;
}

std::string difference(const RandomMachine& machine) {
  const TwinRun twin = run_ticking(machine);
  CycleDetail detail;
  CycleHooks hooks;
  if (machine.stalled) hooks.stalls = &machine.stalls;
  const Outcome fast = run_cycle_detailed(machine.work(), machine.architecture, {}, hooks, &detail);

  Comparison comparison;
  comparison.same("rays", fast.hits.size(), twin.hits.size());
  // The ray that completes first among those that differ comes first.
  std::vector<size_t> by_completion(twin.rays.size());
  for (size_t k = 0; k < by_completion.size(); ++k) by_completion[k] = k;
  std::stable_sort(by_completion.begin(), by_completion.end(),
                   [&](size_t a, size_t b) { return twin.rays[a].completed < twin.rays[b].completed; });
  for (const size_t k : by_completion) {
    compare_ray(k, twin.rays[k], detail.timing[k], detail.memory[k], comparison);
    if (!(fast.hits[k] == twin.hits[k])) {
      comparison.say("ray " + std::to_string(k) + " of the trace: other hit records\n");
    }
  }
  for (const auto& [path, value] : twin.counters.all()) {
    comparison.same(path, fast.measurements.counters.get(path), value);
  }
  for (const auto& [path, value] : fast.measurements.counters.all()) {
    if (twin.counters.all().count(path) == 0) comparison.say(path + " is not counted by the twins\n");
  }
  compare_planes(fast.measurements.planes, twin.planes, comparison);
  if (comparison.text().empty()) return {};
  return comparison.text() + describe(machine);
}

}  // namespace cuesta::twins
