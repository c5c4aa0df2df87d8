#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "sim/cli/options.h"
#include "sim/cli/verbs.h"
#include "tests/traces/support.h"
#include "traces/front_end.h"
#include "traces/ray_files.h"
#include "traces/scene_library.h"

namespace cuesta {
namespace {

/// Runs a verb as the command line does; what it printed.
std::string run(std::unique_ptr<Command> command, const std::vector<std::string>& arguments) {
  CLI::App app;
  Options options(app);
  command->declare(options);
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());  // as CLI11 wants a vector
  app.parse(reversed);
  Session session;
  session.quiet = true;
  ::testing::internal::CaptureStdout();
  try {
    EXPECT_EQ(command->run(session), ExitCode::kOk);
  } catch (...) {
    ::testing::internal::GetCapturedStdout();
    throw;
  }
  return ::testing::internal::GetCapturedStdout();
}

const char kScene[] =
    "[heightmap]\ngenerate = { kind = \"rocks\", size = 32 }\n[camera]\nangle_degrees = 50\n"
    "[image]\nwidth = 30\nheight = 20\n";

class RaysCommand : public ::testing::Test {
 protected:
  void SetUp() override { write_bytes(path("a.toml"), kScene); }
  std::string path(const std::string& name) const { return folder_.file(name); }
  ScratchFolder folder_;
};

TEST_F(RaysCommand, TraceWritesTheRaysOfTheScene) {
  run(make_trace_command(), {path("a.toml"), "-o", path("a.rays")});
  const RayTrace expected = make_rays(load_scene(path("a.toml")), 32, 32);
  EXPECT_GT(expected.rays.size(), 100u);
  EXPECT_TRUE(identical(read_ray_file(path("a.rays")), expected));
  run(make_trace_command(), {path("a.toml"), "-o", path("b.csv"), "--crop", "12,9,5,4"});
  EXPECT_TRUE(identical(read_ray_file(path("b.csv")),
                        make_rays(load_scene(path("a.toml")), 32, 32, Crop{12, 9, 5, 4})));
}

TEST_F(RaysCommand, ConversionToTextAndBackGivesTheSameBytes) {
  run(make_trace_command(), {path("a.toml"), "-o", path("a.rays")});
  run(make_rays_convert_command(), {path("a.rays"), path("a.csv")});
  run(make_rays_convert_command(), {path("a.csv"), path("b.rays")});
  EXPECT_EQ(bytes_of(path("a.rays")), bytes_of(path("b.rays")));
}

TEST_F(RaysCommand, TheFileToWriteIsNamedEitherWayAndItsEndingSaysHow) {
  run(make_trace_command(), {path("a.toml"), "-o", path("a.rays")});
  run(make_rays_convert_command(), {path("a.rays"), "-o", path("a.csv")});
  EXPECT_EQ(bytes_of(path("a.csv")).substr(0, 13), "# cuesta rays");
  for (const char* name : {"b.cvs", "b", "rays", "csv"}) {
    const std::string refused = sentence_of(ExitCode::kUsage, [&] {
      run(make_rays_convert_command(), {path("a.rays"), path(name)});
    });
    EXPECT_NE(refused.find("accepted are names that end in .rays (binary) or .csv (text)."),
              std::string::npos);
    sentence_of(ExitCode::kUsage, [&] { run(make_trace_command(), {path("a.toml"), "-o", path(name)}); });
    EXPECT_FALSE(std::filesystem::exists(path(name)));
  }
}

TEST_F(RaysCommand, NothingIsReplacedUnasked) {
  write_bytes(path("a.rays"), "mine");
  sentence_of(ExitCode::kUsage, [&] { run(make_trace_command(), {path("a.toml"), "-o", path("a.rays")}); });
  EXPECT_EQ(bytes_of(path("a.rays")), "mine");
  run(make_trace_command(), {path("a.toml"), "-o", path("a.rays"), "--force"});
  write_bytes(path("a.csv"), "mine");
  sentence_of(ExitCode::kUsage, [&] { run(make_rays_convert_command(), {path("a.rays"), path("a.csv")}); });
  EXPECT_EQ(bytes_of(path("a.csv")), "mine");
  sentence_of(ExitCode::kUsage, [&] { run(make_trace_command(), {path("a.toml"), "-o", path("")}); });
}

TEST_F(RaysCommand, InfoCountsAndCheckRefusesDamage) {
  write_ray_file(path("a.rays"), any_trace(3, 50));
  for (const char* name : {"a.rays", "a.csv"}) {
    if (std::string(name) == "a.csv") run(make_rays_convert_command(), {path("a.rays"), path("a.csv")});
    const std::string text = run(make_rays_info_command(), {path(name)});
    EXPECT_NE(text.find("rays          50\n"), std::string::npos) << text;
    EXPECT_NE(text.find("300 x 7 pixels"), std::string::npos) << text;
  }
  std::string bytes = bytes_of(path("a.rays"));
  bytes[bytes.size() - 9] = static_cast<char>(bytes[bytes.size() - 9] ^ 4);
  write_bytes(path("a.rays"), bytes);
  const std::string sentence = sentence_of(ExitCode::kInput, [&] {
    run(make_rays_check_command(), {path("a.csv"), path("a.rays")});
  });
  EXPECT_NE(sentence.find("chunk 0"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace cuesta
