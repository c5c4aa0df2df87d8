#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "tests/sim/cli/cli_fixture.h"

namespace cuesta {
namespace {

std::string digest_in(const std::string& json) {
  std::smatch found;
  return std::regex_search(json, found, std::regex("\"digest\": *\"([0-9a-f]{64})\"")) ? found[1].str() : "";
}

TEST_F(CommandLine, HostSystemcGivesTheDigestOfHostDirectAndSaysThatItRan) {
  write("small.toml", kSmallScene);
  for (const char* host : {"direct", "systemc"}) {
    const ProgramResult result = cuesta({"run", "small.toml", "--host", host, "-q", "-o", host});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "") << "a report of SystemC's on stderr";
    EXPECT_NE(read(std::string(host) + "/manifest.json").find("\"simulation_host\": \"" + std::string(host)),
              std::string::npos);
  }
  const std::string digest = digest_in(read("direct/result.json"));
  ASSERT_EQ(digest.size(), 64u);
  EXPECT_EQ(digest_in(read("systemc/result.json")), digest);
}

TEST_F(CommandLine, HostSystemcRunsABilinearSurfaceLikeHostDirect) {
  write("small.toml", kSmallScene);
  for (const char* host : {"direct", "systemc"}) {
    const ProgramResult result = cuesta({"run", "small.toml", "--surface", "bilinear", "--set",
                                         "traverse.arithmetic=float", "--host", host, "-q", "-o", host});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
  }
  const std::string digest = digest_in(read("direct/result.json"));
  ASSERT_EQ(digest.size(), 64u);
  EXPECT_EQ(digest_in(read("systemc/result.json")), digest);
}

TEST_F(CommandLine, VcdHoldsTheSignalsAndChangesNothing) {
  write("small.toml", kSmallScene);
  const ProgramResult plain = cuesta({"run", "small.toml", "-q", "-o", "plain"});
  const ProgramResult waves =
      cuesta({"run", "small.toml", "--host", "systemc", "--vcd", "w.vcd", "-q", "-o", "waves"});
  ASSERT_EQ(waves.code, 0) << waves.err;
  EXPECT_EQ(digest_in(read("waves/result.json")), digest_in(read("plain/result.json")));
  const std::string vcd = read("w.vcd");
  for (const char* name : {"memory_out", "hits_out", "traverse_0", "contexts", "height_l1_0", "mshrs"}) {
    EXPECT_NE(vcd.find(name), std::string::npos) << name;
  }
  expect_refusal(cuesta({"run", "small.toml", "--host", "systemc", "--vcd", "no/such/folder/w.vcd"}), 2,
                 "The waves cannot be written", "a folder that is not there");
}

}  // namespace
}  // namespace cuesta
