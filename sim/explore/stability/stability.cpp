#include "sim/explore/stability/stability.h"
#include "models/work/functional_run.h"

#include <algorithm>
#include <optional>

#include "models/common/error.h"
#include "models/work/hit_judge.h"
#include "sim/explore/study/view_bench.h"
#include "sim/explore/study/view_times.h"

namespace cuesta {
namespace {

class StabilityBench : public ViewBench {
 public:
  StabilityBench(const StudyData& plan, std::span<const uint16_t> size_and_map)
      : ViewBench(plan, size_and_map, picture_pixels(true)) {
    architecture_.traverse.arithmetic = Arithmetic::kFloat;
  }

  std::vector<int64_t> run(const StudyPlace& place) override {
    const Workload work = work_at(place, architecture_);
    const Outcome outcome = run_functional(work);
    if (!work.search) check_same_hits(place, outcome.hits);
    const std::string view = value(place, "depth") + "/" + value(place, "angle") + "/" + value(place, "turn");
    if (!judge_ || view != view_) {
      judge_.emplace(work);
      view_ = view;
    }
    const Judgement found = judge_->judge(outcome.hits, work.arithmetic);
    const auto count = [&](Verdict verdict) { return found.counts.count(verdict); };
    int64_t steps = 0, longest = 0;
    for (const HitRecord& hit : outcome.hits) {
      steps += hit.steps;
      longest = std::max<int64_t>(longest, hit.steps);
    }
    return {static_cast<int64_t>(outcome.hits.size()),
            count(Verdict::kExact),
            count(Verdict::kTie),
            count(Verdict::kMissed),
            count(Verdict::kBehind),
            count(Verdict::kWrongCell),
            found.not_numbers,
            found.unfinished,
            steps,
            longest};
  }

 private:
  Architecture architecture_;
  std::optional<HitJudge> judge_;
  std::string view_;  ///< of judge_
};

std::vector<std::string> stability_algorithms() {
  std::vector<std::string> list = {"dda", "oh2006", "drobot2009", "tevs2008", "yun2013", "relief", "cone"};
  for (const char* code : {"ki2007-printed", "drobot2009-printed"}) {
    for (const char* delta : {"0.5", "0.05", "0.005", "0"}) {
      for (const char* ending : {"", ":slope"})
        list.push_back(parse_algorithm(std::string(code) + ":delta=" + delta + ending).id);
    }
  }
  return list;
}

}  // namespace

StudyData stability_plan(bool quick) {
  StudyData plan;
  plan.study = "stability";
  plan.question =
      "What is robustness worth: how often do the codes as printed fail, and what does it cost not to?";
  plan.amount = quick ? "quick" : "published";
  plan.conditions = {
      "Rays: a picture of 256 x 128 square pixels in parallel projection, two tiles across, of an endless "
      "plane of "
      "tiles (wrap); one warp of 8 x 4 pixels in four is traced, 8,192 rays a case. All of them truly hit.",
      "Maps: generated, seed 1, 8 bits, square. Functional fidelity.",
      "Everything computes in float, robust traversals and codes as printed alike. In each view all exact "
      "schedules found "
      "the same hits, bit for bit.",
      "Verdicts are against exact arithmetic on the ray as it enters the machine. A ray that ends in NaN, or "
      "has "
      "not ended after the cap of 1,000 steps, is counted as such and as nothing else.",
      "delta: the offset that the code adds to each node crossing, in leaf texels as the code scales it; "
      "slope "
      "(ours): b / E.xy in the place of (b * P2.z) / a, the same value without 0 / 0.",
  };
  if (quick) {
    plan.axes = {size_axis({"64"}),      map_axis({"fractal", "spikes"}),
                 depth_axis({"0.35"}),   angle_axis({"10", "75"}),
                 turn_axis({"0", "25"}), algorithm_axis(stability_algorithms())};
  } else {
    plan.axes = {
        size_axis({"256"}),           map_axis({"fractal", "rocks", "text", "spikes", "noise", "terraces"}),
        depth_axis({"0.05", "0.35"}), angle_axis({"0", "10", "30", "50", "75", "86", "88"}),
        turn_axis({"0", "25", "45"}), algorithm_axis(stability_algorithms())};
  }
  plan.counters = {
      {"rays", "rays", "Rays traced, one per pixel."},
      {"exact", "rays", "Rays that hit the true cell."},
      {"tie", "rays", "Rays that differ, and are right if touching counts as a hit."},
      {"missed", "rays", "Rays that miss."},
      {"behind", "rays", "Rays that hit another cell, later than the truth."},
      {"wrong_cell", "rays", "Rays that hit another cell, earlier than the truth."},
      {"nan", "rays", "Rays whose place became NaN."},
      {"unfinished", "rays", "Rays that had not ended at the cap of steps."},
      {"steps", "steps", "Steps of all rays."},
      {"longest", "steps", "Of the longest ray; the cap where one did not end."},
  };
  return plan;
}

std::unique_ptr<StudyBench> make_stability_bench(const StudyData& plan,
                                                 std::span<const uint16_t> size_and_map) {
  return std::make_unique<StabilityBench>(plan, size_and_map);
}

StudyTimes stability_times(bool quick, const StudyProgress& progress) {
  return view_times(stability_plan(quick),
                    {{"size", "256"}, {"map", "fractal"}, {"depth", "0.35"}, {"angle", "75"}, {"turn", "25"}},
                    progress);
}

}  // namespace cuesta
