#include "sim/explore/bandwidth/bandwidth.h"

#include <fmt/format.h>

#include "reports/numbers.h"
#include "sim/config/architecture_file.h"
#include "sim/explore/study/view_runner.h"

namespace cuesta {
namespace {

class BandwidthRunner : public ViewRunner {
 public:
  BandwidthRunner(const StudyData& plan, std::span<const uint16_t> size_and_map)
      : ViewRunner(plan, size_and_map, picture_pixels(false)) {
    for (const std::string& name : plan.axes[axis_index(plan, "machine")].values) {
      machines_.push_back(resolve_architecture(name, {}, true).architecture);
    }
  }

  std::vector<int64_t> run(const StudyPlace& place) override {
    const Architecture& architecture = machines_[place[axis_index(plan_, "machine")]];
    const Workload work = work_at(place, architecture);
    const Outcome outcome = run_cycle(work, architecture);
    check_laws(work, architecture, Fidelity::kCycle, outcome);
    check_same_hits(place, outcome.hits);
    const Counters& counters = outcome.measurements.counters;
    auto sum = [&](const char* unit, const char* statistic) { return counters.sum(unit, statistic); };
    const Histogram& latency = outcome.measurements.histograms.at(1);
    return {counters.get("machine.rays"),
            counters.get("machine.steps"),
            counters.get("machine.cycles"),
            sum("traverse", "cycles"),
            sum("traverse", "bubble_contexts_full"),
            sum("height_l1", "accesses"),
            sum("height_l1", "hits"),
            sum("height_l1", "misses"),
            sum("height_l1", "unique_lines"),
            counters.get("dram.read_bytes"),
            counters.get("dram.write_bytes"),
            counters.get("dram.row_hits"),
            counters.get("machine.texel_bytes"),
            latency.median,
            simt_slots(outcome.hits),
            architecture.machine.clock_mhz};
  }

 private:
  std::vector<Architecture> machines_;
};

constexpr std::string_view kName = "bandwidth";

StudyData make_plan(bool quick) {
  StudyData plan =
      begin_plan(kName, "How many bytes and cycles do the steps of each algorithm cost, and when?", quick);
  plan.conditions = view_conditions();
  add_conditions(
      plan,
      {"Fidelity: cycle, cold caches, scanline order. mobile: one pipeline at 500 MHz, L1 of 16 KiB in lines "
       "of 64 bytes, 12.8 GB/s of DRAM. desktop: its preset, for one map and size.",
       fmt::format("All {} rays of the picture are traced: the counts are exact, nothing is sampled.",
                   grouped(kViewWidth * kViewHeight)),
       "dda is left out where it takes longest: on 1024 texels beyond 60 degrees, on 4096 in all but front "
       "views."});
  const StudyAxis machines{
      "machine", "", "Preset, as `cuesta list architectures` calls it.", {"mobile", "desktop"}};
  if (quick) {
    plan.axes = {size_axis({"64", "128"}),
                 map_axis({"fractal"}),
                 depth_axis({"0.05"}),
                 angle_axis({"10", "75"}),
                 machines,
                 algorithm_axis({"oh2006", "yun2013"})};
  } else {
    plan.axes = {size_axis({"256", "1024", "4096"}),
                 map_axis(study_maps()),
                 depth_axis({"0.05", "0.35"}),
                 angle_axis({"0", "50", "75", "86", "88"}),
                 machines,
                 algorithm_axis(study_algorithms())};
  }
  plan.counters = {
      {"rays", "rays", "Rays traced, one per pixel; all of them hit."},
      {"steps", "steps", "Node visits of all rays."},
      {"cycles", "cycles", "Cycles of the machine until the last hit record is acknowledged."},
      {"pipe_cycles", "cycles", "Cycles of the traverse pipes, over all pipelines."},
      {"starved_cycles", "cycles",
       "Of them, empty slots while every context held a ray that waited for memory."},
      {"l1_lookups", "lookups", "Lookups in height_l1."},
      {"l1_hits", "lookups", "Of them, those that found their line."},
      {"l1_fills", "lines", "Lines read from DRAM."},
      {"unique_lines", "lines", "Different lines: what a cache of any size would read (per pipeline)."},
      {"dram_read_bytes", "bytes", "Bytes read from DRAM."},
      {"dram_write_bytes", "bytes", "Bytes of hit records written: the same for all algorithms."},
      {"dram_row_hits", "requests", "Requests that found their DRAM row open."},
      {"texel_bytes", "bytes", "Bytes of the texels that the steps read: the traffic without a cache."},
      {"latency_median", "cycles", "Median over the rays, dispatch to completion."},
      simt_counter(),
      {"clock_mhz", "MHz", "The machine's clock."},
  };
  return plan;
}

bool is_planned(const StudyData& plan, const StudyPlace& place) {
  const double size = number_at(plan, place, "size");
  if (is_at(plan, place, "algorithm", "dda") && size > 256 &&
      size * number_at(plan, place, "angle") > 1024 * 60) {
    return false;
  }
  // The second machine is there for comparison: one map, one size.
  if (is_at(plan, place, "machine", "mobile")) return true;
  return is_at(plan, place, "map", "fractal") &&
         (is_at(plan, place, "size", "1024") || is_at(plan, place, "size", "64"));
}

}  // namespace

Study bandwidth_study() {
  return {.name = kName,
          .plan = make_plan,
          .planned = is_planned,
          .make_runner = make_case_runner<BandwidthRunner>,
          .page = bandwidth_page,
          .headline = bandwidth_headline};
}

}  // namespace cuesta
