#include "sim/explore/study/ray_ends.h"

#include <fmt/format.h>

#include "reports/study/study_selection.h"

namespace cuesta {

std::vector<StudyCounter> verdict_counters() {
  return {{"exact", "rays", "Rays that hit the true cell."},
          {"tie", "rays", "Rays that differ, and are right if touching counts as a hit."},
          {"missed", "rays", "Rays that miss."},
          {"behind", "rays", "Rays that hit another cell, later than the truth."},
          {"wrong_cell", "rays", "Rays that hit another cell, earlier than the truth."}};
}

std::vector<int64_t> verdict_counts(const Judgement& judgement) {
  return {judgement.counts.of.begin(), judgement.counts.of.end()};
}

const std::vector<std::string>& wrong_counters() {
  static const std::vector<std::string> kWrong = {"missed", "behind", "wrong_cell"};
  return kWrong;
}

namespace html {

void add_ray_ends(const StudyTable& table, std::span<const RayEnd> ends,
                  const std::function<std::string(double)>& percent,
                  const std::function<Bar(const std::string& algorithm)>& bar, BarPlot& plot) {
  for (const RayEnd& end : ends) plot.legend.push_back({end.colour, end.counter, end.meaning});
  for (const std::string& algorithm : table.axis("algorithm").values) {
    const std::vector<StudyPlace> places = places_where(table, {{"algorithm", algorithm}});
    if (places.empty()) continue;
    Bar next = bar(algorithm);
    for (const RayEnd& end : ends) {
      const auto share = share_of_rays(table, places, {end.counter});
      if (!share) continue;
      next.segments.push_back(
          {end.colour, *share,
           fmt::format("{}\n{}: {}\n{}", algorithm, end.counter, percent(*share), end.meaning), ""});
    }
    plot.bars.push_back(std::move(next));
  }
}

}  // namespace html
}  // namespace cuesta
