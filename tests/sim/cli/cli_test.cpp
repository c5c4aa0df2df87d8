#include <nlohmann/json.hpp>

#include "tests/sim/cli/cli_fixture.h"

namespace cuesta {
namespace {

using Json = nlohmann::json;

TEST_F(CommandLine, ListsNameWhatThereIs) {
  const struct {
    const char* what;
    const char* part;
  } cases[] = {{"algorithms", "yun2013-coherent"}, {"scenes", "default"},
               {"architectures", "desktop"},       {"effects", "None yet"},
               {"parameters", "dram.tRCD"},        {"statistics", "height_l1.misses"}};
  for (const auto& [what, part] : cases) {
    const ProgramResult result = cuesta({"list", what});
    EXPECT_EQ(result.code, 0) << what;
    EXPECT_NE(result.out.find(part), std::string::npos) << result.out;
  }
}

TEST_F(CommandLine, RunLeavesAWholeResultFolder) {
  write("small.toml", kSmallScene);
  const ProgramResult result = cuesta({"run", "small.toml", "-q"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const std::string folder = "results/small-yun2013-001/";
  EXPECT_NE(result.out.find("/results/small-yun2013-001/report.html"), std::string::npos) << result.out;
  for (const char* name :
       {"result.json", "result.csv", "manifest.json", "config.resolved.toml", "report.html"}) {
    EXPECT_FALSE(read(folder + name).empty()) << name;
  }
  const Json json = Json::parse(read(folder + "result.json"));
  EXPECT_EQ(json["runs"].size(), 1u);
  EXPECT_EQ(json["runs"][0]["fidelity"], "cycle");
  EXPECT_EQ(json["runs"][0]["architecture"], "mobile");
  EXPECT_EQ(cuesta({"run", "small.toml", "-q"}).code, 0);
  EXPECT_TRUE(std::filesystem::exists(path("results/small-yun2013-002/result.json")));
}

TEST_F(CommandLine, TheResolvedConfigurationGivesTheSameDigest) {
  write("small.toml", kSmallScene);
  ASSERT_EQ(
      cuesta({"run", "small.toml", "--arch", "tiny", "--set", "ray_setup.latency_cycles=30", "-o", "a"}).code,
      0);
  ASSERT_EQ(cuesta({"run", "small.toml", "--arch", "a/config.resolved.toml", "-o", "b"}).code, 0);
  const Json a = Json::parse(read("a/result.json")), b = Json::parse(read("b/result.json"));
  EXPECT_EQ(a["runs"][0]["digest"], b["runs"][0]["digest"]);
  ASSERT_EQ(cuesta({"run", "small.toml", "--arch", "tiny", "-o", "c"}).code, 0);
  EXPECT_NE(a["runs"][0]["digest"], Json::parse(read("c/result.json"))["runs"][0]["digest"]);
}

TEST_F(CommandLine, CompareFindsTheSameHitsWhateverTheMachineAndFidelity) {
  write("small.toml", kSmallScene);
  const ProgramResult timed = cuesta({"compare", "small.toml", "--arch", "tiny,desktop", "--json", "-q"});
  const ProgramResult plain = cuesta({"compare", "small.toml", "--fidelity", "functional", "--json", "-q"});
  ASSERT_EQ(timed.code, 0) << timed.err;
  ASSERT_EQ(plain.code, 0) << plain.err;
  const Json json = Json::parse(timed.out), other = Json::parse(plain.out);
  EXPECT_EQ(json, Json::parse(read("results/small-compare-001/result.json")));
  ASSERT_EQ(json["runs"].size(), 16u);
  ASSERT_EQ(other["runs"].size(), 8u);
  for (size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(json["runs"][k]["hits_digest"], json["runs"][k + 8]["hits_digest"]);
    EXPECT_EQ(json["runs"][k]["hits_digest"], other["runs"][k]["hits_digest"]);
    EXPECT_NE(json["runs"][k]["digest"], json["runs"][k + 8]["digest"]);
  }
}

TEST_F(CommandLine, RaysFromAFileGiveTheDigestOfTheScene) {
  write("small.toml", kSmallScene);
  ASSERT_EQ(cuesta({"trace", "small.toml", "-o", "small.rays"}).code, 0);
  ASSERT_EQ(cuesta({"run", "small.toml", "-o", "a"}).code, 0);
  ASSERT_EQ(cuesta({"run", "small.toml", "--rays", "small.rays", "-o", "b"}).code, 0);
  EXPECT_EQ(Json::parse(read("a/result.json"))["runs"][0]["digest"],
            Json::parse(read("b/result.json"))["runs"][0]["digest"]);
}

TEST_F(CommandLine, AFileWithoutRaysIsCalledSo) {
  write("small.toml", kSmallScene);
  ASSERT_EQ(cuesta({"trace", "small.toml", "-q", "-o", "all.csv"}).code, 0);
  const std::string all = read("all.csv");
  write("none.csv", all.substr(0, all.find('\n', all.find('\n') + 1) + 1));
  expect_refusal(cuesta({"run", "small.toml", "--rays", "none.csv", "-q"}), 3, "none.csv holds none", "none");
}

TEST_F(CommandLine, HeightmapOptionTakesAnImageAndAChannel) {
  ASSERT_EQ(cuesta({"heightmap", "make", "rocks", "-o", "own.png"}).code, 0);
  const ProgramResult result =
      cuesta({"run", "--heightmap", "own.png:0", "--size", "16", "--angle", "80", "-o", "a"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(Json::parse(read("a/result.json"))["runs"][0]["scene"], "own");
  expect_refusal(cuesta({"run", "--heightmap", "own.png:B", "-q"}), 3, "own.png",
                 "a channel that is not there");
}

TEST_F(CommandLine, WithoutTheModuleBesideItTheProgramRefusesImagesBeforeTheWork) {
  const std::string alone = path("alone");
  std::filesystem::copy_file(CUESTA_PROGRAM, alone);
  const auto run = [&](const Words& words) { return run_program(alone, words, path("")); };
  write("small.toml", kSmallScene);
  EXPECT_EQ(run({"list", "algorithms"}).code, 0);
  EXPECT_EQ(run({"trace", "small.toml", "-q", "-o", "a.csv"}).code, 0);
  expect_refusal(run({"run", "small.toml", "-o", "a"}), 6, "there is no cuesta_images.so beside ", "planes");
  EXPECT_FALSE(std::filesystem::exists(path("a")));
  const Words make = {"heightmap", "make", "rocks", "-o", "map.png", "--size", "4"};
  expect_refusal(run(make), 6, "there is no cuesta_images.so beside ", "no module");
  EXPECT_FALSE(std::filesystem::exists(path("map.png")));
  write("cuesta_images.so", "not a library");
  expect_refusal(run(make), 6, "Images cannot be read or written: ", "a broken module");
  expect_refusal(run({"run", "small.toml", "-o", "a"}), 6, "Images cannot", "a broken module");
  EXPECT_FALSE(std::filesystem::exists(path("a")));
  std::filesystem::copy_file(std::filesystem::path(CUESTA_PROGRAM).parent_path() / "cuesta_images.so",
                             path("cuesta_images.so"), std::filesystem::copy_options::overwrite_existing);
  const ProgramResult made = run(make);
  EXPECT_EQ(made.code, 0) << made.err;
}

TEST_F(CommandLine, AnExistingResultFolderIsNeverDamaged) {
  write("small.toml", kSmallScene);
  write("broken.toml", kSmallScene + "x = 1\n");
  ASSERT_EQ(cuesta({"run", "small.toml", "-o", "out"}).code, 0);
  const auto before = tree("out");
  EXPECT_GE(before.size(), 6u);
  expect_refusal(cuesta({"run", "small.toml", "-o", "out", "-q"}), 2, "exists", "without --force");
  expect_refusal(cuesta({"run", "broken.toml", "-o", "out", "--force"}), 2, "unknown key", "broken scene");
  expect_refusal(cuesta({"run", "small.toml", "--rays", "none.rays", "-o", "out", "--force"}), 3, "none.rays",
                 "no rays");
  expect_refusal(cuesta({"run", "small.toml", "--arch", "none.toml", "-o", "out", "--force"}), 2, "none.toml",
                 "no arch");
  EXPECT_EQ(tree("out"), before);
  ASSERT_EQ(cuesta({"run", "small.toml", "--algorithm", "dda", "-o", "out", "--force"}).code, 0);
  EXPECT_NE(tree("out"), before);

  std::filesystem::create_directory(path("mine"));
  write("mine/letter.txt", "dear");
  expect_refusal(cuesta({"run", "small.toml", "-o", "mine", "--force", "-q"}), 2, "not a result folder",
                 "other folder");
  EXPECT_EQ(read("mine/letter.txt"), "dear");
  for (const auto& entry : std::filesystem::directory_iterator(path(""))) {
    EXPECT_NE(entry.path().filename().string().front(), '.') << "left behind: " << entry.path();
  }
}

TEST_F(CommandLine, InterruptKeepsWhatIsFinishedAndSaysSo) {
  const Interrupt interrupt{"Scene ", 400};
  const ProgramResult result = cuesta({"compare", "default", "--size", "1024", "-o", "out"}, &interrupt);
  EXPECT_EQ(result.code, 7) << result.err;
  if (!std::filesystem::exists(path("out"))) return;  // stopped before the first run began
  const Json json = Json::parse(read("out/result.json"));
  EXPECT_LE(json["runs"].size(), 8u);
  const Json& last = json["runs"].back();
  EXPECT_EQ(last["partial"].get<bool>(), last["rays"]["finished"] < last["rays"]["of"]);
  EXPECT_NE(result.err.find("of 8 runs are whole"), std::string::npos) << result.err;
}

TEST_F(CommandLine, EverySignalToStopLeavesNothingUnfinishedBehind) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Interrupt interrupt{"Scene ", 200, signal};
    EXPECT_EQ(cuesta({"compare", "default", "--size", "1024", "-o", "out"}, &interrupt).code, 7) << signal;
    for (const auto& entry : std::filesystem::directory_iterator(path(""))) {
      EXPECT_EQ(entry.path().filename().string().find("unfinished"), std::string::npos) << entry.path();
    }
    std::filesystem::remove_all(path("out"));
  }
}

TEST_F(CommandLine, ATraceThatIsStoppedLeavesNoFile) {
  const Interrupt interrupt{"", 300};
  const ProgramResult result =
      cuesta({"rays", "make", "stratified", "--count", "20000000", "-o", "many.rays"}, &interrupt);
  EXPECT_TRUE(result.code == 7 || result.code == 128 + SIGINT) << result.code << result.err;
  EXPECT_TRUE(std::filesystem::is_empty(path("")));
}

TEST_F(CommandLine, AnEmptyFolderIsTakenForTheResult) {
  write("small.toml", kSmallScene);
  std::filesystem::create_directory(path("mine"));
  const ProgramResult result = cuesta({"run", "small.toml", "-o", "mine", "-q"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_FALSE(read("mine/result.json").empty());
  EXPECT_FALSE(std::filesystem::exists(path("mine-2")));
}

TEST_F(CommandLine, ANameTooLongIsCalledSo) {
  write("small.toml", kSmallScene);
  expect_refusal(cuesta({"run", "small.toml", "-o", std::string(300, 'a'), "-q"}), 2, "File name too long",
                 "folder");
  expect_refusal(
      cuesta({"rays", "make", "random", "--count", "5", "-o", std::string(300, 'a') + ".rays", "-q"}), 6,
      "File name too long", "file");
}

TEST_F(CommandLine, WhatWasMeasuredBeforeAFailureIsKeptAndTheFailuresCodeReturned) {
  write("small.toml", kSmallScene);
  write("stuck.toml",
        "base = \"tiny\"\n[machine]\nno_progress_cycles = 1000\n[dram]\nrequest_latency_cycles = 10000\n");
  const ProgramResult result = cuesta(
      {"compare", "small.toml", "--algorithm", "dda,oh2006", "--arch", "tiny,stuck.toml", "-o", "out", "-q"});
  EXPECT_EQ(result.code, 4) << result.err;
  EXPECT_NE(result.err.find("2 of 4 runs are whole"), std::string::npos) << result.err;
  const Json json = Json::parse(read("out/result.json"));
  EXPECT_EQ(json["runs"].size(), 2u);
  EXPECT_NE(read("out/manifest.json").find("2 of 4 runs are whole"), std::string::npos);
}

TEST_F(CommandLine, AContradictionNamesTheLineThatDecides) {
  write("small.toml", kSmallScene);
  write("fast.toml", "base = \"tiny\"\n[traverse]\nstages = 8\ncontexts = 4\n");
  expect_refusal(cuesta({"run", "small.toml", "--arch", "fast.toml", "-q"}), 2, "fast.toml:3: ", "file");
  expect_refusal(cuesta({"run", "small.toml", "--arch", "fast.toml", "--set", "traverse.contexts=2", "-q"}),
                 2, "--set traverse.contexts: ", "setting");
}

TEST_F(CommandLine, RaySetsRunFromASceneAndFromAFileAlike) {
  const std::string map = "[heightmap]\ngenerate = { kind = \"rocks\", width = 32, height = 32 }\n";
  write("set.toml", map + "[rays]\nset = \"adversarial\"\ncount = 500\nseed = 7\n");
  write("plain.toml", map);
  ASSERT_EQ(cuesta({"rays", "make", "adversarial", "-o", "a.csv", "--count", "500", "--seed", "7", "--map-of",
                    "plain.toml"})
                .code,
            0);
  ASSERT_EQ(cuesta({"rays", "make", "adversarial", "-o", "b.rays", "--count", "500", "--seed", "7", "--width",
                    "32", "--height", "32"})
                .code,
            0);
  ASSERT_EQ(cuesta({"run", "set.toml", "-o", "set"}).code, 0);
  ASSERT_EQ(cuesta({"run", "plain.toml", "--rays", "a.csv", "-o", "a"}).code, 0);
  ASSERT_EQ(cuesta({"run", "plain.toml", "--rays", "b.rays", "-o", "b"}).code, 0);
  const auto digest = [&](const std::string& folder) {
    return Json::parse(read(folder + "/result.json"))["runs"][0]["digest"];
  };
  EXPECT_EQ(digest("set"), digest("a"));
  EXPECT_EQ(digest("set"), digest("b"));
  expect_refusal(cuesta({"run", "set.toml", "--angle", "20", "-q"}), 2, "the set adversarial", "angle");
  write("both.toml", map + "[rays]\nset = \"random\"\nfile = \"a.csv\"\n");
  expect_refusal(cuesta({"run", "both.toml", "-q"}), 2, "both.toml:5", "file and set");
}

TEST_F(CommandLine, AFrameThatNoHostHoldsIsRefusedAsAResource) {
  expect_refusal(cuesta({"run", "default", "--size", "16384", "-q"}), 6, "GiB of memory", "2^28 rays");
}

TEST_F(CommandLine, OutputThatIsLostIsAnErrorAndAReaderThatLeavesIsNone) {
  const std::string list = std::string(CUESTA_PROGRAM) + " list parameters";
  EXPECT_EQ(run_program("/bin/sh", {"-c", list + " > /dev/full"}, path("")).code, 6);
  const std::string left = "{ sleep 1; " + list + "; echo $? >&2; } | true";
  EXPECT_EQ(run_program("/bin/sh", {"-c", left}, path("")).err, "0\n");
}

TEST_F(CommandLine, LawsHoldOnASmallSweep) {
  const ProgramResult result = cuesta({"verify", "laws", "--size", "8", "--scene", "default", "-q"});
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("0 broken laws, 0 different hits"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace cuesta
