#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>
#include <set>

#include "models/common/error.h"
#include "models/heightmap/generator.h"
#include "models/traversal/traversal.h"
#include "sim/machine.h"
#include "sim/study/study_runner.h"
#include "sim/study/view_bench.h"

namespace cuesta {
namespace {

/// A study whose cases count themselves: place a, b -> 100 a + b.
class CountingBench : public StudyBench {
 public:
  std::vector<int64_t> run(const StudyPlace& place) override {
    if (place[0] == fail_at) throw input_error("case " + std::to_string(place[0]) + " is broken");
    return {100 * place[0] + place[1]};
  }
  static inline std::atomic<int> fail_at = -1;
};

const Study kCounting{
    "counting",
    [](bool) {
      StudyData plan;
      plan.study = "counting";
      plan.axes = {{"a", "", "", {"p", "q", "r", "s"}}, {"b", "units", "", {"1", "2.5", "3"}}};
      plan.counters = {{"count", "cases", ""}};
      return plan;
    },
    1,
    [](const StudyData&, const StudyPlace& place) { return !(place[0] == 2 && place[1] == 1); },
    [](const StudyData&, std::span<const uint16_t>) -> std::unique_ptr<StudyBench> {
      return std::make_unique<CountingBench>();
    },
    nullptr,
    nullptr};

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(StudyRunner, RunsEveryPlannedCaseOnceInTheOrderOfTheAxes) {
  const StudyData data = run_study(kCounting, false, 3);
  ASSERT_EQ(data.cases.size(), 11u);
  EXPECT_EQ(data.planned, 11u);
  std::vector<int64_t> found;
  for (const StudyCase& one : data.cases) found.push_back(one.values.at(0));
  EXPECT_EQ(found, (std::vector<int64_t>{0, 1, 2, 100, 101, 102, 200, 202, 300, 301, 302}));
}

TEST(StudyRunner, TheNumberOfWorkersChangesNoByte) {
  const Study& study = find_study("bandwidth");
  EXPECT_EQ(study_json(run_study(study, true, 1)), study_json(run_study(study, true, 3)));
}

TEST(StudyRunner, EndedEarlyItKeepsWhatIsFinished) {
  // Progress is asked at once and says no: each worker ends its case and takes no other.
  const StudyData data =
      run_study(find_study("iterations"), true, 2, [](uint64_t, uint64_t) { return false; });
  EXPECT_LT(data.cases.size(), data.planned);
  EXPECT_TRUE(data.partial());
}

TEST(StudyRunner, FinishedCasesAreTakenOverAndTheRestIsRun) {
  StudyData earlier = run_study(kCounting, false, 1);
  earlier.axes[0].values = {"q", "p", "x", "y"};  // another order, and values that the plan does not have
  earlier.cases.resize(4);
  for (StudyCase& one : earlier.cases) one.values = {7000 + 10 * one.place[0] + one.place[1]};
  const StudyData data = run_study(kCounting, false, 2, {}, &earlier);
  std::vector<int64_t> found;
  for (const StudyCase& one : data.cases) found.push_back(one.values.at(0));
  EXPECT_EQ(found, (std::vector<int64_t>{7010, 1, 2, 7000, 7001, 7002, 200, 202, 300, 301, 302}));
  earlier.conditions = {"other"};
  EXPECT_THROW(run_study(kCounting, false, 2, {}, &earlier), Error);
}

TEST(StudyRunner, AFaultInACaseReachesTheCaller) {
  CountingBench::fail_at = 1;
  EXPECT_THROW(run_study(kCounting, false, 2), Error);
  CountingBench::fail_at = -1;
  EXPECT_THROW(run_study(kCounting, false, 0), Error);
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

TEST(ParallelView, EveryRayHasTheViewsAngleAndStartsOnTop) {
  for (const double degrees : {0.0, 30.0, 75.0, 88.0}) {
    const ParallelView view = study_view(degrees, 0.35);
    const RayTrace trace = parallel_rays(view);
    ASSERT_EQ(trace.rays.size(), 32768u);
    for (const TracedRay& ray : trace.rays) {
      const double along = std::hypot(ray.direction[0], ray.direction[1]);
      const double down = -ray.direction[2] * view.depth;
      ASSERT_NEAR(std::atan2(along, down) * 180 / 3.14159265358979, degrees, 1e-9);
      ASSERT_EQ(ray.origin[2], 1);
      for (int axis = 0; axis < 2; ++axis) {
        ASSERT_GE(ray.origin[axis], 0);
        ASSERT_LT(ray.origin[axis], 1);
      }
    }
  }
}

TEST(ParallelView, NeighboursStandApartAsSquarePixelsDo) {
  const RayTrace trace = parallel_rays(study_view(60, 0.05));
  auto apart = [&](size_t a, size_t b) {
    double squares = 0;
    for (int axis = 0; axis < 2; ++axis) {
      double d = trace.rays[b].origin[axis] - trace.rays[a].origin[axis];
      d -= std::round(d);  // the next tile
      squares += d * d;
    }
    return std::sqrt(squares);
  };
  // Two tiles over 256 pixels; at 60 degrees a pixel covers twice as much along the view.
  EXPECT_NEAR(apart(1000, 1001), 2.0 / 256, 1e-12);
  EXPECT_NEAR(apart(1000, 1256), 4.0 / 256, 1e-12);
}

TEST(Iterations, CountsAreThoseOfAPlainWalkOverTheSameRays) {
  const Study& study = find_study("iterations");
  const StudyData plan = study.plan(true);
  const StudyPlace place{0, 1, 1, 1, 6};  // 64 texels, spikes, depth 0.35, 75 degrees, yun2013
  ASSERT_TRUE(is_at(plan, place, "algorithm", "yun2013") && is_at(plan, place, "map", "spikes"));
  const StudyCase found = run_cases(study, plan, {place}).at(0);

  const Pyramid pyramid = build_max_pyramid(generate("spikes", 64, 64, 8, 1));
  const MapShape map{64, 64, 6, 8, AddressMode::kWrap};
  const NumberFormat format = number_format({}, map);
  const Walk<FixedArithmetic, PlainAxis> walk(map, format, parse_algorithm("yun2013").schedule,
                                              pyramid.at(6, 0, 0));
  const RayTrace picture = parallel_rays(study_view(75, 0.35));
  std::set<std::tuple<int, int64_t, int64_t>> texels;
  int64_t rays = 0, steps = 0, longest_sum = 0, longest = 0;
  for (uint32_t top = 0; top < 128; top += 8) {
    for (uint32_t left = 0; left < 256; left += 16) {
      int64_t warp = 0;
      for (uint32_t k = 0; k < 32; ++k) {
        const TracedRay& ray = picture.rays[(top + k / 8) * 256 + left + k % 8];
        const HitRecord hit =
            traverse_ray(walk, quantise(ray, map, format), [&](int level, int64_t i, int64_t j) {
              texels.insert({level, i, j});
              return static_cast<int64_t>(pyramid.at(level, static_cast<int>(i), static_cast<int>(j)));
            });
        EXPECT_EQ(hit.status, HitStatus::kHit);
        ++rays;
        steps += hit.steps;
        warp = std::max<int64_t>(warp, hit.steps);
      }
      longest_sum += warp;
      longest = std::max(longest, warp);
    }
  }
  auto count = [&](const char* name) { return found.values[counter_index(plan, name)]; };
  EXPECT_EQ(count("rays"), rays);
  EXPECT_EQ(count("steps"), steps);
  EXPECT_EQ(count("fetches"), steps);
  EXPECT_EQ(count("steps_max"), longest);
  EXPECT_EQ(count("simt_slots"), 32 * longest_sum);
  EXPECT_EQ(count("unique_texels"), static_cast<int64_t>(texels.size()));
}

TEST(Iterations, TheSampleOfWarpsStandsForThePicture) {
  // The same views in both studies: one in four warps here, every pixel there.
  const Study &steps = find_study("iterations"), &cycles = find_study("bandwidth");
  const StudyData a = steps.plan(true), b = cycles.plan(true);
  auto per_ray = [](const StudyData& plan, const StudyCase& one) {
    return static_cast<double>(one.values[counter_index(plan, "steps")]) /
           static_cast<double>(one.values[counter_index(plan, "rays")]);
  };
  for (uint16_t angle : {0, 1}) {
    const StudyCase sample = run_cases(steps, a, {{1, 0, 0, angle, 1}}).at(0);
    const StudyCase whole = run_cases(cycles, b, {{1, 0, 0, angle, 0, 0}}).at(0);
    EXPECT_NEAR(per_ray(a, sample) / per_ray(b, whole), 1, 0.03) << angle;
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

TEST(Studies, AnUnknownNameIsRefusedWithThoseThereAre) {
  try {
    find_study("iteration");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::kUsage);
    EXPECT_NE(std::string(error.what()).find("iterations, bandwidth"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace cuesta
