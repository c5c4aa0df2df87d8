#include "reports/study/study_times.h"

#include <nlohmann/json.hpp>

namespace cuesta {

std::string times_json(const StudyTimes& times) {
  nlohmann::ordered_json json = {{"schema", "cuesta-times-2"},
                                 {"host", times.host},
                                 {"processor", times.processor},
                                 {"date", times.date},
                                 {"load_average", times.load},
                                 {"build", times.build},
                                 {"frame", times.frame},
                                 {"view", nlohmann::ordered_json::object()},
                                 {"runs", nlohmann::ordered_json::array()}};
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

}  // namespace cuesta
