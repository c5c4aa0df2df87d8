#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "reports/study/study_data.h"
#include "reports/study/study_times.h"

namespace cuesta {

/// What the cases of one combination of a study's shared axes have in common: a map and its pyramid, say.
class StudyBench {
 public:
  virtual ~StudyBench() = default;
  /// One case: its counts, as many as the plan has counters, from the place alone. Throws as running a machine does,
  /// and Error(kMismatch) where cases that must agree do not.
  virtual std::vector<int64_t> run(const StudyPlace& place) = 0;
};

/// Called a few times a second from the calling thread with cases finished and in all; false ends the study early.
using StudyProgress = std::function<bool(uint64_t finished, uint64_t all)>;

/// A published question. A new study: a file of its own with plan, bench and page, and a row in the table of
/// studies.cpp; runner, files, verb and tests take it from there.
struct Study {
  std::string_view name;
  /// The whole matrix without cases; `quick`: a small part of it, for tests. Axes on which cases cost more come first,
  /// and on them the costly values last.
  StudyData (*plan)(bool quick);
  size_t shared_axes;  ///< the first so many axes: each combination of them is one bench, used by one worker
  bool (*planned)(const StudyData& plan, const StudyPlace& place);  ///< nullptr: the whole product
  std::unique_ptr<StudyBench> (*make_bench)(const StudyData& plan, std::span<const uint16_t> shared_place);
  std::string (*page)(const StudyData& data);      ///< the page, from the data alone
  std::string (*headline)(const StudyData& data);  ///< one sentence: what an architect takes away
  std::vector<StudyPicture> (*pictures)(bool quick) = nullptr;  ///< nullptr: none
  /// What `--times` measures on this host, and the page that shows it too; nullptr: the study has none.
  StudyTimes (*times)(bool quick, const StudyProgress& progress) = nullptr;
  std::string (*timed_page)(const StudyData& data, const StudyTimes& times) = nullptr;
};

std::span<const Study> studies();
/// Throws usage_error naming those there are.
const Study& find_study(std::string_view name);

}  // namespace cuesta
