#include "sim/explore/iterations/iterations.h"

#include <fmt/format.h>

#include <numeric>

#include "models/common/statistics.h"
#include "models/work/step_source.h"
#include "reports/numbers.h"
#include "sim/explore/study/view_runner.h"

namespace cuesta {
namespace {

constexpr std::string_view kName = "iterations";
constexpr int kLineBytes = 64;
// dda is left out where it takes longest: on larger maps at larger angles.
constexpr int kDdaMostTexels = 1024, kDdaMostDegrees = 60;

/// Remembers which of many have been seen.
class Seen {
 public:
  explicit Seen(uint64_t all) : words_(all / 64 + 1, 0) {}
  bool first_time(uint64_t k) {
    uint64_t& word = words_[k / 64];
    const uint64_t bit = uint64_t{1} << (k % 64);
    const bool first = (word & bit) == 0;
    word |= bit;
    return first;
  }

 private:
  std::vector<uint64_t> words_;
};

class IterationsRunner : public ViewRunner {
 public:
  IterationsRunner(const StudyData& plan, std::span<const uint16_t> size_and_map)
      : ViewRunner(plan, size_and_map, picture_pixels(true)), order_(pixels_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
  }

  std::vector<int64_t> run(const StudyPlace& place) override {
    const Workload work = work_at(place);
    const TexelLayout layout(TexelLayoutKind::kRowMajor, pyramid_);
    // The source's lines are texels here: their numbers give lines of any size.
    StepSource source(work, layout, pyramid_.texel_bytes(), order_);
    const uint64_t texels = layout.size_bytes() / static_cast<uint64_t>(pyramid_.texel_bytes());
    Seen texel_seen(texels), line_seen(layout.size_bytes() / kLineBytes);
    const auto texels_a_line = static_cast<uint32_t>(kLineBytes / pyramid_.texel_bytes());
    int64_t fetches = 0, unique_texels = 0, unique_lines = 0, steps = 0;
    std::vector<int64_t> per_ray;
    records_.clear();
    for (uint32_t k = 0; k < order_.size(); ++k) {
      const RaySteps read = source.steps(k);
      fetches += read.end - read.next;
      for (const uint32_t* texel = read.next; texel != read.end; ++texel) {
        if (!texel_seen.first_time(*texel)) continue;
        ++unique_texels;
        unique_lines += line_seen.first_time(*texel / texels_a_line);
      }
      source.finish(k, records_.emplace_back());
      steps += records_.back().steps;
      per_ray.push_back(records_.back().steps);
    }
    check_same_hits(place, records_);
    const Histogram histogram = make_histogram("steps", std::move(per_ray));
    return {static_cast<int64_t>(order_.size()),
            steps,
            histogram.median,
            histogram.p99,
            histogram.max,
            simt_slots(records_),
            fetches,
            unique_texels,
            unique_lines};
  }

 private:
  std::vector<uint32_t> order_;
  std::vector<HitRecord> records_;
};

StudyData make_plan(bool quick) {
  StudyData plan = begin_plan(kName, "Which traversal algorithm takes how many steps, and when?", quick);
  plan.conditions = view_conditions();
  add_conditions(
      plan,
      {fmt::format("Of the picture's warps of {} x {} pixels one in four is traced, evenly spread: {} rays a "
                   "case. The counts are exact for these rays and the same on every host; the mean over the "
                   "whole picture differs by a few per cent at most.",
                   kWarpWidth, kWarpHeight, grouped(static_cast<int64_t>(picture_pixels(true).size()))),
       "Fidelity: functional; no time, no cache.",
       fmt::format("dda is left out where it takes longest: beyond {} degrees on maps larger than {} texels.",
                   kDdaMostDegrees, kDdaMostTexels)});
  if (quick) {
    plan.axes = {size_axis({"64", "128"}), map_axis({"fractal", "spikes"}), depth_axis({"0.05", "0.35"}),
                 angle_axis({"10", "75"}), algorithm_axis(study_algorithms())};
  } else {
    plan.axes = {size_axis({"256", "512", "1024", "2048", "4096"}), map_axis(study_maps()),
                 depth_axis({"0.05", "0.35"}), angle_axis({"0", "10", "30", "50", "60", "75", "86", "88"}),
                 algorithm_axis(study_algorithms())};
  }
  plan.counters = {
      {"rays", "rays", "Rays traced; all of them hit."},
      {"steps", "steps", "Node visits of all rays."},
      {"steps_median", "steps", "Median over the rays (the lower one)."},
      {"steps_p99", "steps", "99th percentile over the rays."},
      {"steps_max", "steps", "The longest ray's."},
      simt_counter(),
      {"fetches", "texels", "Pyramid texels read."},
      {"unique_texels", "texels", "Different pyramid texels among them, over the whole picture."},
      {"unique_lines", "lines",
       fmt::format("Different lines of {} bytes that hold them (layout row_major).", kLineBytes)},
  };
  return plan;
}

bool is_planned(const StudyData& plan, const StudyPlace& place) {
  return !is_at(plan, place, "algorithm", "dda") || number_at(plan, place, "size") <= kDdaMostTexels ||
         number_at(plan, place, "angle") <= kDdaMostDegrees;
}

}  // namespace

Study iterations_study() {
  return {.name = kName,
          .plan = make_plan,
          .planned = is_planned,
          .make_runner = make_case_runner<IterationsRunner>,
          .page = iterations_page,
          .headline = iterations_headline};
}

}  // namespace cuesta
