#include "reports/study/study_times.h"

#include <nlohmann/json.hpp>

namespace cuesta {

std::string times_json(const StudyTimes& times) {
  nlohmann::ordered_json json = {{"schema", "cuesta-times-1"},   {"host", times.host},
                                 {"processor", times.processor}, {"date", times.date},
                                 {"load_average", times.load},   {"build", times.build},
                                 {"frame", times.frame},         {"runs", nlohmann::ordered_json::array()}};
  for (const TimedRun& run : times.runs) {
    json["runs"].push_back({{"machine", run.machine},
                            {"level", run.level},
                            {"seconds", run.seconds},
                            {"rays", run.rays},
                            {"cycles", run.cycles}});
  }
  return json.dump(1) + "\n";
}

}  // namespace cuesta
