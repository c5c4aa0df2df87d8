#include "sim/session/measure_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>

#include "sim/session/machines.h"
#include "sim/session/manifest.h"
#include "sim/session/result_files.h"
#include "sim/session/waves.h"
#include "tests/sim/session/recording_observer.h"
#include "tests/support/temporary_folder.h"

// Scenes and machines to a result, as a program without a command line asks for it.

namespace cuesta {
namespace {

class MeasureScenes : public ::testing::Test {
 protected:
  /// A small map seen by a small camera.
  std::string scene(const std::string& name) const {
    std::ofstream(folder_.path(name + ".toml"))
        << "[heightmap]\ngenerate = { kind = \"rocks\", width = 32, height = 32, seed = 7 }\n[camera]\n"
           "angle_degrees = 60\n[image]\nwidth = 24\nheight = 20\n";
    return folder_.path(name + ".toml");
  }
  RunRequest wanted(const std::vector<std::string>& algorithms,
                    const std::vector<std::string>& machines = {"tiny"}) const {
    RunRequest wanted;
    wanted.scenes = {scene("small")};
    for (const std::string& name : algorithms) wanted.algorithms.push_back(parse_algorithm(name));
    wanted.machines = resolve_machines(machines, {}, wanted.fidelity);
    return wanted;
  }
  std::string read(const std::string& name) const {
    std::ifstream file(folder_.path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  const TemporaryFolder folder_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

TEST_F(MeasureScenes, EveryAlgorithmRunsOnEveryMachineOverEveryScene) {
  RunRequest m = wanted({"yun2013", "oh2006"}, {"tiny", "mobile"});
  m.scenes.push_back(scene("other"));
  EXPECT_EQ(planned_runs(m), 8u);
  EXPECT_EQ(scene_names(m), (std::vector<std::string>{"small", "other"}));
  Result result = begin_result("compare", "asked by a test");
  RecordingObserver observer;
  EXPECT_FALSE(measure_scenes(m, {}, observer, result));
  ASSERT_EQ(result.runs.size(), 8u);
  EXPECT_EQ(result.runs[1].algorithm + result.runs[1].architecture + result.runs[1].scene, "oh2006tinysmall");
  EXPECT_EQ(result.runs[6].algorithm + result.runs[6].architecture + result.runs[6].scene,
            "yun2013mobileother");
  EXPECT_EQ(result.runs[0].digest, result.runs[4].digest) << "the two scenes hold the same";
  EXPECT_EQ(observer.open, 0);
  EXPECT_EQ(observer.stages[0], "making rays [rays 0]");
  EXPECT_EQ(observer.stages[1], "yun2013 on tiny [rays " + std::to_string(result.runs[0].all_rays) + "]");
  ASSERT_EQ(observer.remarks.size(), 2u);
  EXPECT_EQ(observer.remarks[1].find("Scene other: "), 0u) << observer.remarks[1];
  ASSERT_EQ(result.inputs.size(), 2u);
  EXPECT_EQ(result.inputs[1].path, m.scenes[1]);
  const std::pair<std::string, std::string> seed{"heightmap of scene small", "7"};
  EXPECT_EQ(result.manifest.seeds.at(0), seed);
  EXPECT_EQ(result.manifest.environment.at(0).second, "asked by a test");
}

TEST_F(MeasureScenes, AScheduleThatAMachineMakesOfTwoAlgorithmsRunsOnceAndIsRemarked) {
  RunRequest m = wanted({"oh2006", "drobot2009"});
  m.machines = resolve_machines(std::vector<std::string>{"tiny"}, {"traverse.up=always"}, m.fidelity);
  EXPECT_EQ(planned_runs(m), 1u);
  RecordingObserver observer;
  remark_same_schedules(m, observer);
  ASSERT_EQ(observer.remarks.size(), 1u);
  EXPECT_NE(observer.remarks[0].find("2 algorithms are 1 different schedules"), std::string::npos);
}

TEST_F(MeasureScenes, StoppedByItsObserverItKeepsWhatIsThereAndSaysSo) {
  const RunRequest m = wanted({"dda", "oh2006"});
  Result result = begin_result("compare", "");
  RecordingObserver observer("dda");
  EXPECT_FALSE(measure_scenes(m, {}, observer, result));
  ASSERT_EQ(result.runs.size(), 1u) << "oh2006 began after the stop";
  ResultFolder folder = open_result_folder(folder_.path("r"), "", false);
  const Completion done = finish_result(m, start_, result, folder);
  EXPECT_LE(done.whole, 1u);
  EXPECT_EQ(done.planned, 2u);
  EXPECT_FALSE(done.complete());
  EXPECT_NE(read("r/manifest.json").find(" of 2 runs are whole"), std::string::npos);
  RecordingObserver at_once("making rays");
  Result nothing = begin_result("compare", "");
  EXPECT_THROW(measure_scenes(m, {}, at_once, nothing), Error) << "rays were made to the end";
}

TEST_F(MeasureScenes, AnErrorAfterAFinishedRunIsGivenBackAndBeforeItThrown) {
  RunRequest m = wanted({"oh2006"});
  m.scenes.push_back(folder_.path("lost.toml"));
  Result result = begin_result("compare", "");
  Observer observer;
  const std::optional<Error> failure = measure_scenes(m, {}, observer, result);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code(), ExitCode::kUsage);
  EXPECT_EQ(result.runs.size(), 1u);
  std::reverse(m.scenes.begin(), m.scenes.end());
  Result nothing = begin_result("compare", "");
  EXPECT_THROW(measure_scenes(m, {}, observer, nothing), Error);
  ResultFolder folder = open_result_folder(folder_.path("none"), "", false);
  EXPECT_THROW(finish_result(m, start_, nothing, folder), Error) << "no run, and a result nevertheless";
}

TEST_F(MeasureScenes, AFinishedResultIsAFolderWithItsConfigurations) {
  const RunRequest m = wanted({"oh2006"}, {"tiny", "mobile"});
  Result result = begin_result("compare", "");
  Observer observer;
  measure_scenes(m, {}, observer, result);
  ResultFolder folder = open_result_folder(folder_.path("r"), "", false);
  EXPECT_TRUE(finish_result(m, start_, result, folder).complete());
  EXPECT_NE(read("r/result.json").find(result.runs[1].digest), std::string::npos);
  EXPECT_NE(read("r/config.resolved.mobile.toml").find("[height_l1]"), std::string::npos);
  EXPECT_NE(read("r/report.html").find("oh2006"), std::string::npos);
  EXPECT_THROW(open_result_folder(folder_.path("r"), "", false), Error) << "an older result was replaced";
}

TEST_F(MeasureScenes, ARunCarriesTheParametersThatItUsedByTheirPaths) {
  RunRequest m = wanted({"oh2006"}, {"desktop"});
  Result result = begin_result("run", "");
  Observer observer;
  measure_scenes(m, {}, observer, result);
  m.fidelity = Fidelity::kFunctional;
  measure_scenes(m, {}, observer, result);
  const Architecture& desktop = m.machines[0].architecture;
  const MachineFacts &timed = result.runs[0].machine, &plain = result.runs[1].machine;
  EXPECT_EQ(timed.at("traverse.contexts"), desktop.traverse.contexts);
  EXPECT_EQ(timed.pipelines(), 8);
  EXPECT_EQ(timed.dram_peak_bytes(),
            int64_t{desktop.dram.channels} * desktop.dram.bus_bytes * desktop.dram.clock_num);
  const auto row = std::ranges::find(timed.parameters, "height_l1.line_bytes", &UsedParameter::path);
  ASSERT_NE(row, timed.parameters.end());
  EXPECT_EQ(row->value, desktop.height_l1.line_bytes);
  EXPECT_EQ(row->unit, "bytes");
  EXPECT_EQ(timed.at("no.such", -1), -1);
  EXPECT_EQ(plain.pipelines(), 8);
  EXPECT_EQ(plain.at("traverse.fraction_bits"), desktop.traverse.fraction_bits);
  for (const char* path : {"machine.clock_mhz", "height_l1.line_bytes", "dram.channels"})
    EXPECT_EQ(plain.at(path), 0) << path << ", in a run without time";
  EXPECT_EQ(plain.dram_peak_cycles(), 1);
}

TEST_F(MeasureScenes, TwoScenesOfOneNameAndAMachineGivenTwiceAreRefused) {
  RunRequest m = wanted({"oh2006"});
  m.scenes.push_back(m.scenes[0]);
  EXPECT_THROW(scene_names(m), Error);
  EXPECT_THROW(resolve_machines(std::vector<std::string>{"tiny", "tiny"}, {}, Fidelity::kCycle), Error);
  EXPECT_THROW(resolve_machines({}, {}, Fidelity::kCycle), Error);
}

TEST_F(MeasureScenes, ASurfaceThatAnAlgorithmDoesNotHaveIsRefusedBeforeTheHeights) {
  RunRequest m = wanted({"relief"});
  check_surfaces(m);
  m.changes.surface = Surface::kBilinear;
  EXPECT_THROW(check_surfaces(m), Error);
}

TEST(Machines, FidelityRtlPutsTheHardwareIntoTheUnitsAndRefusesSearchesThere) {
  const auto rtl = resolve_machines(std::vector<std::string>{"tiny"}, {}, Fidelity::kRtl);
  EXPECT_EQ(rtl[0].architecture.units.hmt_top, Implementation::kRtl);
  EXPECT_THROW(resolve_machines(std::vector<std::string>{"tiny"}, {"units.traverse=rtl"}, Fidelity::kRtl),
               Error);
  const std::vector<Algorithm> relief{parse_algorithm("relief")}, exact{parse_algorithm("dda")};
  EXPECT_THROW(check_searches(relief, rtl), Error);
  check_searches(exact, rtl);
  check_searches(relief, resolve_machines(std::vector<std::string>{"tiny"}, {}, Fidelity::kCycle));
  const auto both = resolve_machines(std::vector<std::string>{"tiny", "desktop"}, {}, Fidelity::kCycle);
  EXPECT_EQ(most_pipelines(both), both[1].architecture.machine.pipelines);
  EXPECT_EQ(most_pipelines({}), 1);
}

TEST(Fidelities, NamesAreReadBackAndOthersRefused) {
  for (const Fidelity fidelity :
       {Fidelity::kFunctional, Fidelity::kTransaction, Fidelity::kCycle, Fidelity::kRtl}) {
    EXPECT_EQ(parse_fidelity(std::string(name_of(fidelity))), fidelity);
  }
  EXPECT_TRUE(runs_every_cycle(Fidelity::kRtl));
  EXPECT_FALSE(runs_every_cycle(Fidelity::kTransaction));
  EXPECT_THROW(parse_fidelity("cicle"), Error);
}

TEST_F(MeasureScenes, WavesOfAPixelWithoutRaysOrOfAPipelineThatIsNotThereAreRefused) {
  const RunRequest m = wanted({"oh2006"});
  Result result = begin_result("run", "");
  RecordingObserver observer;
  WaveRequest waves{folder_.path("w.fst"), {}, std::pair<int64_t, int64_t>{24, 3}, 0};
  EXPECT_THROW(measure_scenes(m, wave_runner(waves, observer), observer, result), Error);
  waves.pixel.reset();
  waves.pipeline = 2;
  EXPECT_THROW(measure_scenes(m, wave_runner(waves, observer), observer, result), Error);
}

}  // namespace
}  // namespace cuesta
