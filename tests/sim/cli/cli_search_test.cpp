#include "tests/sim/cli/cli_fixture.h"

namespace cuesta {
namespace {

using Searches = CommandLine;

TEST_F(Searches, StandBesideExactAlgorithmsWithTheShareOfTheirWrongRays) {
  const ProgramResult result =
      cuesta({"compare", "default", "--size", "32", "--algorithm", "yun2013,parallax,cone", "-o", "r", "-q"});
  ASSERT_EQ(result.code, 0) << result.err;
  for (const char* part :
       {"wrong", "yun2013", "exact", "parallax", " %", "approximate searches on default"}) {
    EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
  }
  const std::string json = read("r/result.json");
  for (const char* part : {"\"error.missed\"", "\"preprocessing.texels_read\"",
                           "\"traverse[0].slots_compute\"", "\"height_error\"", "\"plane.wrong\""}) {
    EXPECT_NE(json.find(part), std::string::npos) << part;
  }
  EXPECT_NE(read("r/manifest.json").find("preprocessing_seconds.cone"), std::string::npos);
}

TEST_F(Searches, AsPrintedShowTheirRaysWithoutAnAnswer) {
  const ProgramResult result = cuesta({"compare", "default", "--size", "32", "--angle", "75", "--algorithm",
                                       "oh2006,ki2007-printed:delta=0,printed", "-o", "r", "-q"});
  ASSERT_EQ(result.code, 0) << result.err;
  for (const char* part : {"wrong", "NaN", "endless", "ki2007-printed:delta=0", "drobot2009-printed"}) {
    EXPECT_NE(result.out.find(part), std::string::npos) << part << "\n" << result.out;
  }
  const std::string json = read("r/result.json");
  for (const char* part : {"\"error.nan\"", "\"error.unfinished\""}) {
    EXPECT_NE(json.find(part), std::string::npos) << part;
  }
}

TEST_F(Searches, GiveTheSameHitsAtBothFidelities) {
  const auto digest = [&](const char* fidelity) {
    const ProgramResult result = cuesta({"run", "default", "--size", "32", "--algorithm",
                                         "relief:steps=20:bilinear", "--fidelity", fidelity, "--json", "-q"});
    EXPECT_EQ(result.code, 0) << result.err;
    const size_t at = result.out.find("\"hits_digest\"");
    return at == std::string::npos ? std::string() : result.out.substr(at, 90);
  };
  const std::string functional = digest("functional");
  EXPECT_GT(functional.size(), 80u);
  EXPECT_EQ(functional, digest("cycle"));
}

TEST_F(Searches, WhereTheyCannotGoTheyAreRefused) {
  const Refusal cases[] = {
      {{"--algorithm", "relief", "--fidelity", "rtl"}, "relief is a search"},
      {{"--algorithm", "cone", "--host", "systemc"}, "accepted with it are exact algorithms"},
      {{"--algorithm", "steep", "--set", "traverse.up=always"}, "which has none"},
      {{"--algorithm", "relief:steps=0"}, "`steps` is `0`; accepted is a whole number from 1 to 4096"},
      {{"--algorithm", "relif"}, "did you mean `relief`?"},
      {{"--algorithm", "RELIEF"}, "did you mean `relief`?"},
  };
  expect_refusals(cases, {"run", "default", "--size", "16", "-q"});
  // Before anything is run, and so without a result.
  expect_refusal(
      cuesta({"compare", "default", "--size", "16", "--algorithm", "dda,relief", "--fidelity", "rtl", "-q"}),
      2, "relief is a search", "compare");
  EXPECT_FALSE(std::filesystem::exists(path("results")));
}

}  // namespace
}  // namespace cuesta
