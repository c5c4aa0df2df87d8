#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "models/common/error.h"
#include "models/common/words.h"
#include "reports/study/study_readme.h"
#include "sim/explore/study/study_runner.h"

// What is committed under reports/published is what the program counts, and wall times beside it. Long under
// sanitizers.

namespace cuesta {
namespace {

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

const std::string kPublished = "reports/published/";

std::string folder_of(const Study& study) { return kPublished + std::string(study.name) + "/"; }

StudyData committed_data(const Study& study) {
  const std::string path = folder_of(study) + "data.json";
  return parse_study_json(read(path), path);
}

/// A few cases of the smallest maps, spread over the committed data, run again.
class Published : public ::testing::TestWithParam<std::string> {};

TEST_P(Published, CasesRunAgainGiveTheCommittedCounts) {
  const Study& study = find_study(GetParam());
  const StudyData committed = committed_data(study);
  ASSERT_FALSE(committed.partial());
  StudyData head = committed, plan = study.plan(false);
  head.cases.clear();
  plan.planned = planned_places(study, plan).size();
  ASSERT_EQ(study_json(head), study_json(plan));

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

TEST(PublishedFolders, AreThoseOfTheStudies) {
  std::set<std::string> folders, names;
  for (const auto& entry : std::filesystem::directory_iterator(kPublished))
    folders.insert(entry.path().filename().string());
  for (const Study& study : studies()) names.insert(std::string(study.name));
  EXPECT_EQ(folders, names);
}

/// Every file but manifest.json, which holds host and day.
std::map<std::string, std::string> files_made_of(const Study& study) {
  StudyData data = committed_data(study);
  std::map<std::string, std::string> files = {{"data.json", study_json(data)}, {"data.csv", study_csv(data)}};
  if (study.pictures != nullptr) data.pictures = study.pictures(false);
  for (const StudyPicture& picture : data.pictures) files["pictures/" + picture.name + ".png"] = picture.png;
  const bool timed = study.times != nullptr;
  if (timed) {
    const std::string path = folder_of(study) + "times.json";
    const StudyTimes times = parse_times_json(read(path), path);
    files["times.json"] = times_json(times);
    files["report.html"] = study.timed_page(data, times);
  } else {
    files["report.html"] = study.page(data);
  }
  files["README.md"] = study_readme(data, study.headline(data), timed);
  return files;
}

/// Where two texts part, with what each has there.
std::string parting(const std::string& committed, const std::string& made) {
  const size_t at = static_cast<size_t>(std::ranges::mismatch(committed, made).in1 - committed.begin());
  const size_t from = at < 40 ? 0 : at - 40;
  return "from byte " + std::to_string(at) + " on; committed: " + printable(committed.substr(from), 120) +
         "; made: " + printable(made.substr(from), 120);
}

TEST_P(Published, FolderHoldsByteForByteWhatItsDataGive) {
  const Study& study = find_study(GetParam());
  const std::string folder = folder_of(study);
  std::set<std::string> committed_names, made_names = {"manifest.json"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file())
      committed_names.insert(std::filesystem::relative(entry.path(), folder).string());
  }
  for (const auto& [name, bytes] : files_made_of(study)) {
    made_names.insert(name);
    const std::string committed = read(folder + name);
    EXPECT_TRUE(committed == bytes) << folder << name << " is not what the folder's data and the code give, "
                                    << parting(committed, bytes) << "\nMake it again: cuesta study "
                                    << study.name << " --resume " << folder << "data.json --force"
                                    << (study.times == nullptr ? "" : " --times");
  }
  EXPECT_EQ(committed_names, made_names);
}

std::vector<std::string> names_of_studies() {
  std::vector<std::string> names;
  for (const Study& study : studies()) names.emplace_back(study.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Studies, Published, ::testing::ValuesIn(names_of_studies()),
                         [](const auto& row) { return row.param; });

TEST(Stability, EveryRayEndsInOneWayAndThoseOfExactSchedulesAlwaysEnd) {
  const StudyData data = committed_data(find_study("stability"));
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
