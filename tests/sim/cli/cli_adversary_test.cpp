#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/explore/adversary/adversary.h"
#include "tests/sim/cli/cli_fixture.h"

// The verb as a user meets it, and the search behind it.

namespace cuesta {
namespace {

AdversaryResult searched(Maximise maximise, const char* algorithm, bool learns, uint64_t seed,
                         uint64_t tries) {
  AdversaryOptions options;
  options.seed = seed;
  options.learns = learns;
  Architecture architecture;
  architecture.traverse.arithmetic = Arithmetic::kDouble;
  const AdversaryScorer scorer(*find_algorithm(algorithm), architecture, AddressMode::kWrap, maximise);
  return run_adversary(scorer, options, [&](uint64_t done, double) { return done < tries; });
}

TEST(Adversary, BeatsTheBestOfAsManyRandomCases) {
  for (const char* algorithm : {"oh2006", "yun2013", "cone"}) {
    const AdversaryResult found = searched(Maximise::kSteps, algorithm, true, 3, 1500);
    const AdversaryResult random = searched(Maximise::kSteps, algorithm, false, 3, 1500);
    EXPECT_EQ(found.fault, "");
    EXPECT_EQ(found.tries, 1500u);
    EXPECT_EQ(random.tries, 1500u);
    EXPECT_GT(found.score, 1.15 * random.score) << algorithm;
  }
}

TEST(Adversary, FindsTheSameCaseWithTheSameSeedAndTriesAndAnotherWithAnother) {
  const AdversaryResult a = searched(Maximise::kError, "relief", true, 5, 400);
  const AdversaryResult b = searched(Maximise::kError, "relief", true, 5, 400);
  const AdversaryResult c = searched(Maximise::kError, "relief", true, 6, 400);
  EXPECT_EQ(a.score, b.score);
  EXPECT_EQ(a.best.grid.texels, b.best.grid.texels);
  EXPECT_NE(a.best.grid.texels, c.best.grid.texels);
  EXPECT_GT(a.score, 0);
}

TEST(Adversary, AnExactAlgorithmInDoubleHasHardlyAnyError) {
  EXPECT_LT(searched(Maximise::kError, "yun2013", true, 7, 600).score, 1e-9);
}

using AdversaryCommand = CommandLine;

TEST_F(AdversaryCommand, TheScoreIsWhatTheOrdinaryRunCounts) {
  const Words search = {"adversary", "--algorithm", "tevs2008", "--tries", "60",
                        "--size",    "9x16",        "--rays",   "5",       "-q"};
  const struct {
    const char *maximise, *fidelity, *counter;
  } cases[] = {{"steps", "functional", "machine.steps"}, {"cycles", "cycle", "machine.cycles"}};
  for (const auto& [maximise, fidelity, counter] : cases) {
    Words words = search;
    words.insert(words.end(), {"--maximise", maximise, "-o", maximise});
    const ProgramResult found = cuesta(words);
    ASSERT_EQ(found.code, 0) << found.err;
    const ProgramResult run = cuesta({"run", std::string(maximise) + "/scene.toml", "--algorithm", "tevs2008",
                                      "--arch", "tiny", "--fidelity", fidelity, "--json", "-q"});
    ASSERT_EQ(run.code, 0) << run.err;
    const auto counters = nlohmann::json::parse(run.out)["runs"][0]["counters"];
    char score[64];
    std::snprintf(score, sizeof score, "score = %g\n", counters[counter]["value"].get<double>() / 5);
    EXPECT_NE(read(std::string(maximise) + "/case.toml").find(score), std::string::npos)
        << score << read(std::string(maximise) + "/case.toml");
    EXPECT_NE(found.out.find("Reproduce: cuesta run " + path(maximise) + "/scene.toml"), std::string::npos)
        << found.out;
    EXPECT_NE(found.out.find(std::string(counter) + " over machine.rays"), std::string::npos) << found.out;
  }
}

TEST_F(AdversaryCommand, AnErrorIsNotSoughtInARunThatDoesNotPrintIt) {
  for (const std::string algorithm : {"relief", "yun2013"}) {
    const ProgramResult found =
        cuesta({"adversary", "--algorithm", algorithm, "--maximise", "error", "--set",
                "traverse.arithmetic=float", "--tries", "50", "--size", "8", "-o", algorithm, "-q"});
    ASSERT_EQ(found.code, 0) << found.err;
    EXPECT_NE(found.out.find("The run does not print the score"), std::string::npos) << found.out;
    EXPECT_NE(found.out.find("It is `score` in case.toml"), std::string::npos) << found.out;
    // the command that it names instead: the same case and score
    const std::string head = "\nSearch again: cuesta ";
    ASSERT_NE(found.out.find(head), std::string::npos) << found.out;
    std::istringstream line(found.out.substr(found.out.find(head) + head.size()));
    Words words;
    for (std::string word; line >> word;) words.push_back(word);
    const ProgramResult again = cuesta(words);
    ASSERT_EQ(again.code, 0) << again.err;
    const auto score = [&](const std::string& folder) {
      const std::string text = read(folder + "/case.toml");
      return text.substr(text.find("score = "),
                         text.find('\n', text.find("score = ")) - text.find("score = "));
    };
    EXPECT_EQ(score("again"), score(algorithm));
    EXPECT_EQ(again.out.substr(0, again.out.find(',')), found.out.substr(0, found.out.find(',')));
    std::filesystem::remove_all(path("again"));
  }
}

TEST_F(AdversaryCommand, WritesTheSameBytesAgainAndNeverOverAFolderUnasked) {
  const auto run = [&](const char* folder, const char* force) {
    Words words = {"adversary", "--algorithm", "dda", "--tries", "40", "--size", "8", "-o", folder, "-q"};
    if (force != nullptr) words.emplace_back(force);
    return cuesta(words);
  };
  ASSERT_EQ(run("a", nullptr).code, 0);
  ASSERT_EQ(run("b", nullptr).code, 0);
  for (const char* file : {"map.png", "rays.csv", "scene.toml", "case.toml", "README.md"}) {
    EXPECT_EQ(read(std::string("a/") + file), read(std::string("b/") + file)) << file;
    EXPECT_GT(read(std::string("a/") + file).size(), 50u) << file;
  }
  EXPECT_EQ(run("a", nullptr).code, 2);
  EXPECT_EQ(run("a", "--force").code, 0);
  write("a/notes.txt", "mine");
  EXPECT_EQ(run("a", "--force").code, 2);
  EXPECT_EQ(read("a/notes.txt"), "mine");
}

TEST_F(AdversaryCommand, InterruptedItKeepsTheBestSoFar) {
  const Interrupt interrupt{"dda, steps", 100};
  const ProgramResult result = cuesta(
      {"adversary", "--algorithm", "dda", "--seconds", "600", "--size", "8", "-o", "kept"}, &interrupt);
  EXPECT_EQ(result.code, 7) << result.err;
  EXPECT_NE(read("kept/case.toml").find("algorithm = \"dda\""), std::string::npos) << result.err;
}

TEST_F(AdversaryCommand, WhatItCannotSearchIsRefused) {
  const Refusal cases[] = {
      {{"--maximise", "stepps"}, "did you mean `steps`?"},
      {{"--address", "repeat"}, "border, wrap, mirror, clamp"},
      {{"--size", "65"}, "--size 65: accepted is one number of texels or WIDTHxHEIGHT, each from 1 to 64"},
      {{"--size", "0x8"}, "each from 1 to 64"},
      {{"--algorithm", "oh2006:stop=1"}, "stop at level 0"},
      {{"--algorithm", "dda,oh2006"}, "one algorithm"}};
  expect_refusals(cases, {"adversary", "--tries", "2", "-o", "no"});
  EXPECT_FALSE(std::filesystem::exists(path("no")));
}

}  // namespace
}  // namespace cuesta
