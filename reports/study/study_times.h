#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cuesta {

/// One algorithm and one level of fidelity, or one way to run it, over one frame on one machine.
struct TimedRun {
  std::string machine;  ///< empty: the level has none
  std::string algorithm;
  std::string level;   ///< "cycle", "cycle in SystemC" ...
  double seconds = 0;  ///< wall time: the median of several runs
  int64_t rays = 0;
  int64_t cycles = 0;  ///< machine.cycles as that level has it; 0: the level has no time
};

/// Wall times beside a study. They are true of one host at one time: kept out of data.json, in times.json,
/// and only ratios within one measurement say something elsewhere.
struct StudyTimes {
  std::string host, processor, date, load, build;
  std::string frame;  ///< what was run, in a sentence
  /// Where the frame is a view of the study: axis = value, as a case of it has them; else empty.
  std::vector<std::pair<std::string, std::string>> view;
  std::vector<TimedRun> runs;
};

/// Says where, when and how the times were measured, and what was run.
std::string measured_sentences(const StudyTimes& times);

/// Changes with every change of a study's times.json that a reader can notice.
inline constexpr std::string_view kTimesSchema = "cuesta-times-2";

/// Writes times.json: everything that is in `times`.
std::string times_json(const StudyTimes& times);
/// Reads the wall times in the text of a times.json. Throws input_error naming `where` for anything else.
StudyTimes parse_times_json(const std::string& text, const std::string& where);

}  // namespace cuesta
