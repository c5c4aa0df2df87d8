#include "reports/study/study_times.h"

#include <nlohmann/json.hpp>

#include "models/common/error.h"

namespace cuesta {
namespace {

using Json = nlohmann::ordered_json;

StudyTimes parsed_times(const Json& json) {
  if (json.at("schema") != kTimesSchema) throw input_error("its schema is " + json.at("schema").dump());
  StudyTimes times;
  json.at("host").get_to(times.host);
  json.at("processor").get_to(times.processor);
  json.at("date").get_to(times.date);
  json.at("load_average").get_to(times.load);
  json.at("build").get_to(times.build);
  json.at("frame").get_to(times.frame);
  for (const auto& [axis, value] : json.at("view").items()) times.view.emplace_back(axis, value);
  for (const Json& run : json.at("runs")) {
    times.runs.push_back({run.at("machine"), run.at("algorithm"), run.at("level"), run.at("seconds"),
                          run.at("rays"), run.at("cycles")});
  }
  return times;
}

}  // namespace

std::string measured_sentences(const StudyTimes& times) {
  return "Measured on " + times.host + " (" + times.processor + "), " + times.date + ", load average " +
         times.load + ", " + times.build + ". " + times.frame;
}

std::string times_json(const StudyTimes& times) {
  Json json = {{"schema", std::string(kTimesSchema)},
               {"host", times.host},
               {"processor", times.processor},
               {"date", times.date},
               {"load_average", times.load},
               {"build", times.build},
               {"frame", times.frame},
               {"view", Json::object()},
               {"runs", Json::array()}};
  for (const auto& [axis, value] : times.view) json["view"][axis] = value;
  for (const TimedRun& run : times.runs) {
    json["runs"].push_back({{"machine", run.machine},
                            {"algorithm", run.algorithm},
                            {"level", run.level},
                            {"seconds", run.seconds},
                            {"rays", run.rays},
                            {"cycles", run.cycles}});
  }
  return json.dump(1) + "\n";
}

StudyTimes parse_times_json(const std::string& text, const std::string& where) {
  try {
    return parsed_times(Json::parse(text));
  } catch (const Error& error) {
    throw input_error(where + " does not hold the wall times of a study: " + error.what() +
                      "; accepted is a times.json of schema " + std::string(kTimesSchema) + ".");
  } catch (const nlohmann::json::exception& error) {
    throw input_error(where + " does not hold the wall times of a study (" + error.what() +
                      "); accepted is a times.json as `cuesta study --times` writes it.");
  }
}

}  // namespace cuesta
