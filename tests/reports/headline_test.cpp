#include "reports/headline.h"

#include <gtest/gtest.h>

#include "reports/quantities.h"

namespace cuesta {
namespace {

RunEntry run_of(const std::string& algorithm, int64_t steps, int64_t cycles) {
  RunEntry run;
  run.scene = "rocks";
  run.algorithm = algorithm;
  run.architecture = "mobile";
  run.fidelity = cycles > 0 ? "cycle" : "functional";
  run.finished_rays = run.all_rays = 100;
  run.measurements.counters.set("machine.rays", 100);
  run.measurements.counters.set("machine.steps", steps);
  if (cycles > 0) run.measurements.counters.set("machine.cycles", cycles);
  return run;
}

Result result_of(std::vector<RunEntry> runs) {
  Result result;
  result.runs = std::move(runs);
  return result;
}

TEST(Headline, NamesTheFewestCyclesAgainstOh2006) {
  const Result result =
      result_of({run_of("dda", 3000, 5000), run_of("oh2006", 1000, 2000), run_of("yun2013", 600, 1500)});
  EXPECT_EQ(headline(result),
            "yun2013 needed the fewest cycles on rocks: 1,500 cycles, 25.0 % fewer than oh2006 (40.0 % fewer "
            "steps).");
}

TEST(Headline, KeepsApproximateRunsOutOfTheRaceAndNamesTheClosest) {
  Result result = result_of({run_of("oh2006", 1000, 2000), run_of("yun2013", 600, 1500),
                             run_of("parallax", 100, 300), run_of("relief", 10700, 12000)});
  result.runs[2].measurements.counters.set("error.wrong", 60);
  result.runs[3].measurements.counters.set("error.wrong", 2);
  EXPECT_EQ(headline(result),
            "yun2013 needed the fewest cycles on rocks: 1,500 cycles, 25.0 % fewer than oh2006 (40.0 % fewer "
            "steps). "
            "Of the 2 approximate searches on rocks relief comes closest: 2.0 % of its rays are wrong, at "
            "8.00 times "
            "the cycles of yun2013.");
}

TEST(Headline, TellsRaysWithoutAnAnswerFromWrongOnes) {
  Result result = result_of({run_of("oh2006", 1000, 0), run_of("ki2007-printed", 900, 0)});
  result.runs[1].measurements.counters.set("error.wrong", 2);
  result.runs[1].measurements.counters.set("error.nan", 20);
  result.runs[1].measurements.counters.set("error.unfinished", 5);
  EXPECT_NE(headline(result).find(
                "ki2007-printed is approximate: 2.0 % of its rays are wrong and 25.0 % end without "
                "an answer"),
            std::string::npos)
      << headline(result);
  EXPECT_FALSE(competes(result.runs[1]));
  EXPECT_TRUE(competes(result.runs[0]));
}

TEST(Headline, SaysWhichCyclesAreEstimated) {
  Result result = result_of({run_of("oh2006", 1000, 2000), run_of("yun2013", 600, 1500)});
  for (RunEntry& run : result.runs) run.fidelity = "transaction";
  EXPECT_EQ(headline(result),
            "yun2013 needed the fewest cycles on rocks: an estimated 1,500 cycles, 25.0 % fewer than oh2006 "
            "(40.0 % "
            "fewer steps).");
}

TEST(Headline, CountsStepsWhereThereIsNoTime) {
  const Result result = result_of({run_of("oh2006", 1000, 0), run_of("yun2013", 600, 0)});
  EXPECT_EQ(headline(result),
            "yun2013 needed the fewest steps on rocks: 6.00 steps per ray, 40.0 % fewer than oh2006.");
}

TEST(Headline, SaysSoWhenOh2006ItselfNeedsTheFewest) {
  const Result result = result_of({run_of("oh2006", 500, 900), run_of("dda", 600, 1500)});
  EXPECT_EQ(headline(result), "oh2006 needed the fewest cycles on rocks: 900 cycles, the fewest of 2.");
}

TEST(Headline, DoesNotCompareAPartialRun) {
  Result result =
      result_of({run_of("oh2006", 1000, 2000), run_of("yun2013", 60, 150), run_of("dda", 2000, 3000)});
  result.runs[1].finished_rays = 10;
  EXPECT_EQ(headline(result),
            "oh2006 needed the fewest cycles on rocks: 2,000 cycles, the fewest of 2. "
            "yun2013 on rocks is partial (10 of 100 rays) and not compared.");
}

TEST(Headline, OneWinnerOfSeveralScenesIsNamedOnce) {
  Result result = result_of({run_of("oh2006", 1000, 2000), run_of("yun2013", 600, 1500),
                             run_of("oh2006", 1000, 4000), run_of("yun2013", 900, 3000)});
  result.runs[2].scene = result.runs[3].scene = "page";
  EXPECT_EQ(headline(result),
            "yun2013 needed the fewest cycles on rocks: 1,500 cycles, 25.0 % fewer than oh2006 (40.0 % fewer "
            "steps); "
            "on page: 3,000 cycles, 25.0 % fewer than oh2006 (10.0 % fewer steps).");
}

TEST(Headline, TellsWhatASingleRunTook) {
  EXPECT_EQ(headline(result_of({run_of("dda", 300, 500)})),
            "dda traced 100 rays on rocks in 500 cycles: 3.00 steps per ray, 5.00 cycles per ray.");
}

TEST(Headline, BaselineHasTheSameMachine) {
  Result result =
      result_of({run_of("oh2006", 1000, 2000), run_of("oh2006", 1000, 1000), run_of("dda", 1000, 500)});
  result.runs[1].architecture = result.runs[2].architecture = "desktop";
  EXPECT_EQ(baseline_of(result, result.runs[2]), &result.runs[1]);
  EXPECT_DOUBLE_EQ(*against_baseline(result, result.runs[2], "machine.cycles"), -0.5);
  EXPECT_EQ(common_baseline(result, group_by_scene(result)[0]), nullptr);
  EXPECT_EQ(baseline_name(result, group_by_scene(result)[0]), "oh2006");
}

TEST(Headline, WithoutOh2006TheFirstRunIsTheBaseline) {
  const Result result = result_of({run_of("dda", 1000, 2000), run_of("yun2013", 600, 1000)});
  EXPECT_EQ(baseline_name(result, group_by_scene(result)[0]), "dda");
  EXPECT_DOUBLE_EQ(*against_baseline(result, result.runs[1], "machine.cycles"), -0.5);
}

}  // namespace
}  // namespace cuesta
