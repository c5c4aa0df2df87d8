#include "tests/sim/cli/cli_fixture.h"

namespace cuesta {
namespace {

class VerifyRtl : public CommandLine {
 protected:
  static void expect_equal(const ProgramResult& result) {
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.out.find(" 0 differences\n"), std::string::npos) << result.out;
  }
};

TEST_F(VerifyRtl, RandomMachinesDoNotDifferAndTheLastLineCountsThem) {
  const ProgramResult result = cuesta({"verify", "rtl", "--ray-count", "500", "--sets", "tiny", "-q"});
  expect_equal(result);
  EXPECT_NE(result.out.find("machines over 1 compiled set; "), std::string::npos) << result.out;
  EXPECT_FALSE(std::filesystem::exists(path("results")));
  expect_equal(cuesta({"verify", "rtl", "--unit", "traverse", "--ray-count", "300", "--seed", "9", "-q"}));
}

TEST_F(VerifyRtl, TheNumberOfWorkersChangesNothingButTheTime) {
  auto last_line = [&](const char* workers) {
    return cuesta({"verify", "rtl", "--ray-count", "2000", "--sets", "tiny", "--workers", workers, "-q"}).out;
  };
  const std::string one = last_line("1"), three = last_line("3");
  EXPECT_NE(one.find(" 0 differences\n"), std::string::npos) << one;
  EXPECT_NE(three.find(" 0 differences\n"), std::string::npos) << three;
}

TEST_F(VerifyRtl, AUsersOwnSceneRaysStallsAndMemoryDoNotDiffer) {
  expect_equal(cuesta({"verify", "rtl", "default", "--arch", "tiny", "--size", "24", "-q"}));
  ASSERT_EQ(
      cuesta({"rays", "make", "lattice", "-o", "own.rays", "--count", "400", "--map-of", "grazing", "-q"})
          .code,
      0);
  const ProgramResult result = cuesta({"verify", "rtl", "grazing", "--arch", "tiny", "--rays", "own.rays",
                                       "--algorithm", "dda", "--stalls", "5:300,0,0,400,200,100,0,0",
                                       "--memory", "6:30,90,4", "--register-seed", "3", "-q"});
  expect_equal(result);
  EXPECT_NE(result.out.find("verify rtl: 400 rays, "), std::string::npos) << result.out;
}

TEST_F(VerifyRtl, RaysAloneRunOverTheDefaultScenesHeights) {
  ASSERT_EQ(cuesta({"rays", "make", "random", "-o", "own.rays", "--count", "64", "-q"}).code, 0);
  const ProgramResult result = cuesta({"verify", "rtl", "--rays", "own.rays", "-q"});
  expect_equal(result);
  EXPECT_NE(result.out.find("verify rtl: 64 rays, "), std::string::npos) << result.out;
  expect_refusal(cuesta({"verify", "rtl", "--rays", "lost.rays", "-q"}), 3, "there is no such file",
                 "a missing trace");
}

TEST_F(VerifyRtl, AStandstillOfBothIsNoDifference) {
  for (const Words& slow :
       {Words{"--memory", "3:2000,2000,4"}, Words{"--set", "dram.response_latency_cycles=10000"},
        Words{"--stalls", "7:999,999,0,999,999,999,999,999"}}) {
    Words words{"verify", "rtl", "front", "--size", "16", "-q", "--set", "machine.no_progress_cycles=1000",
                "-o",     "no"};
    words.insert(words.end(), slow.begin(), slow.end());
    const ProgramResult result = cuesta(words);
    EXPECT_EQ(result.code, 4) << slow[1] << result.out;
    EXPECT_NE(result.err.find("model and RTL alike stand still: no step was finished for 1000 cycles"),
              std::string::npos)
        << result.err;
    EXPECT_FALSE(std::filesystem::exists(path("no")));
  }
}

TEST_F(VerifyRtl, WhatCannotBeComparedIsRefused) {
  std::filesystem::create_directory(path("full"));
  write("full/mine", "kept");
  const Refusal cases[] = {
      {{"--sets", "tniy"}, "There is no compiled set `tniy`"},
      {{"--unit", "traverze"}, "did you mean `traverse`?"},
      {{"--stalls", "1:0,0,0,0,0,0,0,0"}, "no scene is given"},
      {{"--register-seed", "3"}, "--register-seed is about a scene's rays"},
      {{"--register-seed", "0"}, "--register-seed is about a scene's rays"},
      {{"--seconds", "3", "--ray-count", "50"}, "--seconds and --ray-count both say when to stop"},
      {{"--sets", "tiny,,mobile"}, "--sets tiny,,mobile names nothing"},
      {{"default", "--workers", "2"}, "--workers is about random machines"},
      {{"-o", "full"}, "-o full exists and stays as it is; accepted is the name of a new folder or an empty"},
      {{"-o", "full/mine"}, "-o full/mine exists and stays as it is"},
      {{"default", "--seconds", "3"}, "a scene is given"},
      {{"default", "--stalls", "1:0"}, "--stalls 1:0: accepted is SEED:"},
      {{"default", "--memory", "1:9,8,0"}, "--memory 1:9,8,0: accepted is SEED:"},
      {{"default", "--algorithm", "relief"}, "relief is a search; accepted"},
      {{"default", "--size", "8", "--set", "traverse.contexts=48"}, "traverse.contexts is 48"},
      {{"default", "--size", "8", "--set", "traverse.arithmetic=float"}, "accepted is fixed"},
  };
  expect_refusals(cases, {"verify", "rtl", "-q"});
}

}  // namespace
}  // namespace cuesta
