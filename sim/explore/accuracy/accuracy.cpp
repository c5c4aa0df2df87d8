#include "sim/explore/accuracy/accuracy.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "models/common/statistics.h"
#include "models/work/hit_judge.h"
#include "sim/config/architecture_file.h"
#include "sim/explore/accuracy/accuracy_pictures.h"
#include "sim/explore/accuracy/picture_error.h"
#include "sim/explore/study/ray_ends.h"
#include "sim/explore/study/view_runner.h"
#include "sim/explore/study/view_times.h"

namespace cuesta {
namespace {

constexpr std::string_view kName = "accuracy";

/// The root mean square in parts, as errors are counted; 0 without errors.
int64_t root_mean_square(const std::vector<double>& errors) {
  double squares = 0;
  for (const double error : errors) squares += error * error;
  return errors.empty() ? 0 : in_error_parts(std::sqrt(squares / static_cast<double>(errors.size())));
}

class AccuracyRunner : public ViewRunner {
 public:
  AccuracyRunner(const StudyData& plan, std::span<const uint16_t> size_and_map)
      : ViewRunner(plan, size_and_map, picture_pixels(false)),
        architecture_(resolve_architecture("mobile", {}, true).architecture) {}

  std::vector<int64_t> run(const StudyPlace& place) override {
    const Workload work = work_at(place, architecture_);
    const Outcome outcome = run_cycle(work, architecture_);
    check_laws(work, architecture_, Fidelity::kCycle, outcome);
    if (!work.search) check_same_hits(place, outcome.hits);
    HitJudge& judge = judge_of(place, work);
    const Judgement found = judge.judge(outcome.hits, work.arithmetic);
    for (size_t k = 0; k < outcome.hits.size(); ++k) {
      depths_[k] = judge.depth_of(k, outcome.hits[k], work.arithmetic);
    }
    const PictureError picture = picture_error(true_depths_, depths_, kViewWidth);
    const Histogram heights = error_histogram("height_error", found.height_errors);
    const Histogram texels = error_histogram("texel_error", found.texel_errors);
    const Counters& counters = outcome.measurements.counters;
    const PreprocessingCost cost = work.search ? work.search_map->cost() : PreprocessingCost{};
    std::vector<int64_t> values = {counters.get("machine.rays")};
    const std::vector<int64_t> verdicts = verdict_counts(found);
    values.insert(values.end(), verdicts.begin(), verdicts.end());
    values.insert(
        values.end(),
        {root_mean_square(found.height_errors), heights.p99, heights.max,
         root_mean_square(found.texel_errors), texels.p99, texels.max, picture.psnr, picture.ssim,
         counters.get("machine.steps"), counters.get("machine.cycles"), counters.get("dram.read_bytes"),
         counters.get("machine.texel_bytes"), static_cast<int64_t>(cost.texels_read),
         work.search
             ? static_cast<int64_t>(work.search_map->size_bytes())
             : static_cast<int64_t>(TexelLayout(architecture_.texels.layout, pyramid_).size_bytes())});
    return values;
  }

 private:
  /// Gives the judge and makes the true picture of the place's rays, the same for all algorithms.
  HitJudge& judge_of(const StudyPlace& place, const Workload& work) {
    const std::string view = value(place, "depth") + "/" + value(place, "angle");
    if (!judge_ || view != view_) {
      judge_.emplace(work);
      view_ = view;
      depths_.resize(work.rays.size());
      true_depths_.clear();
      for (size_t k = 0; k < work.rays.size(); ++k) {
        true_depths_.push_back(judge_->depth_of(k, judge_->truth()[k], Arithmetic::kDouble));
      }
    }
    return *judge_;
  }

