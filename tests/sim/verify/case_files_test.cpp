#include "sim/verify/lockstep/case_files.h"

#include <gtest/gtest.h>

#include <sstream>

#include "models/common/error.h"
#include "sim/config/architecture_file.h"
#include "sim/config/parameters.h"
#include "sim/session/job.h"
#include "sim/verify/lockstep/random_rtl_case.h"
#include "tests/support/temporary_folder.h"

namespace cuesta {
namespace {

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

TEST(CaseFiles, WhatIsWrittenIsReadBackAsTheSameCase) {
  for (uint64_t seed = 1; seed <= 25; ++seed) {
    RtlStructure structure;
    structure.height_bits = seed % 2 == 0 ? 8 : 16;
    const LockstepCase one = random_rtl_case(structure, seed, 50);
    const TemporaryFolder folder;
    const std::vector<std::string> arguments = words(write_case(one, folder.path("."), folder.path(".")));
    auto value = [&](const std::string& option) {
      const auto found = std::ranges::find(arguments, option);
      return found == arguments.end() ? std::string() : *(found + 1);
    };

    const Job job = prepare_job(arguments.at(0), {});
    EXPECT_EQ(job.map.width, one.map().width);
    EXPECT_EQ(job.map.bits, one.map().bits);
    EXPECT_EQ(job.map.address_mode, one.map().address_mode);
    for (int j = 0; j < job.map.height; ++j) {
      for (int i = 0; i < job.map.width; ++i) ASSERT_EQ(job.pyramid.at(0, i, j), one.pyramid->at(0, i, j));
    }
    EXPECT_TRUE(identical(job.trace, {one.width, one.height, one.rays}));

    const Architecture read = resolve_architecture(value("--arch"), {}, true).architecture;
    for (const Parameter& parameter : parameters())
      EXPECT_EQ(parameter.get(read), parameter.get(one.machine.architecture)) << parameter.path;
    EXPECT_EQ(parse_algorithm(value("--algorithm")).id, parse_algorithm(name_of(one.machine.schedule)).id);
    const std::string stalls = value("--stalls"), memory = value("--memory");
    EXPECT_EQ(memory.empty(), !one.machine.memory.has_value());
    if (!memory.empty())
      EXPECT_EQ(text_of(parse_memory_timing(memory, "--memory")), text_of(*one.machine.memory));
    if (!stalls.empty()) EXPECT_EQ(text_of(parse_stalls(stalls, "--stalls")), text_of(one.machine.stalls));
    const bool any =
        std::ranges::any_of(one.machine.stalls.per_mille, [](uint16_t chance) { return chance > 0; });
    EXPECT_EQ(stalls.empty(), !any);
  }
}

TEST(CaseFiles, StallsAndMemoriesThatAreNotSpelledRightAreRefused) {
  for (const char* text : {"", "1", "1:", "1:0,0,0,0,0,0,0", "1:0,0,0,0,0,0,0,0,0", "1:0,0,0,0,0,0,0,1000",
                           "1:0,0,0,0,0,0,0,-1", "x:0,0,0,0,0,0,0,0", "1:0,0,0,0,0,0,0,0 "}) {
    EXPECT_THROW(parse_stalls(text, "--stalls"), Error) << text;
  }
  for (const char* text : {"", "7", "7:1,2", "7:3,2,0", "7:1,2,3,4", "7:1,2,x", "-7:1,2,3"}) {
    EXPECT_THROW(parse_memory_timing(text, "--memory"), Error) << text;
  }
  EXPECT_EQ(text_of(parse_stalls("18446744073709551615:1,2,3,4,5,6,7,999", "--stalls")),
            "18446744073709551615:1,2,3,4,5,6,7,999");
  EXPECT_EQ(text_of(parse_memory_timing("7:2,400,0", "--memory")), "7:2,400,0");
}

}  // namespace
}  // namespace cuesta
