#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "tests/sim/cli/cli_fixture.h"

// Hardware in the machine's units, as a user meets it.

namespace cuesta {
namespace {

std::string digest_in(const std::string& json) {
  std::smatch found;
  return std::regex_search(json, found, std::regex("\"digest\": *\"([0-9a-f]{64})\"")) ? found[1].str() : "";
}

class CommandLineRtl : public CommandLine {
 protected:
  /// The digest of a run of small.toml; empty when it fails.
  std::string digest_of(Words more) const {
    Words words{"run", "small.toml", "-q", "--force", "-o", "result"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramResult result = cuesta(words);
    EXPECT_EQ(result.code, 0) << result.err;
    return result.code == 0 ? digest_in(read("result/result.json")) : "";
  }
};

TEST_F(CommandLineRtl, FidelityRtlGivesTheDigestOfCycleOnEveryPresetAndHost) {
  write("small.toml", kSmallScene);
  for (const char* preset : {"tiny", "mobile", "desktop"}) {
    const std::string digest = digest_of({"--arch", preset});
    ASSERT_EQ(digest.size(), 64u);
    EXPECT_EQ(digest_of({"--arch", preset, "--fidelity", "rtl"}), digest) << preset;
    EXPECT_NE(read("result/result.json").find("\"rtl\""), std::string::npos);
    EXPECT_NE(read("result/config.resolved.toml").find("--fidelity rtl"), std::string::npos);
    EXPECT_EQ(digest_of({"--arch", preset, "--set", "units.traverse=rtl"}), digest) << preset;
    EXPECT_EQ(digest_of({"--arch", preset, "--fidelity", "rtl", "--host", "systemc"}), digest) << preset;
  }
}

TEST_F(CommandLineRtl, ARayOfMoreStepsThanTheCyclesWithoutProgressIsNoRayWithoutAnEnd) {
  write("small.toml",
        "[heightmap]\ngenerate = { kind = \"flat\", width = 1024, height = 1024 }\n[surface]\ndepth = 1.0\n"
        "[camera]\nangle_degrees = 89.7\n[image]\nwidth = 8\nheight = 8\n");
  const Words patient{"--algorithm", "dda", "--set", "machine.no_progress_cycles=1000"};
  const std::string digest = digest_of(patient);
  const std::string json = read("result/result.json");
  std::smatch steps;
  ASSERT_TRUE(
      std::regex_search(json, steps, std::regex("\"steps_per_ray\": *\\{[^}]*\"value\": *([0-9.]+)")));
  EXPECT_GT(std::stod(steps[1]), 1000);
  Words rtl = patient;
  rtl.insert(rtl.end(), {"--fidelity", "rtl"});
  EXPECT_EQ(digest_of(rtl), digest);
}

TEST_F(CommandLineRtl, WavesOfCyclesAndOfAPixelAreWrittenAndChangeNothing) {
  write("small.toml", kSmallScene);
  const std::string digest = digest_of({});
  EXPECT_EQ(digest_of({"--fidelity", "rtl", "--waves", "a.fst", "--waves-cycles", "40:90"}), digest);
  EXPECT_EQ(digest_of({"--fidelity", "rtl", "--waves", "b.fst", "--waves-pixel", "3,12"}), digest);
  EXPECT_EQ(digest_of({"--set", "units.traverse=rtl", "--waves", "c.fst"}), digest);
  for (const char* name : {"a.fst", "b.fst", "c.fst"}) {
    const std::string fst = read(name);
    ASSERT_GT(fst.size(), 330u) << name;
    // An FST file begins with its header block: type 0, length 329.
    EXPECT_EQ(fst.substr(0, 9), std::string("\0\0\0\0\0\0\0\1\x49", 9)) << name;
  }
  // Then its first and last time, each 8 bytes, the highest first; a cycle takes two.
  auto time = [](const std::string& fst, size_t at) {
    uint64_t value = 0;
    for (size_t k = at; k < at + 8; ++k) value = value << 8 | static_cast<uint8_t>(fst[k]);
    return value;
  };
  EXPECT_EQ(time(read("a.fst"), 9), 2u * 40);
  EXPECT_EQ(time(read("a.fst"), 17), 2u * 90 + 1);
  EXPECT_EQ(time(read("c.fst"), 9), 0u);
  EXPECT_EQ(time(read("c.fst"), 17), 2u * 999 + 1);
  expect_refusal(cuesta({"run", "small.toml", "--fidelity", "rtl", "--waves", "a.fst"}), 2,
                 "exists and stays as it is", "again");
  expect_refusal(cuesta({"run", "small.toml", "--fidelity", "rtl", "--waves", "a.vcd"}), 2, ".fst", "a VCD");
  expect_refusal(cuesta({"run", "small.toml", "--waves-cycles", "1:2"}), 2, "--waves FILE.fst",
                 "without a file");
  const ProgramResult model = cuesta({"run", "small.toml", "-q", "--waves", "d.fst"});
  EXPECT_EQ(model.code, 2);
  EXPECT_NE(model.err.find("--fidelity rtl"), std::string::npos) << model.err;
}

TEST_F(CommandLineRtl, WhatNoCompiledHardwareIsIsRefusedWithTheKeyTheNearestSetAndTheOption) {
  write("small.toml", kSmallScene);
  write("odd.toml", "[heightmap]\ngenerate = { kind = \"rocks\", width = 24, height = 32 }\n");
  write("mirror.toml",
        "[surface]\naddress = \"mirror\"\n" + kSmallScene.substr(0, kSmallScene.find("[surface]")));
  const Refusal cases[] = {
      {{"small.toml", "--set", "traverse.contexts=48"},
       "nearest is mobile: traverse.contexts is 48, compiled is 32"},
      {{"small.toml", "--set", "traverse.contexts=48"}, "CUESTA_RTL_SETS"},
      {{"small.toml", "--set", "height_l1.mshrs=9"}, "height_l1.mshrs is 9"},
      {{"small.toml", "--set", "traverse.arithmetic=double"}, "floating point"},
      {{"small.toml", "--set", "traverse.fetch=quad"}, "traverse.fetch"},
      {{"small.toml", "--set", "traverse.down=common", "--set", "traverse.start=root"}, "traverse.down"},
      {{"small.toml", "--set", "texels.layout=blocks_4x4"}, "texels.layout"},
      {{"odd.toml"}, "24 x 32"},
      {{"mirror.toml"}, "mirror"},
  };
  expect_refusals(cases, {"run", "-q", "--fidelity", "rtl", "-o", "result", "--force"});
}

}  // namespace
}  // namespace cuesta
