#include "models/common/statistics.h"

#include <algorithm>
#include <bit>

#include "models/common/error.h"

namespace cuesta {

namespace {

constexpr StatisticDefinition kDefinitions[] = {
    {"dram.bus_clocks", "memory clocks",
     "Clocks in which a channel's data bus carried data, over all channels."},
    {"dram.read_bytes", "bytes", "Bytes of the lines read for height_l1."},
    {"dram.reads", "requests", "Lines read for height_l1, one request each."},
    {"dram.row_conflicts", "requests",
     "Requests that found another row open in their bank: precharge and activate."},
    {"dram.row_hits", "requests", "Requests that found their row open."},
    {"dram.row_misses", "requests", "Requests that found no row open in their bank: activate only."},
    {"dram.write_bytes", "bytes",
     "Bytes of the bursts of hit records; the last, partly filled burst counts whole."},
    {"dram.writes", "requests", "Bursts of hit records written, one request each."},
    {"error.behind", "rays", "Rays of a search that hit another cell than the true one, and later."},
    {"error.exact", "rays", "Rays of a search that hit the true cell, or rightly miss."},
    {"error.missed", "rays", "Rays of a search that miss, and truly hit."},
    {"error.nan", "rays",
     "Rays of a search as printed that ended at no place: a coordinate NaN, infinite, or beyond a hit "
     "record's; not among "
     "error.wrong."},
    {"error.tie", "rays",
     "Rays of a search whose answer is the true one if touching counts as a hit, or edges are closed on the "
     "other side."},
    {"error.unfinished", "rays",
     "Rays of a search as printed that did not end within its steps; not among error.wrong."},
    {"error.wrong", "rays", "Rays of a search that missed, are behind, or hit a wrong cell."},
    {"error.wrong_cell", "rays",
     "Rays of a search that hit where nothing is, or another cell than the true one and earlier."},
    {"height_error", "height LSB / 256",
     "Histogram over the rays of a search that hit and truly hit: how far along the ray the found place lies "
     "from the true one, as a difference in height."},
    {"height_l1.accesses", "lookups",
     "Lookups: one per line access that traverse issues, replays left out, retries included."},
    {"height_l1.evictions", "lines", "Fills that replaced a line."},
    {"height_l1.fill_bytes", "bytes", "Bytes of the lines that landed."},
    {"height_l1.fills", "lines", "Lines that landed from dram."},
    {"height_l1.hits", "lookups", "Lookups that found their line."},
    {"height_l1.merges", "lookups",
     "Lookups that missed and joined the MSHR of an earlier miss to the same line."},
    {"height_l1.misses", "lookups", "Lookups that missed and allocated an MSHR: lines requested from dram."},
    {"height_l1.mshr_cycles", "MSHR cycles",
     "Sum over MSHRs of the cycles from allocation to the last waiter's replay."},
    {"height_l1.refused", "lookups",
     "Lookups that missed and found no free MSHR: the ray waits and looks up again."},
    {"height_l1.unique_lines", "lines",
     "Different lines ever requested by this cache: its compulsory misses."},
    {"hit_queue.max_fill", "records",
     "Most records met by a push, itself included; pops of the same cycle not yet counted."},
    {"hit_queue.pops", "records", "Records taken by result_writer."},
    {"hit_queue.pushes", "records", "Records pushed by traverse: completed rays."},
    {"hit_queue.waited_cycles", "record cycles", "Sum over records of the cycles from push to pop."},
    {"latency", "cycles", "Histogram over rays of the cycles from dispatch to completion."},
    {"machine.cycles", "cycles",
     "Cycles from reset to the acknowledgement of the last burst written; cold caches. With fidelity "
     "transaction an "
     "estimate: every unit in time, but rays look up the lines of up to 32 steps ahead of it."},
    {"machine.dead_rays", "rays", "Rays that missed at set-up, with no step: outside the slab or the map."},
    {"machine.fetched_texels", "texels",
     "Texels that the fetches brought: one each, or with fetch = quad the 2 x 2 siblings as far as the level "
     "has them; records of its map in a search."},
    {"machine.fetches", "fetches",
     "Node visits that read memory: every step, but with fetch = quad those whose siblings the ray had "
     "kept."},
    {"machine.hits", "rays", "Rays that hit the surface."},
    {"machine.misses", "rays", "Rays that did not, dead ones included."},
    {"machine.rays", "rays", "Rays with a result: all of the trace, unless the run was ended early."},
    {"machine.steps", "steps", "Node visits of all rays; in a search, its steps."},
    {"machine.texel_bytes", "bytes",
     "Bytes of the texels that the fetches brought: the traffic without any cache."},
    {"machine.unfinished_rays", "rays", "Rays without a result: the run was ended early."},
    {"plane.dram_bus_clocks", "memory clocks",
     "Data-bus clocks of the requests that the pixel's rays caused."},
    {"plane.dram_read_bytes", "bytes",
     "Bytes of the lines whose misses the pixel's rays allocated; merged misses and "
     "later hits carry none."},
    {"plane.dram_row_activations", "activations",
     "Rows opened by the requests that the pixel's rays caused."},
    {"plane.dram_write_bytes", "bytes", "Bytes of the bursts whose first record is the pixel's."},
    {"plane.issue_slots", "cycles",
     "Slots of the traverse pipes that the pixel's rays used; empty slots and "
     "standstills belong to nobody."},
    {"plane.l1_misses", "lines", "Misses that the pixel's rays allocated."},
    {"plane.latency", "cycles",
     "Cycles from dispatch to completion, summed over the pixel's rays; does not add up "
     "to the machine's cycles, as rays overlap."},
    {"plane.steps", "steps", "Node visits of the pixel's rays."},
    {"plane.wrong", "rays",
     "How many of the pixel's rays missed, are behind, hit a wrong cell, or have no answer: error.wrong, "
     "error.nan and error.unfinished together; 0 where all are right."},
    {"preprocessing.bytes", "bytes",
     "Bytes of the map that a search reads: one record per texel; of one as printed, the pyramid's image."},
    {"preprocessing.records", "records", "Records that the making of a search's map wrote."},
    {"preprocessing.texels_read", "texels", "Texels that the making of a search's map read."},
    {"ray_dispatch.rays", "rays", "Rays sent to the pipelines."},
    {"ray_setup.rays", "rays", "Rays that entered set-up."},
    {"result_writer.bursts", "bursts", "Bursts written."},
    {"result_writer.bytes", "bytes", "Bytes of the bursts written."},
    {"result_writer.records", "records", "Hit records taken from hit_queue."},
    {"steps", "steps", "Histogram over rays of the node visits."},
    {"texel_error", "texels / 256",
     "Histogram over the rays of a search that hit and truly hit: how far along the ray the found place lies "
     "from the true one, in the plane of the map."},
    {"traverse.bubble_contexts_full", "cycles",
     "Empty slots while every context held a ray that waited for memory."},
    {"traverse.bubble_drain", "cycles", "Empty slots after the last ray had been taken."},
    {"traverse.bubble_no_ray", "cycles",
     "Empty slots while ray_setup had no ray ready and some were still to come."},
    {"traverse.cycles", "cycles",
     "Cycles of the unit: slots used, empty slots and standstills add up to them."},
    {"traverse.hits", "rays", "Completed rays that hit."},
    {"traverse.kept_steps", "steps",
     "Of the steps, those that read nothing: with fetch = quad, since the ray had kept the siblings; in "
     "a search, a last division."},
    {"traverse.line_accesses", "accesses",
     "Lines read for steps: one for each, or as many as the quad's or sample's texels lie in, none for a "
     "kept "
     "one."},
    {"traverse.rays", "rays", "Rays completed: transferred on the hit stream."},
    {"traverse.replays", "accesses", "Of the line accesses, those replayed after their line had landed."},
    {"traverse.resident_cycles", "ray cycles",
     "Sum over rays of the cycles in a context, from entry to completion."},
    {"traverse.slots_compute", "cycles",
     "Slots of arithmetic that read nothing, before the samples of a search's step."},
    {"traverse.slots_dead", "cycles", "Slots used by rays dead at set-up."},
    {"traverse.slots_miss", "cycles", "Slots used by a lookup that missed and parked its ray on an MSHR."},
    {"traverse.slots_part", "cycles",
     "Slots in which a line of a quad or sample was read and others of its step were still to come."},
    {"traverse.slots_refused", "cycles", "Slots used by a lookup that missed and found no free MSHR."},
    {"traverse.slots_step", "cycles", "Slots in which a node visit, or a step of a search, was done: steps."},
    {"traverse.stall_hit_queue", "cycles",
     "Cycles in which the pipe stood still, a result before a full hit_queue."},
};

}  // namespace

std::span<const StatisticDefinition> statistic_definitions() { return kDefinitions; }

const StatisticDefinition& definition_of(std::string_view path) {
  std::string name(path);
  const size_t open = name.find('['), close = name.find(']');
  if (open != std::string::npos && close != std::string::npos) name.erase(open, close - open + 1);
  for (const StatisticDefinition& definition : kDefinitions) {
    if (definition.name == name) return definition;
  }
  throw Error(ExitCode::kInternal, "The statistic '" + std::string(path) + "' has no definition.");
}

int64_t Counters::sum(std::string_view unit, std::string_view statistic) const {
  int64_t total = 0;
  const std::string front = std::string(unit) + "[", back = "]." + std::string(statistic);
  for (const auto& [path, value] : values_) {
    if (path.starts_with(front) && path.ends_with(back)) total += value;
  }
  return total;
}

Histogram make_histogram(std::string name, std::vector<int64_t> values) {
  Histogram histogram;
  histogram.name = std::move(name);
  if (values.empty()) return histogram;
  // Distinct values and how many of each, in order; small values are counted, not sorted.
  std::vector<std::pair<int64_t, int64_t>> distinct;
  const int64_t largest = *std::max_element(values.begin(), values.end());
  if (largest < static_cast<int64_t>(16 * values.size() + 4096)) {
    std::vector<int64_t> counts(static_cast<size_t>(largest) + 1, 0);
    for (int64_t v : values) ++counts[static_cast<size_t>(v)];
    for (int64_t v = 0; v <= largest; ++v) {
      if (counts[static_cast<size_t>(v)] > 0) distinct.emplace_back(v, counts[static_cast<size_t>(v)]);
    }
  } else {
    std::sort(values.begin(), values.end());
    for (int64_t v : values) {
      if (distinct.empty() || distinct.back().first != v) distinct.emplace_back(v, 0);
      ++distinct.back().second;
    }
  }
  auto value_at = [&](int64_t rank) {
    for (const auto& [value, count] : distinct) {
      if (rank < count) return value;
      rank -= count;
    }
    return largest;
  };
  const auto n = static_cast<int64_t>(values.size());
  histogram.median = value_at((n - 1) / 2);
  histogram.p99 = value_at((n - 1) * 99 / 100);
  histogram.max = largest;
  // Bins 0, 1, 2, 3, then each power of two in four.
  auto bin_start = [](int64_t v) -> int64_t {
    if (v < 4) return v;
    const int shift = std::bit_width(static_cast<uint64_t>(v)) - 3;
    return v >> shift << shift;
  };
  for (const auto& [value, count] : distinct) {
    const int64_t start = bin_start(value);
    if (histogram.first.empty() || histogram.first.back() != start) {
      histogram.first.push_back(start);
      histogram.count.push_back(0);
    }
    histogram.count.back() += count;
  }
  return histogram;
}

}  // namespace cuesta
