#include "sim/cli/heightmap_command.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "models/common/error.h"
#include "models/heightmap/generator.h"

namespace cuesta {
namespace {

class HeightmapCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("cuesta_heightmap_command_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(HeightmapCommand, WhatIsMadeReadsBackAsWhatWasGenerated) {
  for (const MapKind& kind : map_kinds()) {
    HeightmapMakeOptions options{std::string(kind.name), path("m.png"), 48, 20, 11, 6, true};
    heightmap_make(options);
    HeightSource source;
    source.path = options.output;
    source.bits = 11;
    EXPECT_EQ(load_heights(source).grid.texels, generate(kind.name, 48, 20, 11, 6).texels) << kind.name;
  }
}

TEST_F(HeightmapCommand, InfoNamesChannelRangeLevelsAndBytes) {
  heightmap_make({"flat", path("f.png"), 6, 3, 8, 1, false});
  HeightSource source;
  source.path = path("f.png");
  std::string text = heightmap_info(source);
  for (const char* part : {"png", "6 x 3 texels", "Y (the only channel)", "uint8, 128 to 128",
                           "128 to 128 of 255, 1 different", "4 levels, 27 nodes of 1 byte", "z = 0.5020"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  }
}

TEST_F(HeightmapCommand, AFileThatIsThereIsReplacedOnlyWithForce) {
  HeightmapMakeOptions options{"flat", path("f.png"), 2, 2, 8, 1, false};
  heightmap_make(options);
  EXPECT_THROW(heightmap_make(options), Error);
  options.force = true;
  heightmap_make(options);
}

TEST_F(HeightmapCommand, SizesAndRangesAreReadWholeOrRefused) {
  int width = 0, height = 0;
  parse_map_size("640x480", width, height);
  EXPECT_EQ(width, 640);
  EXPECT_EQ(height, 480);
  parse_map_size("16384", width, height);
  EXPECT_EQ(width, 16384);
  EXPECT_EQ(height, 16384);
  for (const char* wrong :
       {"", "x", "0", "-4", "4x", "x4", "4x4x4", "16385", "4 x 4", "1e3", "99999999999"}) {
    EXPECT_THROW(parse_map_size(wrong, width, height), Error) << wrong;
  }
  double low = 0, high = 0;
  parse_range("-4.5,900", low, high);
  EXPECT_EQ(low, -4.5);
  EXPECT_EQ(high, 900);
  for (const char* wrong : {"", "1", "1,", ",1", "1,2,3", "a,b", "1;2"}) {
    EXPECT_THROW(parse_range(wrong, low, high), Error) << wrong;
  }
}

}  // namespace
}  // namespace cuesta
