#include "sim/explore/study/study_runner.h"

#include <algorithm>
#include <atomic>
#include <map>

#include "models/common/error.h"
#include "sim/session/parallel.h"

namespace cuesta {
namespace {

bool next_place(const StudyData& plan, StudyPlace& place) {
  for (size_t a = plan.axes.size(); a-- > 0;) {
    if (++place[a] < plan.axes[a].values.size()) return true;
    place[a] = 0;
  }
  return false;
}

/// Places that share a runner; taken whole by one worker.
struct Batch {
  size_t first, end;
};

std::vector<Batch> batches_of(const Study& study, const std::vector<StudyPlace>& places) {
  std::vector<Batch> batches;
  const auto shared = static_cast<std::ptrdiff_t>(study.shared_axes);
  for (size_t k = 0; k < places.size(); ++k) {
    const bool same = !batches.empty() && std::equal(places[k].begin(), places[k].begin() + shared,
                                                     places[batches.back().first].begin());
    if (same) {
      batches.back().end = k + 1;
    } else {
      batches.push_back({k, k + 1});
    }
  }
  return batches;
}

/// Finds the cases of an earlier study by their place in this plan; places that this plan does not have are
/// left out.
std::map<StudyPlace, const StudyCase*> known_places(const StudyData& plan, const StudyData& earlier) {
  auto same = [](const auto& a, const auto& b) { return a.name == b.name; };
  const bool fits =
      plan.study == earlier.study && plan.conditions == earlier.conditions &&
      std::equal(plan.axes.begin(), plan.axes.end(), earlier.axes.begin(), earlier.axes.end(), same) &&
      std::equal(plan.counters.begin(), plan.counters.end(), earlier.counters.begin(), earlier.counters.end(),
                 same);
  if (!fits) {
    throw usage_error(
        "The earlier data are not of the same study with the same conditions and counters; accepted: "
        "those that an earlier or stopped `study " +
        plan.study + "` of this version has left.");
  }
  const StudyTable table(plan);
  std::map<StudyPlace, const StudyCase*> known;
  for (const StudyCase& one : earlier.cases) {
    StudyPlace place;
    for (size_t a = 0; a < plan.axes.size(); ++a) {
      const auto found = table.find(plan.axes[a].name, earlier.axes[a].values[one.place[a]]);
      if (found) place.push_back(*found);
    }
    if (place.size() == plan.axes.size()) known[place] = &one;
  }
  return known;
}

/// Runs batches from the last, the costly ones, to the first, and keeps their counts by place.
class Work {
 public:
  Work(const Study& study, const StudyData& plan, std::vector<StudyPlace> places)
      : study_(study),
        plan_(plan),
        places_(std::move(places)),
        batches_(batches_of(study, places_)),
        counts_(places_.size()) {}

  void take_over(const StudyData& earlier) {
    const std::map<StudyPlace, const StudyCase*> known = known_places(plan_, earlier);
    for (size_t k = 0; k < places_.size(); ++k) {
      const auto found = known.find(places_[k]);
      if (found == known.end()) continue;
      counts_[k] = found->second->values;
      ++finished_;
    }
    std::erase_if(batches_, [&](const Batch& batch) {
      return std::none_of(counts_.begin() + static_cast<std::ptrdiff_t>(batch.first),
                          counts_.begin() + static_cast<std::ptrdiff_t>(batch.end),
                          [](const std::vector<int64_t>& counts) { return counts.empty(); });
    });
  }

  void run(int workers, const StudyProgress& progress) {
    parallel_for(
        batches_.size(), workers,
        [this](size_t number, const std::atomic<bool>& stop) {
          run_batch(batches_[batches_.size() - 1 - number], stop);
        },
        [&] { return !progress || progress(finished_, places_.size()); });
  }

  std::vector<StudyCase> cases() && {
    std::vector<StudyCase> cases;
    for (size_t k = 0; k < places_.size(); ++k) {
      if (!counts_[k].empty()) cases.push_back({std::move(places_[k]), std::move(counts_[k])});
    }
    return cases;
  }

 private:
  /// Writes the counts of its batch, which no other thread looks at; stopped, it ends the case that it runs.
  void run_batch(const Batch& batch, const std::atomic<bool>& stop) {
    const auto runner = study_.make_runner(plan_, std::span(places_[batch.first]).first(study_.shared_axes));
    for (size_t k = batch.first; k < batch.end; ++k) {
      if (!counts_[k].empty()) continue;
      counts_[k] = runner->run(places_[k]);
      ++finished_;
      if (stop) return;
    }
  }

  const Study& study_;
  const StudyData& plan_;
  std::vector<StudyPlace> places_;
  std::vector<Batch> batches_;
  std::vector<std::vector<int64_t>> counts_;  ///< by place; empty: not finished
  std::atomic<uint64_t> finished_ = 0;
};

}  // namespace

std::vector<StudyPlace> planned_places(const Study& study, const StudyData& plan) {
  std::vector<StudyPlace> places;
  StudyPlace place(plan.axes.size(), 0);
  do {
    if (study.planned == nullptr || study.planned(plan, place)) places.push_back(place);
  } while (next_place(plan, place));
  return places;
}

StudyData run_study(const Study& study, bool quick, int workers, const StudyProgress& progress,
                    const StudyData* earlier) {
  if (workers < 1 || workers > 64) {
    throw usage_error("A study on " + std::to_string(workers) + " workers was asked for; accepted: 1 to 64.");
  }
  StudyData data = study.plan(quick);
  Work work(study, data, planned_places(study, data));
  if (earlier != nullptr) work.take_over(*earlier);
  work.run(workers, progress);
  data.planned = planned_places(study, data).size();
  data.cases = std::move(work).cases();
  return data;
}

std::vector<StudyCase> run_cases(const Study& study, const StudyData& plan,
                                 const std::vector<StudyPlace>& places) {
  std::vector<StudyCase> cases;
  for (const Batch& batch : batches_of(study, places)) {
    const auto runner = study.make_runner(plan, std::span(places[batch.first]).first(study.shared_axes));
    for (size_t k = batch.first; k < batch.end; ++k) cases.push_back({places[k], runner->run(places[k])});
  }
  return cases;
}

}  // namespace cuesta
