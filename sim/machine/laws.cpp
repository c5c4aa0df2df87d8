#include <numeric>

#include "sim/machine/machine.h"

namespace cuesta {

namespace {

class Laws {
 public:
  explicit Laws(const Counters& counters) : counters_(counters) {}

  void equal(const std::string& what, int64_t left, int64_t right) {
    if (left != right)
      broken_.push_back(what + ": " + std::to_string(left) + " against " + std::to_string(right));
  }
  int64_t get(const std::string& path) const { return counters_.get(path); }
  std::vector<std::string> broken() && { return std::move(broken_); }

 private:
  const Counters& counters_;
  std::vector<std::string> broken_;
};

void check_pipeline(Laws& laws, int pipeline, const Architecture& architecture) {
  const std::string index = "[" + std::to_string(pipeline) + "].";
  auto get = [&](const char* unit, const char* statistic) { return laws.get(unit + index + statistic); };
  const std::string where = " of pipeline " + std::to_string(pipeline);
  laws.equal("rays into ray_setup = rays out of traverse" + where, get("ray_setup", "rays"),
             get("traverse", "rays"));
  laws.equal("rays out of traverse = records into hit_queue" + where, get("traverse", "rays"),
             get("hit_queue", "pushes"));
  laws.equal("records into = out of hit_queue" + where, get("hit_queue", "pushes"), get("hit_queue", "pops"));
  laws.equal("records out of hit_queue = records written" + where, get("hit_queue", "pops"),
             get("result_writer", "records"));
  laws.equal("reasons add up to traverse's cycles" + where,
             get("traverse", "slots_step") + get("traverse", "slots_part") +
                 get("traverse", "slots_compute") + get("traverse", "slots_miss") +
                 get("traverse", "slots_refused") + get("traverse", "slots_dead") +
                 get("traverse", "bubble_contexts_full") + get("traverse", "bubble_no_ray") +
                 get("traverse", "bubble_drain") + get("traverse", "stall_hit_queue"),
             laws.get("machine.cycles"));
  laws.equal("lookups = hits + misses + merges + refused" + where, get("height_l1", "accesses"),
             get("height_l1", "hits") + get("height_l1", "misses") + get("height_l1", "merges") +
                 get("height_l1", "refused"));
  laws.equal("line accesses = lookups that hit + replays" + where, get("traverse", "line_accesses"),
             get("height_l1", "hits") + get("traverse", "replays"));
  laws.equal(
      "steps = line accesses that end a step + kept steps" + where, get("traverse", "slots_step"),
      get("traverse", "line_accesses") - get("traverse", "slots_part") + get("traverse", "kept_steps"));
  laws.equal("parked rays = replayed rays" + where, get("height_l1", "misses") + get("height_l1", "merges"),
             get("traverse", "replays"));
  laws.equal("misses = fills" + where, get("height_l1", "misses"), get("height_l1", "fills"));
  laws.equal("bytes filled = fills x line" + where, get("height_l1", "fill_bytes"),
             get("height_l1", "fills") * architecture.height_l1.line_bytes);
}

void check_planes(Laws& laws, const Measurements& measurements, int pipelines) {
  auto total = [&](const std::string& name, int64_t expected) {
    for (const Plane& plane : measurements.planes) {
      if (plane.name != name) continue;
      const int64_t sum = std::accumulate(plane.values.begin(), plane.values.end(), int64_t{0});
      laws.equal(name + " + nobody = total", sum + plane.nobody, expected);
    }
  };
  total("plane.steps", laws.get("machine.steps"));
  total("plane.wrong", laws.get("error.wrong") + laws.get("error.nan") + laws.get("error.unfinished"));
  total("plane.issue_slots", pipelines * laws.get("machine.cycles"));
  total("plane.l1_misses", measurements.counters.sum("height_l1", "misses"));
  total("plane.dram_read_bytes", laws.get("dram.read_bytes"));
  total("plane.dram_write_bytes", laws.get("dram.write_bytes"));
  total("plane.dram_bus_clocks", laws.get("dram.bus_clocks"));
  total("plane.dram_row_activations", laws.get("dram.row_misses") + laws.get("dram.row_conflicts"));
}

}  // namespace

std::vector<std::string> broken_laws(const Workload& work, const Architecture& architecture,
                                     Fidelity fidelity, const Outcome& outcome) {
  if (outcome.finished_rays < work.rays.size()) return {};
  const Counters& counters = outcome.measurements.counters;
  Laws laws(counters);
  int64_t without_answer = 0;
  for (const HitRecord& hit : outcome.hits)
    without_answer += hit.status == HitStatus::kNotANumber || hit.status == HitStatus::kDidNotFinish;
  laws.equal("rays = hits + misses + rays of a printed search without an answer", laws.get("machine.rays"),
             laws.get("machine.hits") + laws.get("machine.misses") +
                 (work.search && is_printed(work.search->kind) ? without_answer : 0));
  if (counters.all().count("error.exact") != 0) {
    laws.equal("rays = verdicts + rays without an answer", laws.get("machine.rays"),
               laws.get("error.exact") + laws.get("error.tie") + laws.get("error.wrong") +
                   laws.get("error.nan") + laws.get("error.unfinished"));
  }
  laws.equal("rays of the trace = hit records", static_cast<int64_t>(work.rays.size()),
             laws.get("machine.rays"));
  if (!work.search && work.schedule.fetch == FetchRule::kTexel) {
    laws.equal("fetches = steps", laws.get("machine.fetches"), laws.get("machine.steps"));
    if (work.map.surface == Surface::kTexel)
      laws.equal("fetched texels = steps", laws.get("machine.fetched_texels"), laws.get("machine.steps"));
  }
  laws.equal("bytes without a cache = fetched texels x their bytes", laws.get("machine.texel_bytes"),
             laws.get("machine.fetched_texels") * work.texel_bytes());
  const int pipelines = fidelity != Fidelity::kFunctional ? architecture.machine.pipelines : 0;
  check_planes(laws, outcome.measurements, pipelines);
  if (fidelity != Fidelity::kFunctional) {
    for (int p = 0; p < pipelines; ++p) check_pipeline(laws, p, architecture);
    laws.equal("rays sent = rays of the trace", laws.get("ray_dispatch.rays"), laws.get("machine.rays"));
    laws.equal("rays sent = rays completed", laws.get("ray_dispatch.rays"), counters.sum("traverse", "rays"));
    laws.equal("steps of the hit records = slots with a step", laws.get("machine.steps"),
               counters.sum("traverse", "slots_step"));
    laws.equal("steps = fetches + kept steps", laws.get("machine.steps"),
               laws.get("machine.fetches") + counters.sum("traverse", "kept_steps"));
    laws.equal("bytes read from dram = bytes filled", laws.get("dram.read_bytes"),
               counters.sum("height_l1", "fill_bytes"));
    laws.equal("bytes written to dram = bytes of bursts", laws.get("dram.write_bytes"),
               counters.sum("result_writer", "bytes"));
    if (counters.all().count("dram.row_hits") !=
        0) {  // a memory outside the machine keeps its rows to itself
      laws.equal("requests = row hits + misses + conflicts", laws.get("dram.reads") + laws.get("dram.writes"),
                 laws.get("dram.row_hits") + laws.get("dram.row_misses") + laws.get("dram.row_conflicts"));
    }
  }
  return std::move(laws).broken();
}

}  // namespace cuesta
