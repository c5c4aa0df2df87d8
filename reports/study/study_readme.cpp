#include "reports/study/study_readme.h"

#include <fmt/format.h>

#include "reports/numbers.h"

namespace cuesta {

std::string study_readme(const StudyData& data, const std::string& headline, bool timed) {
  std::string text = fmt::format("# Study `{}`: {}\n\n{}\n\n", data.study, data.question, headline);
  text += std::string("Made, every byte but manifest.json") +
          (timed ? ", times.json and what the page says of wall time" : "") +
          ", by\n\n```\nbuild/release/cuesta study " + data.study +
          (data.amount == "quick" ? " --quick" : "") + (timed ? " --times" : "") + " --force\n```\n\n";
  text += fmt::format("{} of {} cases", grouped(static_cast<int64_t>(data.cases.size())),
                      grouped(static_cast<int64_t>(data.planned)));
  text += data.partial() ? " (partial: the study was ended early)" : "";
  text += ", one run each:\n\n| axis | values |\n|---|---|\n";
  for (const StudyAxis& axis : data.axes) {
    text += "| " + axis.name + (axis.unit.empty() ? "" : " (" + axis.unit + ")") + " | " +
            listed_values(axis, " ") + " |\n";
  }
  text += "\n";
  for (const std::string& condition : data.conditions) text += "- " + condition + "\n";
  text +=
      "\n| file | what is in it |\n|---|---|\n"
      "| `data.json` | the source of truth: conditions, axes, what is counted, every case |\n"
      "| `data.csv` | the same cases, a row each |\n"
      "| `report.html` | the page, made from the data alone; asks the network for nothing |\n";
  for (const StudyPicture& picture : data.pictures)
    text += "| `pictures/" + picture.name + ".png` | " + picture.caption + " |\n";
  if (timed)
    text += "| `times.json` | wall times, on the host and the day that it names; they differ each time |\n";
  text += "| `manifest.json` | version, commit, compiler, and under `environment` host and times |\n";
  return text;
}

}  // namespace cuesta
