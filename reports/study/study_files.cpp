#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "models/common/error.h"
#include "reports/study/study_data.h"

// data.json: head (what is varied, what is counted), then "cases": a row for each combination of all axes but
// the last, [[values of those axes], [[counts] or null for each value of the last axis]]. A row is one line.

namespace cuesta {
namespace {

using Json = nlohmann::ordered_json;

/// A value of an axis as JSON: a number where all of the axis are.
Json axis_value(const StudyAxis& axis, size_t k) {
  return axis.unit.empty() ? Json(axis.values[k]) : Json::parse(axis.values[k]);
}

Json axis_json(const StudyAxis& axis) {
  Json values = Json::array();
  for (size_t k = 0; k < axis.values.size(); ++k) values.push_back(axis_value(axis, k));
  return {{"name", axis.name}, {"unit", axis.unit}, {"sentence", axis.sentence}, {"values", values}};
}

bool same_row(const StudyCase& a, const StudyCase& b) {
  return std::equal(a.place.begin(), a.place.end() - 1, b.place.begin());
}

std::string case_rows(const StudyData& data) {
  std::string rows;
  const size_t last = data.axes.size() - 1;
  for (size_t k = 0; k < data.cases.size();) {
    Json keys = Json::array(), runs = Json::array();
    for (size_t a = 0; a < last; ++a) keys.push_back(axis_value(data.axes[a], data.cases[k].place[a]));
    const StudyCase& first = data.cases[k];
    for (; k < data.cases.size() && same_row(first, data.cases[k]); ++k) {
      while (runs.size() < data.cases[k].place[last]) runs.push_back(nullptr);
      runs.push_back(data.cases[k].values);
    }
    rows += (rows.empty() ? "\n  " : ",\n  ") + Json::array({keys, runs}).dump();
  }
  return rows;
}

StudyCase parsed_case(const StudyData& data, const Json& keys, size_t place_on_last, const Json& values) {
  StudyCase found;
  for (size_t a = 0; a + 1 < data.axes.size(); ++a) {
    const StudyAxis& axis = data.axes[a];
    const std::string text = axis.unit.empty() ? keys.at(a).get<std::string>() : keys.at(a).dump();
    const auto at = std::find(axis.values.begin(), axis.values.end(), text);
    if (at == axis.values.end()) throw input_error("a case has " + axis.name + " " + text);
    found.place.push_back(static_cast<uint16_t>(at - axis.values.begin()));
  }
  if (place_on_last >= data.axes.back().values.size() || values.size() != data.counters.size()) {
    throw input_error("a case has not as many runs and counts as the study has");
  }
  found.place.push_back(static_cast<uint16_t>(place_on_last));
  for (const Json& value : values) {
    constexpr uint64_t kMost = uint64_t{1} << 53;
    if (!value.is_number_unsigned() || value.get<uint64_t>() > kMost) {
      throw input_error("a case counts " + value.dump() + "; accepted is a whole number from 0 to 2^53");
    }
  }
  values.get_to(found.values);
  return found;
}

StudyData parsed(const Json& json) {
  if (json.at("schema") != kStudySchema) throw input_error("its schema is " + json.at("schema").dump());
  StudyData data;
  json.at("study").get_to(data.study);
  json.at("question").get_to(data.question);
  json.at("amount").get_to(data.amount);
  json.at("conditions").get_to(data.conditions);
  json.at("planned_cases").get_to(data.planned);
  for (const Json& axis : json.at("axes")) {
    StudyAxis next{axis.at("name"), axis.at("unit"), axis.at("sentence"), {}};
    for (const Json& value : axis.at("values")) {
      next.values.push_back(value.is_string() ? value.get<std::string>() : value.dump());
    }
    data.axes.push_back(next);
  }
  for (const Json& counter : json.at("counters")) {
    data.counters.push_back({counter.at("name"), counter.at("unit"), counter.at("sentence")});
  }
  std::set<std::string> rows;
  for (const Json& row : json.at("cases")) {
    if (!rows.insert(row.at(0).dump()).second)
      throw input_error("case " + row.at(0).dump() + " is there twice");
    if (row.at(1).size() > data.axes.back().values.size()) {  // fewer: the study was stopped in the row
      throw input_error("case " + row.at(0).dump() + " has more runs than the study has");
    }
    for (size_t k = 0; k < row.at(1).size(); ++k) {
      if (row.at(1).at(k).is_null()) continue;
      data.cases.push_back(parsed_case(data, row.at(0), k, row.at(1).at(k)));
    }
  }
  if (json.at("finished_cases") != data.cases.size()) {
    throw input_error("it says " + json.at("finished_cases").dump() + " finished cases and holds " +
                      std::to_string(data.cases.size()));
  }
  return data;
}

}  // namespace

std::string study_json(const StudyData& data) {
  Json axes = Json::array(), counters = Json::array();
  for (const StudyAxis& axis : data.axes) axes.push_back(axis_json(axis));
  for (const StudyCounter& counter : data.counters) {
    counters.push_back({{"name", counter.name}, {"unit", counter.unit}, {"sentence", counter.sentence}});
  }
  Json head = {{"schema", std::string(kStudySchema)},
               {"study", data.study},
               {"question", data.question},
               {"amount", data.amount},
               {"planned_cases", data.planned},
               {"finished_cases", data.cases.size()},
               {"conditions", data.conditions},
               {"axes", axes},
               {"counters", counters}};
  std::string text = head.dump(1);
  text.resize(text.size() - 2);  // without the closing brace and the line break before it
  return text + ",\n \"cases\": [" + case_rows(data) + "\n ]\n}\n";
}

StudyData parse_study_json(const std::string& text, const std::string& where) {
  try {
    return parsed(Json::parse(text));
  } catch (const Error& error) {
    throw input_error(where + " is not the data of a study: " + error.what() + ".");
  } catch (const nlohmann::json::exception& error) {
    throw input_error(where + " is not the data of a study (" + error.what() +
                      "); accepted is a data.json as `cuesta study` writes it.");
  }
}

std::string study_csv(const StudyData& data) {
  std::string csv;
  for (const StudyAxis& axis : data.axes) csv += axis.name + ",";
  for (size_t k = 0; k < data.counters.size(); ++k) csv += (k == 0 ? "" : ",") + data.counters[k].name;
  csv += "\n";
  for (const StudyCase& one : data.cases) {
    for (size_t a = 0; a < data.axes.size(); ++a) csv += data.axes[a].values[one.place[a]] + ",";
    for (size_t k = 0; k < one.values.size(); ++k)
      csv += fmt::format("{}{}", k == 0 ? "" : ",", one.values[k]);
    csv += "\n";
  }
  return csv;
}

}  // namespace cuesta