  Architecture architecture_;
  std::optional<HitJudge> judge_;
  std::string view_;  ///< of judge_
  std::vector<double> true_depths_, depths_;
};

/// Lists each search with its own parameter from few steps to many.
std::vector<std::string> accuracy_algorithms() {
  std::vector<std::string> list = {"dda", "oh2006", "yun2013", "normal", "parallax", "parallax-limited"};
  const auto steps = [&](const std::string& name, std::initializer_list<int> counts) {
    for (const int count : counts)
      list.push_back(name_of(parse_search(name + ":steps=" + std::to_string(count))));
  };
  steps("steep", {4, 8, 16, 32, 64, 128, 256, 512});
  steps("pom-printed", {64});
  steps("pom", {8, 16, 32, 64, 128, 256, 512});
  steps("pom-tatarchuk", {50});
  steps("relief", {4, 8, 16, 32, 64, 100, 256, 512});
  steps("interval", {4, 8, 16, 32, 64, 128, 256, 512});
  steps("cone", {4, 8, 16, 32, 64, 100, 256, 512});
  steps("relaxed-cone", {4, 8, 15, 32, 64, 128});
  steps("distance", {4, 8, 16, 32, 64});
  steps("safety-radius", {8, 16, 32, 64, 128, 256});
  return list;
}

StudyData make_plan(bool quick) {
  StudyData plan = begin_plan(
      kName, "How wrong is each algorithm, and what does being right cost in steps, cycles and bytes?",
      quick);
  plan.conditions = view_conditions();
  plan.conditions.back() =
      "Traversal: fixed point with the default widths. In each view every exact algorithm found the same "
      "hits, bit for "
      "bit.";
  add_conditions(
      plan,
      {"The surface is of constant texels for all; searches sample it at points (no filter) and compute in "
       "float. Verdicts are against exact arithmetic on the ray as it enters the machine. mobile, cycle "
       "fidelity, cold caches.",
       "A depth error is taken along the ray, over rays that hit and truly hit; the depth picture is how far "
       "down the slab each pixel sees, 0 to 1."});
  if (quick) {
    plan.axes = {size_axis({"64"}), map_axis({"fractal", "spikes"}), depth_axis({"0.35"}),
                 angle_axis({"10", "75"}),
                 algorithm_axis({"yun2013", "parallax", "steep:steps=16", "relief", "cone", "relaxed-cone"})};
  } else {
    plan.axes = {size_axis({"256"}), map_axis(study_maps()), depth_axis({"0.05", "0.35"}),
                 angle_axis({"0", "30", "60", "75", "88"}), algorithm_axis(accuracy_algorithms())};
  }
  const std::string height_parts = fmt::format("height LSB / {}", kErrorParts),
                    texel_parts = fmt::format("texels / {}", kErrorParts);
  const char* const kAlong = "Along the ray, as a difference in height: ";
  const char* const kPlane = "Along the ray, in the plane of the map: ";
  plan.counters = {{"rays", "rays", "Rays traced, one per pixel; all of them truly hit."}};
  const std::vector<StudyCounter> verdicts = verdict_counters();
  plan.counters.insert(plan.counters.end(), verdicts.begin(), verdicts.end());
  plan.counters.insert(
      plan.counters.end(),
      {
          {"height_rms", height_parts, std::string(kAlong) + "root mean square over the rays that hit."},
          {"height_p99", height_parts, std::string(kAlong) + "99th percentile."},
          {"height_max", height_parts, std::string(kAlong) + "the largest."},
          {"texel_rms", texel_parts, std::string(kPlane) + "root mean square over the rays that hit."},
          {"texel_p99", texel_parts, std::string(kPlane) + "99th percentile."},
          {"texel_max", texel_parts, std::string(kPlane) + "the largest."},
          {"psnr", "dB / 100",
           "Peak signal-to-noise ratio of the depth picture; 100 dB where nothing differs."},
          {"ssim", "1 / 1,000,000", "Structural similarity of the depth picture, windows of 8 x 8 pixels."},
          {"steps", "steps", "Steps of all rays: node visits, or steps of the search."},
          {"cycles", "cycles", "Cycles of the machine until the last hit record is acknowledged."},
          {"dram_read_bytes", "bytes", "Bytes read from DRAM."},
          {"texel_bytes", "bytes",
           "Bytes of the texels or records that the steps read: the traffic without a cache."},
          {"preprocessing_texels", "texels",
           "Texels that the making of the search's map read; the pyramid's not counted."},
          {"map_bytes", "bytes", "Bytes of what the rays read: the pyramid, or the search's map."},
      });
  return plan;
}

StudyTimes measure_times(bool quick, const StudyProgress& progress) {
  return view_times(make_plan(quick),
                    {{"size", "256"}, {"map", "rockbump"}, {"depth", "0.35"}, {"angle", "75"}}, progress);
}

}  // namespace

Study accuracy_study() {
  return {.name = kName,
          .plan = make_plan,
          .make_runner = make_case_runner<AccuracyRunner>,
          .page = accuracy_page,
          .headline = accuracy_headline,
          .pictures = accuracy_pictures,
          .times = measure_times,
          .timed_page = accuracy_timed_page};
}

}  // namespace cuesta
