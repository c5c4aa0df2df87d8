#include "reports/study/view_times_section.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/html/html_text.h"
#include "reports/numbers.h"

namespace cuesta::html {
namespace {

/// The times of a view beside what the study counted in it.
class Beside {
 public:
  Beside(const StudyTable& table, const StudyTimes& times, const TimedView& view)
      : table_(table), times_(times), view_(view) {}

  std::string section() const {
    std::string view;
    for (const auto& [axis, value] : times_.view) view += (view.empty() ? "" : ", ") + axis + " " + value;
    const std::string lead = measured_sentences(times_) + " The view: " + view +
                             ". Exact algorithms read the max pyramid, searches a map of their own. "
                             "Functional, exact algorithms walk 16 "
                             "rays at a time where the processor has AVX-512; searches take one. Only ratios "
                             "within one measurement say "
                             "something elsewhere.";
    return study_section(
        view_.title, escape(lead),
        choice("walltime",
               {{"functional", plot("functional")}, {"cycle", plot("cycle")}, {"table", rows()}}));
  }

 private:
  const TimedRun* run_of(const std::string& algorithm, std::string_view level) const {
    for (const TimedRun& run : times_.runs) {
      if (run.algorithm == algorithm && run.level == level) return &run;
    }
    return nullptr;
  }

  /// nullopt where the study has no such case.
  std::optional<double> error_of(const std::string& algorithm) const {
    Where where = {{"algorithm", algorithm}};
    for (const auto& [axis, value] : times_.view) where.emplace_back(axis, value);
    const std::vector<StudyPlace> places = places_where(table_, where);
    return places.size() == 1 ? view_.error(places[0]) : std::nullopt;
  }

  std::string plot(const std::string& level) const {
    ScatterPlot plot;
    plot.title = "Error against wall time, " + level;
    plot.remark =
        "one view; a dot's area: the wall time of making what the rays read; dashed: the Pareto front";
    plot.x_label = "wall time per ray, µs (logarithmic)";
    plot.y_label = std::string(view_.error_name) + ", % (logarithmic above 0)";
    plot.front = true;
    for (const std::string& algorithm : table_.axis("algorithm").values) {
      const TimedRun* const run = run_of(algorithm, level);
      const TimedRun* const map = run_of(algorithm, "map");
      const auto error = error_of(algorithm);
      if (run == nullptr || map == nullptr || !error || run->rays == 0) continue;
      const double per_ray = 1e6 * run->seconds / static_cast<double>(run->rays);
      add_point(view_.kind_of(algorithm),
                {per_ray, *error, 1e3 * map->seconds,
                 fmt::format("{}\n{} %: {}\n{} µs/ray\n{} ms to make what rays read", algorithm,
                             significant(*error, 3), view_.error_name, significant(per_ray, 3),
                             significant(1e3 * map->seconds, 3))},
                plot);
    }
    return svg_scatter_plot(plot);
  }

  std::string rows() const {
    std::vector<std::vector<std::string>> rows;
    for (const std::string& algorithm : table_.axis("algorithm").values) {
      const auto error = error_of(algorithm);
      const TimedRun* const map = run_of(algorithm, "map");
      if (!error || map == nullptr) continue;
      std::vector<std::string> row = {escape(algorithm), significant(*error, 3) + " %",
                                      significant(1e3 * map->seconds, 3) + " ms"};
      for (const char* level : {"functional", "cycle"}) {
        const TimedRun* const run = run_of(algorithm, level);
        const TimedRun* const base = run_of(view_.base, level);
        const bool both = run != nullptr && base != nullptr && base->seconds > 0;
        row.push_back(both ? significant(1e3 * run->seconds, 3) + " ms" : "-");
        row.push_back(both ? "× " + significant(run->seconds / base->seconds, 3) : "-");
      }
      rows.push_back(std::move(row));
    }
    const std::string against = std::string("of ") + view_.base + "'s";
    return with_firm_spaces(
        plain_table({"one view", view_.error_name, "making what<br>rays read", "functional<br>a frame",
                     against, "cycle, mobile<br>a frame", against},
                    rows));
  }

  const StudyTable& table_;
  const StudyTimes& times_;
  const TimedView& view_;
};

}  // namespace

void add_point(const std::string& kind, ScatterPoint point, ScatterPlot& plot) {
  auto series = std::find_if(plot.series.begin(), plot.series.end(),
                             [&](const ScatterSeries& one) { return one.label == kind; });
  if (series == plot.series.end()) {
    const bool after_exact = !plot.series.empty() && plot.series.front().label == "exact";
    plot.series.push_back(
        {kind, kind == "exact" ? "exact" : series_class(plot.series.size() - (after_exact ? 1 : 0)), {}});
    series = plot.series.end() - 1;
  }
  series->points.push_back(std::move(point));
}

std::string view_times_section(const StudyTable& table, const StudyTimes& times, const TimedView& view) {
  return Beside(table, times, view).section();
}

}  // namespace cuesta::html
