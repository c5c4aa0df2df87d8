#include <gtest/gtest.h>

#include "models/common/error.h"
#include "reports/study/study_readme.h"
#include "reports/study/study_times.h"
#include "tests/reports/study/example_study.h"

namespace cuesta {
namespace {

TEST(StudyFiles, WhatIsWrittenReadsBackTheSame) {
  const StudyData data = tests::example_iterations();
  const StudyData back = parse_study_json(study_json(data), "data.json");
  EXPECT_EQ(back.cases.size(), 11u);
  EXPECT_EQ(study_json(back), study_json(data));
  EXPECT_EQ(study_csv(back), study_csv(data));
  for (size_t k = 0; k < data.cases.size(); ++k) {
    EXPECT_EQ(back.cases[k].place, data.cases[k].place);
    EXPECT_EQ(back.cases[k].values, data.cases[k].values);
  }
}

TEST(StudyFiles, AStudyStoppedAfterAnyCaseReadsBack) {
  const StudyData whole = tests::example_iterations();
  for (size_t finished = 1; finished < whole.cases.size(); ++finished) {
    StudyData stopped = whole;
    stopped.cases.resize(finished);
    const StudyData back = parse_study_json(study_json(stopped), "data.json");
    EXPECT_EQ(study_csv(back), study_csv(stopped)) << finished;
  }
}

TEST(StudyFiles, CsvHasARowPerCase) {
  const std::string csv = study_csv(tests::example_iterations());
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "size,map,depth,angle,algorithm,rays,steps,steps_median,steps_p99,steps_max,simt_slots,fetches,"
            "unique_texels,unique_lines");
  EXPECT_NE(csv.find("\n256,spikes,0.05,80,yun2013,100,1000,10,20,100,2000,1000,500,7\n"), std::string::npos);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 12);
}

TEST(StudyFiles, DamagedDataIsRefusedByName) {
  const std::string good = study_json(tests::example_iterations());
  auto refused = [](const std::string& text) {
    try {
      parse_study_json(text, "some/data.json");
      return std::string();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kInput);
      return std::string(error.what());
    }
  };
  auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  for (const std::string& text :
       {std::string(), good.substr(0, good.size() / 2), changed("cuesta-study-1", "cuesta-study-9"),
        changed("[256,\"fractal\"", "[257,\"fractal\""), changed("[256,\"fractal\"", "[256,7"),
        changed("[100,300,", "[300,"), changed("\"axes\"", "\"axles\"")}) {
    EXPECT_NE(refused(text).find("some/data.json is not the data of a study"), std::string::npos) << text;
  }
}

TEST(StudyFiles, TableFindsCasesByPlaceAndSaysWhatIsMissing) {
  const StudyData data = tests::example_iterations();
  const StudyTable table(data);
  EXPECT_EQ(table.value({0, 1, 0, 0, 2}, "steps"), 320);
  EXPECT_EQ(table.value({0, 1, 0, 1, 0}, "steps"), std::nullopt);
  EXPECT_DOUBLE_EQ(table.ratio({0, 1, 0, 0, 2}, "steps", "rays").value(), 3.2);
  EXPECT_EQ(table.find("map", "logo"), std::nullopt);
}

TEST(StudyFiles, APartialStudySaysKOfN) {
  StudyData data = tests::example_iterations();
  EXPECT_EQ(study_readme(data, "Answer.").find("partial"), std::string::npos);
  data.planned = 20;
  const std::string text = study_readme(data, "Answer.");
  EXPECT_NE(text.find("11 of 20 cases (partial"), std::string::npos) << text;
  EXPECT_NE(text.find("cuesta study iterations --force"), std::string::npos) << text;
}

TEST(StudyFiles, WallTimesReadBackTheSameAndOthersAreRefusedByName) {
  StudyTimes times{"host", "processor", "2001-02-03", "0.1", "-O3", "A frame.", {}, {}};
  times.view = {{"size", "256"}, {"angle", "75"}};
  times.runs = {{"", "dda", "map", 2.7988e-05, 0, 0}, {"mobile", "dda", "cycle", 0.1 + 0.2, 32768, 4822523}};
  const std::string text = times_json(times);
  EXPECT_EQ(times_json(parse_times_json(text, "times.json")), text);
  EXPECT_EQ(parse_times_json(text, "times.json").runs.at(1).seconds, 0.1 + 0.2);
  std::string older = text;
  older.replace(older.find("times-2"), 7, "times-1");
  for (const std::string& wrong : {older, text.substr(0, text.size() / 2), std::string("{}")}) {
    try {
      parse_times_json(wrong, "some/times.json");
      FAIL() << wrong;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::kInput);
      EXPECT_NE(std::string(error.what()).find("some/times.json does not hold the wall times"),
                std::string::npos);
    }
  }
}

}  // namespace
}  // namespace cuesta
