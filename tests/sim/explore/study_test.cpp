#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <set>

#include "models/common/error.h"
#include "models/heightmap/generator.h"
#include "models/traversal/traversal.h"
#include "sim/config/on_architecture.h"
#include "sim/explore/study/study_runner.h"
#include "sim/explore/study/view_runner.h"
#include "sim/machine/machine.h"

namespace cuesta {
namespace {

/// A study whose cases count themselves: place a, b -> 100 a + b.
class CountingRunner : public CaseRunner {
 public:
  std::vector<int64_t> run(const StudyPlace& place) override {
    if (place[0] == fail_at) throw input_error("case " + std::to_string(place[0]) + " is broken");
    return {100 * place[0] + place[1]};
  }
  static inline std::atomic<int> fail_at = -1;
};

const Study kCounting = {
    .name = "counting",
    .plan =
        [](bool quick) {
          StudyData plan = begin_plan("counting", "How many?", quick);
          plan.axes = {{"a", "", "", {"p", "q", "r", "s"}}, {"b", "units", "", {"1", "2.5", "3"}}};
          plan.counters = {{"count", "cases", ""}};
          return plan;
        },
    .shared_axes = 1,
    .planned = [](const StudyData&, const StudyPlace& place) { return !(place[0] == 2 && place[1] == 1); },
    .make_runner = [](const StudyData&, std::span<const uint16_t>) -> std::unique_ptr<CaseRunner> {
      return std::make_unique<CountingRunner>();
    }};

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
  CountingRunner::fail_at = 1;
  EXPECT_THROW(run_study(kCounting, false, 2), Error);
  CountingRunner::fail_at = -1;
  EXPECT_THROW(run_study(kCounting, false, 0), Error);
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

TEST(Studies, EveryFolderWithAPageHasItsRow) {
  std::set<std::string> pages, names;
  for (const auto& folder : std::filesystem::directory_iterator("sim/explore")) {
    const std::string name = folder.path().filename().string();
    if (std::filesystem::exists(folder.path() / (name + "_page.cpp"))) pages.insert(name);
  }
  for (const Study& study : studies()) names.emplace(study.name);
  EXPECT_EQ(pages, names);
}

TEST(Studies, PlanAndRunnerAgreeInNamesAndNumberOfCounts) {
  for (const Study& study : studies()) {
    const StudyData plan = study.plan(true);
    EXPECT_EQ(plan.study, study.name);
    const std::vector<StudyPlace> places = planned_places(study, plan);
    ASSERT_FALSE(places.empty()) << study.name;
    const StudyCase first = run_cases(study, plan, {places.front()}).at(0);
    EXPECT_EQ(first.values.size(), plan.counters.size()) << study.name;
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
