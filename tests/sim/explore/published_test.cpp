#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "models/common/error.h"
#include "sim/explore/study/study_runner.h"
#include "sim/explore/study/view_bench.h"

// What is committed under reports/published is what the program counts, and wall times beside it. Long under sanitizers.

namespace cuesta {
namespace {

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A few cases of the smallest maps, spread over the committed data, run again.
class Published : public ::testing::TestWithParam<const char*> {};

TEST_P(Published, CasesRunAgainGiveTheCommittedCounts) {
  const Study& study = find_study(GetParam());
  const std::string path = std::string("reports/published/") + GetParam() + "/data.json";
  const StudyData committed = parse_study_json(read(path), path);
  ASSERT_FALSE(committed.partial());
  StudyData plan = study.plan(false);
  ASSERT_EQ(committed.axes.size(), plan.axes.size());
  for (size_t a = 0; a < plan.axes.size(); ++a) EXPECT_EQ(committed.axes[a].values, plan.axes[a].values);

  std::vector<const StudyCase*> small;
  for (const StudyCase& one : committed.cases) {
    if (number_at(committed, one.place, "size") <= 256) small.push_back(&one);
  }
  ASSERT_GT(small.size(), 100u);
  constexpr size_t kCases = 12;
  std::vector<StudyPlace> places;
  for (size_t k = 0; k < kCases; ++k) places.push_back(small[k * (small.size() - 1) / (kCases - 1)]->place);
  const std::vector<StudyCase> again = run_cases(study, plan, places);
  for (size_t k = 0; k < kCases; ++k) {
    EXPECT_EQ(again[k].values, small[k * (small.size() - 1) / (kCases - 1)]->values) << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Studies, Published,
                         ::testing::Values("iterations", "bandwidth", "accuracy", "fidelity", "precision",
                                           "stability"),
                         [](const auto& row) { return std::string(row.param); });

TEST(PublishedFiles, HoldTheSameCasesAsJsonAndCsv) {
  for (const Study& study : studies()) {
    const std::string folder = "reports/published/" + std::string(study.name) + "/";
    const StudyData data = parse_study_json(read(folder + "data.json"), folder);
    EXPECT_EQ(study_json(data), read(folder + "data.json"));
    EXPECT_EQ(study_csv(data), read(folder + "data.csv"));
    EXPECT_NE(read(folder + "README.md").find(study.headline(data)), std::string::npos) << study.name;
    EXPECT_NE(read(folder + "report.html").find("Cuesta: study"), std::string::npos) << study.name;
  }
}

TEST(Stability, EveryRayEndsInOneWayAndThoseOfExactSchedulesAlwaysEnd) {
  const StudyData data =
      parse_study_json(read("reports/published/stability/data.json"), "reports/published/stability");
  const StudyTable table(data);
  int64_t not_numbers = 0, unfinished = 0;
  for (const StudyCase& one : data.cases) {
    const auto count = [&](const char* name) { return *table.value(one.place, name); };
    ASSERT_EQ(count("exact") + count("tie") + count("missed") + count("behind") + count("wrong_cell") +
                  count("nan") + count("unfinished"),
              count("rays"));
    const std::string& algorithm = data.axes.back().values[one.place.back()];
    if (algorithm.find("-printed") == std::string::npos) {
      ASSERT_EQ(count("nan") + count("unfinished"), 0) << algorithm;
    }
    not_numbers += count("nan");
    unfinished += count("unfinished");
  }
  EXPECT_GT(not_numbers, 0);
  EXPECT_GT(unfinished, 0);
}

TEST(StudyTimes, EveryAlgorithmOfTheViewIsTimedOnEachLevel) {
  const Study& study = find_study("accuracy");
  const StudyTimes times = study.times(true, {});
  const StudyData plan = study.plan(true);
  const std::vector<std::string>& algorithms = plan.axes.back().values;
  ASSERT_EQ(times.runs.size(), 3 * algorithms.size());
  for (size_t k = 0; k < algorithms.size(); ++k) {
    EXPECT_EQ(times.runs[3 * k].level, "map");
    EXPECT_EQ(times.runs[3 * k + 1].level, "functional");
    EXPECT_EQ(times.runs[3 * k + 2].level, "cycle");
    for (size_t level = 0; level < 3; ++level) {
      EXPECT_EQ(times.runs[3 * k + level].algorithm, algorithms[k]);
      EXPECT_GT(times.runs[3 * k + level].seconds, 0);
    }
    EXPECT_EQ(times.runs[3 * k + 1].rays, 32768);
    EXPECT_GT(times.runs[3 * k + 2].cycles, 0);
  }
  // The page finds the cases of that view.
  const std::string page = study.timed_page(run_study(study, true, 2), times);
  EXPECT_NE(page.find("What being right costs in wall time"), std::string::npos);
  EXPECT_NE(page.find("angle 75"), std::string::npos);
}

TEST(StudyTimes, EndWhenProgressSaysNo) {
  for (const Study& study : studies()) {
    if (study.times == nullptr) continue;
    EXPECT_THROW(study.times(true, [](uint64_t, uint64_t) { return false; }), Error) << study.name;
  }
}

}  // namespace
}  // namespace cuesta
