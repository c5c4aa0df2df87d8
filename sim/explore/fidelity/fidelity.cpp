#include "sim/explore/fidelity/fidelity.h"

#include <fmt/format.h>

#include <algorithm>

#include "models/common/error.h"
#include "reports/numbers.h"
#include "sim/config/architecture_file.h"
#include "sim/explore/study/view_runner.h"

namespace cuesta {
namespace {

/// Makes the machine that "mobile height_l1.ways=1 ..." names: a preset and what is set.
Architecture machine_of(const std::string& name) {
  std::vector<std::string> words;
  for (size_t start = 0; start < name.size();) {
    const size_t end = std::min(name.find(' ', start), name.size());
    words.push_back(name.substr(start, end - start));
    start = end + 1;
  }
  return resolve_architecture(words[0], {words.begin() + 1, words.end()}, true).architecture;
}

/// Lists what a level says of the machine, in the order of `kCounted`.
std::vector<int64_t> counted(const Outcome& outcome) {
  const Counters& counters = outcome.measurements.counters;
  auto sum = [&](const char* unit, const char* statistic) { return counters.sum(unit, statistic); };
  return {counters.get("machine.cycles"),
          counters.get("dram.read_bytes"),
          sum("height_l1", "accesses"),
          sum("height_l1", "misses"),
          sum("height_l1", "merges"),
          sum("traverse", "bubble_contexts_full"),
          sum("traverse", "stall_hit_queue"),
          counters.get("dram.row_hits"),
          outcome.measurements.histograms.at(1).median};
}

struct Counted {
  const char* name;
  const char* unit;
  const char* sentence;
};

constexpr Counted kCounted[] = {
    {"cycles", "cycles", "Cycles of the machine until the last hit record is acknowledged"},
    {"dram_read_bytes", "bytes", "Bytes read from DRAM"},
    {"l1_lookups", "lookups", "Lookups in height_l1, retries included"},
    {"l1_misses", "lines", "Misses that allocated an MSHR"},
    {"l1_merges", "lookups", "Lookups that joined the MSHR of an earlier miss"},
    {"starved_cycles", "cycles",
     "Empty slots of traverse while every context held a ray that waited for memory"},
    {"stalled_cycles", "cycles", "Cycles in which traverse stood still because hit_queue was full"},
    {"dram_row_hits", "requests", "Requests that found their DRAM row open"},
    {"latency_median", "cycles", "Median over the rays, dispatch to completion"},
};

class FidelityRunner : public ViewRunner {
 public:
  FidelityRunner(const StudyData& plan, std::span<const uint16_t> size_and_map)
      : ViewRunner(plan, size_and_map, picture_pixels(false)) {
    for (const std::string& name : plan.axes[axis_index(plan, "machine")].values)
      machines_.push_back(machine_of(name));
  }

  std::vector<int64_t> run(const StudyPlace& place) override {
    const Architecture& machine = machines_[place[axis_index(plan_, "machine")]];
    const Workload work = work_at(place, machine);
    const Outcome cycle = run_cycle(work, machine), loose = run_transaction(work, machine);
    check_laws(work, machine, Fidelity::kCycle, cycle);
    check_laws(work, machine, Fidelity::kTransaction, loose);
    if (cycle.hits_digest != loose.hits_digest) {
      throw Error(ExitCode::kMismatch,
                  "Fidelity transaction and cycle differ in hits or steps on " + value(place, "map") + ".");
    }
    check_same_hits(place, cycle.hits);
    const Counters& counters = cycle.measurements.counters;
    const int64_t rays = counters.get("machine.rays"), steps = counters.get("machine.steps");
    const int64_t pipelines = machine.machine.pipelines;
    std::vector<int64_t> values = {
        rays, steps, counters.get("machine.texel_bytes"),
        (std::max(steps, rays * machine.ray_setup.interval_cycles) + pipelines - 1) / pipelines};
    for (const Outcome* outcome : {&cycle, &loose}) {
      for (const int64_t value : counted(*outcome)) values.push_back(value);
    }
    return values;
  }

 private:
  std::vector<Architecture> machines_;
};

constexpr std::string_view kName = "fidelity";

StudyData make_plan(bool quick) {
  StudyData plan =
      begin_plan(kName, "What does each level of fidelity get wrong, and what does it cost in time?", quick);
  plan.conditions = view_conditions();
  add_conditions(
      plan,
      {"Error: a level's count over that of fidelity cycle, less one; cycle and the Verilated RTL agree "
       "cycle "
       "by cycle (`cuesta verify rtl`), so that the error of both is 0.",
       fmt::format("All {} rays of the picture are traced; cold caches. Nothing in fidelity transaction is "
                   "fitted to these cases or to any others.",
                   grouped(kViewWidth * kViewHeight)),
       "Functional has no time and no cache. The most that it can say of cycles is a bound: one step a cycle "
       "and pipeline, and one ray an interval of set-up; of traffic: the bytes without a cache."});
  if (!quick) plan.conditions.push_back("dda is left out on maps of 1024 texels, where it takes longest.");
  const StudyAxis machines{
      "machine",
      "",
      "Preset, and what of it is changed.",
      {"tiny", "tiny traverse.contexts=24 height_l1.mshrs=8", "mobile", "mobile height_l1.size_bytes=4096",
       "mobile height_l1.ways=1", "mobile height_l1.mshrs=2", "mobile traverse.contexts=8",
       "mobile dram.response_latency_cycles=150", "mobile dram.bus_bytes=2",
       "mobile machine.pipelines=4 ray_dispatch.assign=interleave", "desktop"}};
  if (quick) {
    plan.axes = {size_axis({"64"}),
                 map_axis({"fractal"}),
                 depth_axis({"0.1"}),
                 angle_axis({"10", "75"}),
                 machines,
                 algorithm_axis({"oh2006", "yun2013"})};
  } else {
    plan.axes = {size_axis({"256", "1024"}),
                 map_axis({"fractal", "text", "noise"}),
                 depth_axis({"0.1"}),
                 angle_axis({"10", "75"}),
                 machines,
                 algorithm_axis({"dda", "oh2006", "tevs2008", "yun2013"})};
  }
  plan.counters = {
      {"rays", "rays", "Rays traced, one per pixel; all of them hit."},
      {"steps", "steps", "Node visits of all rays: the same on every level."},
      {"texel_bytes", "bytes", "Bytes of the texels that the steps read: functional's word on traffic."},
      {"bound_cycles", "cycles",
       "Steps, or rays times set-up's interval if more, over pipelines: functional's bound."},
  };
  for (const auto& [level, prefix] :
       {std::pair{"cycle", "cycle_"}, std::pair{"transaction", "transaction_"}}) {
    for (const Counted& one : kCounted) {
      plan.counters.push_back({std::string(prefix) + one.name, one.unit,
                               std::string(one.sentence) + ", fidelity " + level + "."});
    }
  }
  return plan;
}

bool is_planned(const StudyData& plan, const StudyPlace& place) {
  return !is_at(plan, place, "algorithm", "dda") || number_at(plan, place, "size") <= 256;
}

}  // namespace

Study fidelity_study() {
  return {.name = kName,
          .plan = make_plan,
          .planned = is_planned,
          .make_runner = make_case_runner<FidelityRunner>,
          .page = fidelity_page,
          .headline = fidelity_headline,
          .times = fidelity_times,
          .timed_page = fidelity_timed_page};
}

}  // namespace cuesta
