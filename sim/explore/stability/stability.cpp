#include "sim/explore/stability/stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "models/algorithms/schedule.h"
#include "models/work/functional_run.h"
#include "models/work/hit_judge.h"
#include "reports/numbers.h"
#include "sim/explore/study/ray_ends.h"
#include "sim/explore/study/view_runner.h"
#include "sim/explore/study/view_times.h"

namespace cuesta {
namespace {

constexpr std::string_view kName = "stability";

class StabilityRunner : public ViewRunner {
 public:
  StabilityRunner(const StudyData& plan, std::span<const uint16_t> size_and_map)
      : ViewRunner(plan, size_and_map, picture_pixels(true)) {}

  std::vector<int64_t> run(const StudyPlace& place) override {
    Workload work = work_at(place);
    work.arithmetic = Arithmetic::kFloat;
    const Outcome outcome = run_functional(work);
    if (!work.search) check_same_hits(place, outcome.hits);
    const std::string view = value(place, "depth") + "/" + value(place, "angle") + "/" + value(place, "turn");
    if (!judge_ || view != view_) {
      judge_.emplace(work);
      view_ = view;
    }
    const Judgement found = judge_->judge(outcome.hits, work.arithmetic);
    int64_t steps = 0, longest = 0;
    for (const HitRecord& hit : outcome.hits) {
      steps += hit.steps;
      longest = std::max<int64_t>(longest, hit.steps);
    }
    std::vector<int64_t> values = {static_cast<int64_t>(outcome.hits.size())};
    const std::vector<int64_t> verdicts = verdict_counts(found);
    values.insert(values.end(), verdicts.begin(), verdicts.end());
    values.insert(values.end(), {found.not_numbers, found.unfinished, steps, longest});
    return values;
  }

 private:
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

StudyData make_plan(bool quick) {
  StudyData plan = begin_plan(
      kName,
      "What is robustness worth: how often do the codes as printed fail, and what does it cost not to?",
      quick);
  plan.conditions = {
      fmt::format("Rays: a picture of {} x {} square pixels in parallel projection, two tiles across, of an "
                  "endless plane of tiles (wrap); one warp of {} x {} pixels in four is traced, {} rays a "
                  "case. All of them truly hit.",
                  kViewWidth, kViewHeight, kWarpWidth, kWarpHeight,
                  grouped(static_cast<int64_t>(picture_pixels(true).size()))),
      "Maps: generated, seed 1, 8 bits, square. Functional fidelity.",
      "Everything computes in float, robust traversals and codes as printed alike. In each view all exact "
      "schedules found the same hits, bit for bit.",
      fmt::format(
          "Verdicts are against exact arithmetic on the ray as it enters the machine. A ray that ends in "
          "NaN, or has not ended after the cap of {} steps, is counted as such and as nothing else.",
          grouped(parse_search("ki2007-printed").steps)),
      "delta: the offset that the code adds to each node crossing, in leaf texels as the code scales it; "
      "slope (ours): b / E.xy in the place of (b * P2.z) / a, the same value without 0 / 0.",
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
  plan.counters = {{"rays", "rays", "Rays traced, one per pixel."}};
  const std::vector<StudyCounter> verdicts = verdict_counters();
  plan.counters.insert(plan.counters.end(), verdicts.begin(), verdicts.end());
  plan.counters.insert(plan.counters.end(),
                       {
                           {"nan", "rays", "Rays whose place became NaN."},
                           {"unfinished", "rays", "Rays that had not ended at the cap of steps."},
                           {"steps", "steps", "Steps of all rays."},
                           {"longest", "steps", "Of the longest ray; the cap where one did not end."},
                       });
  return plan;
}

StudyTimes measure_times(bool quick, const StudyProgress& progress) {
  return view_times(make_plan(quick),
                    {{"size", "256"}, {"map", "fractal"}, {"depth", "0.35"}, {"angle", "75"}, {"turn", "25"}},
                    progress);
}

}  // namespace

Study stability_study() {
  return {.name = kName,
          .plan = make_plan,
          .make_runner = make_case_runner<StabilityRunner>,
          .page = stability_page,
          .headline = stability_headline,
          .times = measure_times,
          .timed_page = stability_timed_page};
}

}  // namespace cuesta
