#include "sim/explore/accuracy/accuracy_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "models/work/functional_run.h"
#include "models/work/hit_judge.h"
#include "reports/numbers.h"
#include "reports/panel_grid.h"
#include "sim/config/on_architecture.h"
#include "sim/session/job.h"

namespace cuesta {
namespace {

/// What one picture shows.
struct Subject {
  const char* name;
  const char* scene;
  double angle_degrees, depth;
  std::vector<std::string> algorithms;
  const char* caption;
};

std::vector<Subject> subjects() {
  return {
      {"relief-cone-pyramid-front",
       "rockbump-front",
       30,
       0.35,
       {"relief", "cone", "oh2006"},
       "Relief mapping with 100 linear and 7 binary steps, cone stepping with at most 100, and the pyramid, "
       "at depth "
       "0.35: the comparison that Ki & Oh 2007 make in their figures 1 and 11 (their views are not at hand; "
       "map, "
       "camera and colours are ours)."},
      {"relief-cone-pyramid-grazing",
       "rockbump-grazing",
       80,
       0.35,
       {"relief", "cone", "oh2006"},
       "The same at a grazing angle, where the linear search steps over thin stones and some rays run out of "
       "cones."},
      {"aliasing",
       "text-oblique",
       75,
       0.1,
       {"pom:steps=8", "pom", "pom-printed", "yun2013"},
       "The aliasing of a linear search with few samples, which Luna 2012 shows in figure 7 (scene ours): "
       "slices "
       "where walls should be. As printed, the first sample is compared one step late as well."},
  };
}

struct Traced {
  std::vector<HitRecord> hits;
  Judgement judgement;
};

class Painter {
 public:
  Painter(const Subject& subject, bool quick) {
    SceneChanges changes;
    changes.angle_degrees = subject.angle_degrees;
    changes.depth = subject.depth;
    changes.size = quick ? std::pair{160, 120} : std::pair{320, 240};
    job_ = prepare_job(subject.scene, changes);
    const NumberFormat format = number_format(architecture_.traverse, job_.map);
    rays_ = machine_rays(job_, format);
    grid_.width = job_.trace.width;
    grid_.height = job_.trace.height;
    judge_.emplace(workload_of(job_, architecture_, rays_, *find_algorithm("yun2013")));
  }

  Picture paint(const std::vector<std::string>& names) {
    std::vector<Traced> traced;
    uint32_t most_steps = 1;
    for (const std::string& name : names) {
      const Algorithm algorithm = parse_algorithm(name);
      std::optional<SearchMap> map;
      if (algorithm.search) map.emplace(*algorithm.search, job_.pyramid, job_.map.address_mode);
      Traced one;
      one.hits =
          run_functional(workload_of(job_, architecture_, rays_, algorithm, map ? &*map : nullptr)).hits;
      one.judgement = judge_->judge(one.hits, architecture_.traverse.arithmetic);
      for (const HitRecord& hit : one.hits) most_steps = std::max(most_steps, hit.steps);
      traced.push_back(std::move(one));
    }
    for (size_t c = 0; c < names.size(); ++c) {
      int64_t wrong = 0;
      for (size_t k = 0; k < rays_.size(); ++k) wrong += traced[c].judgement.wrong(k);
      grid_.columns.push_back(
          fmt::format("{}: {} wrong", names[c],
                      readable(static_cast<double>(wrong) / static_cast<double>(rays_.size()), "fraction")));
    }
    add_row("depth: yellow above, violet below", traced, [&](const Traced& one, size_t k) {
      return panel_colour(1 - judge_->depth_of(k, one.hits[k], architecture_.traverse.arithmetic));
    });
    add_row(fmt::format("steps: violet 0 to yellow {}", most_steps), traced,
            [&](const Traced& one, size_t k) {
              return panel_colour(static_cast<double>(one.hits[k].steps) / most_steps);
            });
    add_row("wrong pixels in red", traced, [&](const Traced& one, size_t k) {
      return one.judgement.wrong(k)
                 ? kPanelMark
                 : panel_grey(1 - judge_->depth_of(k, one.hits[k], architecture_.traverse.arithmetic));
    });
    return panel_picture(grid_);
  }

 private:
  template <class Paint>
  void add_row(const std::string& title, const std::vector<Traced>& traced, Paint&& paint) {
    grid_.rows.push_back(title);
    auto& row = grid_.panels.emplace_back();
    for (const Traced& one : traced) {
      auto& panel =
          row.emplace_back(static_cast<size_t>(grid_.width) * static_cast<size_t>(grid_.height), kPanelEmpty);
      for (size_t k = 0; k < rays_.size(); ++k) panel[job_.pixel_of_ray[k]] = paint(one, k);
    }
  }

  Architecture architecture_;
  Job job_;
  std::vector<MachineRay> rays_;
  std::optional<HitJudge> judge_;
  PanelGrid grid_;
};

}  // namespace

std::vector<StudyPicture> accuracy_pictures(bool quick) {
  std::vector<StudyPicture> pictures;
  for (const Subject& subject : subjects()) {
    pictures.push_back(
        {subject.name, subject.caption, encode_png(Painter(subject, quick).paint(subject.algorithms))});
  }
  return pictures;
}

}  // namespace cuesta
