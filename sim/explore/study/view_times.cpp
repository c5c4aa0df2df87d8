#include "sim/explore/study/view_times.h"

#include <algorithm>

#include "models/common/error.h"
#include "models/work/functional_run.h"
#include "sim/config/architecture_file.h"
#include "sim/explore/study/view_runner.h"
#include "sim/explore/study/wall_times.h"

namespace cuesta {
namespace {

/// Picks the value to look at on an axis: `wanted` where the plan has it, else the last one.
uint16_t index_of(const StudyAxis& axis, std::string_view wanted) {
  const auto found = std::find(axis.values.begin(), axis.values.end(), wanted);
  return static_cast<uint16_t>((found == axis.values.end() ? axis.values.end() - 1 : found) -
                               axis.values.begin());
}

class Timer : public ViewRunner {
 public:
  Timer(const StudyData& plan, const StudyPlace& view)
      : ViewRunner(plan, std::span(view).first(2), picture_pixels(false)),
        architecture_(resolve_architecture("mobile", {}, true).architecture) {}

  /// Runs no case for its counts: what counts here is how long it takes.
  std::vector<int64_t> run(const StudyPlace&) override { return {}; }

  void add(const StudyPlace& place, std::vector<TimedRun>& runs) {
    const std::string& algorithm = value(place, "algorithm");
    const Workload work = work_at(place, architecture_);
    const auto rays = static_cast<int64_t>(work.rays.size());
    if (work.search) {
      const double seconds =
          median_seconds([&] { const SearchMap map(*work.search, pyramid_, map_.address_mode); });
      runs.push_back({"", algorithm, "map", seconds, 0, 0});
    } else {
      HeightGrid grid{map_.width, map_.height, map_.bits, {}};
      grid.texels.assign(pyramid_.level(0), pyramid_.level(0) + map_.width * map_.height);
      runs.push_back({"", algorithm, "map", median_seconds([&] { build_max_pyramid(grid); }), 0, 0});
    }
    runs.push_back({"", algorithm, "functional", median_seconds([&] { run_functional(work); }), rays, 0});
    TimedRun cycle{"mobile", algorithm, "cycle", 0, rays, 0};
    cycle.seconds = median_seconds(
        [&] { cycle.cycles = run_cycle(work, architecture_).measurements.counters.get("machine.cycles"); });
    runs.push_back(std::move(cycle));
  }

 private:
  Architecture architecture_;
};

}  // namespace

StudyTimes view_times(const StudyData& plan,
                      const std::vector<std::pair<std::string_view, std::string_view>>& wanted,
                      const StudyProgress& progress) {
  StudyTimes times = times_of_this_host(
      "One picture of the study; whole runs with counters, planes and digests; the making of rays left out; "
      "median "
      "of three.");
  StudyPlace place;
  for (const auto& [axis, value] : wanted) {
    const StudyAxis& one = plan.axes[axis_index(plan, axis)];
    place.push_back(index_of(one, value));
    times.view.emplace_back(axis, one.values[place.back()]);
  }
  place.push_back(0);
  Timer timer(plan, place);
  const size_t all = plan.axes.back().values.size();
  for (size_t k = 0; k < all; ++k) {
    if (progress && !progress(k, all))
      throw Error(ExitCode::kIncomplete, "Stopped while wall times were measured.");
    place.back() = static_cast<uint16_t>(k);
    timer.add(place, times.runs);
  }
  return times;
}

}  // namespace cuesta
