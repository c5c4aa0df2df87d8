#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cuesta {

/// Changes with every change of a study's data.json that a reader can notice.
inline constexpr std::string_view kStudySchema = "cuesta-study-1";

/// One thing that a study varies.
struct StudyAxis {
  std::string name;  ///< "angle"
  std::string unit;  ///< "degrees"; empty for names
  std::string sentence;
  std::vector<std::string> values;  ///< as they are written in files and on pages
};

/// One thing that a study counts in each case.
struct StudyCounter {
  std::string name;
  std::string unit;
  std::string sentence;
};

/// A case: the number of its value on each axis.
using StudyPlace = std::vector<uint16_t>;

struct StudyCase {
  StudyPlace place;             ///< as long as the axes
  std::vector<int64_t> values;  ///< as long as the counters
};

/// A picture that belongs to a study.
struct StudyPicture {
  std::string name;     ///< of its file, without .png
  std::string caption;  ///< a sentence or two
  std::string png;
};

/// A published study: what was varied, under which conditions, and what was counted. Integers only, so that
/// the same study gives the same bytes everywhere; ratios are computed when read. Every page is made from
/// this alone.
struct StudyData {
  std::string study;                    ///< "iterations"
  std::string question;                 ///< one sentence
  std::string amount = "published";     ///< or "quick": a small part of the matrix
  std::vector<std::string> conditions;  ///< sentences: what holds for every case
  std::vector<StudyAxis> axes;
  std::vector<StudyCounter> counters;
  std::vector<StudyCase> cases;        ///< finished ones, by place: the last axis runs fastest
  uint64_t planned = 0;                ///< cases of the plan; more than `cases`: partial
  std::vector<StudyPicture> pictures;  ///< in files of their own beside data.json, not in it

  bool partial() const { return cases.size() < planned; }
};

/// Finds the number of an axis or counter. Throws (internal error) for a name that the study does not have.
size_t axis_index(const StudyData& data, std::string_view name);
size_t counter_index(const StudyData& data, std::string_view name);

/// Gives the value that a place has on an axis, as it is written.
const std::string& value_at(const StudyData& data, const StudyPlace& place, std::string_view axis);
/// Gives that value as a number.
double number_at(const StudyData& data, const StudyPlace& place, std::string_view axis);
/// Says whether it is `value`.
bool is_at(const StudyData& data, const StudyPlace& place, std::string_view axis, std::string_view value);
/// Reads the number that a value of an axis of numbers stands for; 0 for a name.
double number_of_value(const std::string& value);

/// Writes the values of an axis with `separator` between them; of more than a hundred the first, the last and
/// their number.
std::string listed_values(const StudyAxis& axis, std::string_view separator);

/// Reads a study's cases by place and by name. `data` must outlive it.
class StudyTable {
 public:
  explicit StudyTable(const StudyData& data);

  const StudyData& data() const { return data_; }
  const StudyAxis& axis(std::string_view name) const { return data_.axes[axis_index(data_, name)]; }
  /// Finds the number of a value on its axis; nullopt where the axis has no such value.
  std::optional<uint16_t> find(std::string_view axis, std::string_view value) const;
  /// Finds a case; nullptr where it is not planned or not finished.
  const StudyCase* at(const StudyPlace& place) const;
  std::optional<int64_t> value(const StudyPlace& place, std::string_view counter) const;
  /// Divides one counter by another; nullopt also where the denominator is 0.
  std::optional<double> ratio(const StudyPlace& place, std::string_view numerator,
                              std::string_view denominator) const;

 private:
  size_t number(const StudyPlace& place) const;

  const StudyData& data_;
  std::vector<int32_t> case_at_;  ///< by number of place; -1: none
};

/// Writes data.json, the source of truth.
std::string study_json(const StudyData& data);
/// Reads the study in the text of a data.json. Throws input_error naming `where` for anything else.
StudyData parse_study_json(const std::string& text, const std::string& where);
/// Writes data.csv: one row per case, a column per axis and per counter.
std::string study_csv(const StudyData& data);

}  // namespace cuesta
