#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/study/study_data.h"
#include "reports/study/study_times.h"

namespace cuesta {

/// Runs the cases of one combination of a study's shared axes, and holds what they have in common: a map and
/// its pyramid, say.
class CaseRunner {
 public:
  virtual ~CaseRunner() = default;
  /// Runs one case and returns its counts, as many as the plan has counters, from the place alone. Throws as
  /// running a machine does, and Error(kMismatch) where cases that must agree do not.
  virtual std::vector<int64_t> run(const StudyPlace& place) = 0;
};

/// Makes the runner of one combination, for `make_runner` of a study; the plan must outlive it.
template <class Runner>
std::unique_ptr<CaseRunner> make_case_runner(const StudyData& plan, std::span<const uint16_t> shared_place) {
  return std::make_unique<Runner>(plan, shared_place);
}

/// Is called a few times a second from the calling thread with cases finished and in all; returning false
/// ends the study early.
using StudyProgress = std::function<bool(uint64_t finished, uint64_t all)>;

/// A published question. A new one is a folder beside this one, with a plan, a runner of cases and a page,
/// and a row in the list of studies.cpp; the build, the verb, the files and the tests take it from there.
struct Study {
  std::string_view name;
  /// Gives the whole matrix without cases; `quick`: a small part of it, for tests. Axes on which cases cost
  /// more come first, and on them the costly values last.
  StudyData (*plan)(bool quick) = nullptr;
  /// How many axes, the first ones, cases share: each combination of them has one runner, used by one worker.
  size_t shared_axes = 2;
  /// Says whether a place of the product is a case; nullptr: each is.
  bool (*planned)(const StudyData& plan, const StudyPlace& place) = nullptr;
  std::unique_ptr<CaseRunner> (*make_runner)(const StudyData& plan,
                                             std::span<const uint16_t> shared_place) = nullptr;
  /// Makes the page, one self-contained HTML file, from the data alone: every number on it is computed from
  /// them or printed in the literature, and says which.
  std::string (*page)(const StudyData& data) = nullptr;
  /// Says in one sentence, the first on the page, what an architect takes away.
  std::string (*headline)(const StudyData& data) = nullptr;
  /// Makes the pictures that belong to the page; nullptr: it has none.
  std::vector<StudyPicture> (*pictures)(bool quick) = nullptr;
  /// Measures what `--times` adds on this host; nullptr: the study has no wall times.
  StudyTimes (*times)(bool quick, const StudyProgress& progress) = nullptr;
  /// Makes the page that shows wall times too; there where `times` is.
  std::string (*timed_page)(const StudyData& data, const StudyTimes& times) = nullptr;
};

/// Returns every study there is, in the order in which they are listed.
std::span<const Study> studies();
/// Throws usage_error naming those there are.
const Study& find_study(std::string_view name);

}  // namespace cuesta
