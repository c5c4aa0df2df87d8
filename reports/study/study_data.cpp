#include "reports/study/study_data.h"

#include <charconv>

#include "models/common/error.h"

namespace cuesta {
namespace {

template <class Named>
size_t index_of(const std::vector<Named>& all, std::string_view name, const StudyData& data) {
  for (size_t k = 0; k < all.size(); ++k) {
    if (all[k].name == name) return k;
  }
  throw Error(ExitCode::kInternal, "The study " + data.study + " has no '" + std::string(name) + "'.");
}

}  // namespace

size_t axis_index(const StudyData& data, std::string_view name) { return index_of(data.axes, name, data); }

size_t counter_index(const StudyData& data, std::string_view name) {
  return index_of(data.counters, name, data);
}

const std::string& value_at(const StudyData& data, const StudyPlace& place, std::string_view axis) {
  const size_t index = axis_index(data, axis);
  return data.axes[index].values[place[index]];
}

double number_at(const StudyData& data, const StudyPlace& place, std::string_view axis) {
  return number_of_value(value_at(data, place, axis));
}

bool is_at(const StudyData& data, const StudyPlace& place, std::string_view axis, std::string_view value) {
  return value_at(data, place, axis) == value;
}

double number_of_value(const std::string& value) {
  double number = 0;
  std::from_chars(value.data(), value.data() + value.size(), number);
  return number;
}

std::string listed_values(const StudyAxis& axis, std::string_view separator) {
  constexpr size_t kMost = 100, kShown = 6;
  const size_t all = axis.values.size();
  std::string text;
  for (size_t k = 0; k < all; ++k) {
    if (all > kMost && k >= kShown && k + 1 < all) continue;
    if (!text.empty()) text += separator;
    if (all > kMost && k + 1 == all) text += "..." + std::string(separator);
    text += axis.values[k];
  }
  return all > kMost ? text + " (" + std::to_string(all) + ")" : text;
}

StudyTable::StudyTable(const StudyData& data) : data_(data) {
  size_t all = 1;
  for (const StudyAxis& axis : data.axes) all *= axis.values.size();
  case_at_.assign(all, -1);
  for (size_t k = 0; k < data.cases.size(); ++k)
    case_at_[number(data.cases[k].place)] = static_cast<int32_t>(k);
}

size_t StudyTable::number(const StudyPlace& place) const {
  size_t number = 0;
  for (size_t a = 0; a < data_.axes.size(); ++a) number = number * data_.axes[a].values.size() + place[a];
  return number;
}

std::optional<uint16_t> StudyTable::find(std::string_view axis_name, std::string_view value) const {
  const StudyAxis& found = axis(axis_name);
  for (size_t k = 0; k < found.values.size(); ++k) {
    if (found.values[k] == value) return static_cast<uint16_t>(k);
  }
  return std::nullopt;
}

const StudyCase* StudyTable::at(const StudyPlace& place) const {
  const int32_t found = case_at_[number(place)];
  return found < 0 ? nullptr : &data_.cases[static_cast<size_t>(found)];
}

std::optional<int64_t> StudyTable::value(const StudyPlace& place, std::string_view counter) const {
  const StudyCase* found = at(place);
  if (found == nullptr) return std::nullopt;
  return found->values[counter_index(data_, counter)];
}

std::optional<double> StudyTable::ratio(const StudyPlace& place, std::string_view numerator,
                                        std::string_view denominator) const {
  const auto above = value(place, numerator), below = value(place, denominator);
  if (!above || !below || *below == 0) return std::nullopt;
  return static_cast<double>(*above) / static_cast<double>(*below);
}

}  // namespace cuesta
