#include "sim/explore/study/study_runner.h"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include "models/common/error.h"

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

/// Workers take batches from the last, the costly ones, to the first; the calling thread watches.
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
    std::vector<std::thread> threads;
    running_ = workers;
    for (int k = 0; k < workers; ++k) threads.emplace_back([this] { work(); });
    {
      std::unique_lock lock(mutex_);
      while (running_ > 0) {
        changed_.wait_for(lock, std::chrono::milliseconds(100));
        const uint64_t finished = finished_;
        lock.unlock();
        const bool go_on = !progress || progress(finished, places_.size());
        lock.lock();
        stop_ = stop_ || !go_on;
      }
    }
    for (std::thread& thread : threads) thread.join();
    if (failure_) std::rethrow_exception(failure_);
  }

  std::vector<StudyCase> cases() && {
    std::vector<StudyCase> cases;
    for (size_t k = 0; k < places_.size(); ++k) {
      if (!counts_[k].empty()) cases.push_back({std::move(places_[k]), std::move(counts_[k])});
    }
    return cases;
  }

 private:
  bool take(Batch& batch) {
    const std::lock_guard lock(mutex_);
    if (stop_ || batches_.empty()) return false;
    batch = batches_.back();
    batches_.pop_back();
    return true;
  }

  /// Takes a case's counts; false: no more cases are wanted.
  bool finish(size_t place, std::vector<int64_t> counts) {
    const std::lock_guard lock(mutex_);
    counts_[place] = std::move(counts);
    ++finished_;
    return !stop_;
  }

  void run_batch(const Batch& batch) {
    const auto runner = study_.make_runner(plan_, std::span(places_[batch.first]).first(study_.shared_axes));
    for (size_t k = batch.first; k < batch.end; ++k) {
      // Only this worker writes the batch's counts.
      if (counts_[k].empty() && !finish(k, runner->run(places_[k]))) return;
    }
  }

  void work() {
    try {
      for (Batch batch{}; take(batch);) run_batch(batch);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      stop_ = true;
    }
    const std::lock_guard lock(mutex_);
    --running_;
    changed_.notify_all();
  }

  const Study& study_;
  const StudyData& plan_;
  std::vector<StudyPlace> places_;
  std::vector<Batch> batches_;
  std::vector<std::vector<int64_t>> counts_;  ///< by place; empty: not finished
  std::mutex mutex_;
  std::condition_variable changed_;
  uint64_t finished_ = 0;
  int running_ = 0;
  bool stop_ = false;
  std::exception_ptr failure_;
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
