#include <cstdlib>

#include "models/heightmap/pyramid.h"
#include "tests/traces/heightmaps/image_test.h"

namespace cuesta::test {
namespace {

/// Real height maps lie beside the tree, in ../shared/heightmaps or $CUESTA_HEIGHTMAPS; without them nothing
/// is tested.
class RealFiles : public ::testing::Test {
 protected:
  std::string find(const std::string& name) {
    const char* asked = std::getenv("CUESTA_HEIGHTMAPS");
    std::string file = std::string(asked != nullptr ? asked : "../shared/heightmaps") + "/" + name;
    return std::filesystem::exists(file) ? file : "";
  }
};

#define CUESTA_FIND_OR_SKIP(file, name) \
  std::string file = find(name);        \
  if (file.empty()) GTEST_SKIP() << name << " is not there"

TEST_F(RealFiles, RockbumpHasItsHeightInAlpha) {
  CUESTA_FIND_OR_SKIP(file, "d3dpom_rocks_rgb-normal_a-height.tga");
  LoadedHeights loaded = load_heights(source(file));
  EXPECT_EQ(loaded.statement.channel, "A");
  EXPECT_EQ(loaded.grid.width, 256);
  EXPECT_EQ(loaded.grid.bits, 8);
  Bytes bytes =
      read_bytes(file);  // uncompressed BGRA from byte 18 on, rows going up or down by bit 5 of byte 17
  ASSERT_EQ(bytes[2], 2);
  for (int j = 0; j < 256; ++j) {
    int row = (bytes[17] & 0x20) != 0 ? j : 255 - j;
    for (int i = 0; i < 256; ++i) {
      ASSERT_EQ(loaded.grid.at(i, j), bytes[18u + bytes[0] + 4u * static_cast<unsigned>(row * 256 + i) + 3]);
    }
  }
}

TEST_F(RealFiles, MountStHelensIsGreyInThreeChannels) {
  CUESTA_FIND_OR_SKIP(file, "mt-st-helens_1024_msh1024.bmp");
  LoadedHeights loaded = load_heights(source(file));
  EXPECT_EQ(loaded.statement.channel, "R");
  EXPECT_EQ(build_max_pyramid(loaded.grid).root_level(), 10);
  Bytes bytes = read_bytes(file);  // rows go up from byte 54
  for (int k = 0; k < 1024; ++k) {
    ASSERT_EQ(loaded.grid.at(k, 1023), bytes[54u + 3u * static_cast<unsigned>(k)]);
  }
}

TEST_F(RealFiles, GeoTiffOfMetresIsStretchedToSixteenBits) {
  CUESTA_FIND_OR_SKIP(file, "dem_landscape.tif");
  LoadedHeights loaded = load_heights(source(file));
  EXPECT_EQ(loaded.statement.type, "float");
  EXPECT_EQ(loaded.grid.width, 200);
  EXPECT_EQ(loaded.grid.height, 125);
  EXPECT_NEAR(loaded.statement.minimum, -4.7, 0.05);
  EXPECT_NEAR(loaded.statement.maximum, 921, 0.5);
}

TEST_F(RealFiles, PaletteOfGreysIsReadAsItsGreys) {
  CUESTA_FIND_OR_SKIP(file, "polyhaven_gray_rocks_disp_2k.png");
  LoadedHeights loaded = load_heights(source(file));
  EXPECT_EQ(loaded.grid.width, 2048);
  EXPECT_EQ(loaded.grid.bits, 8);
  ASSERT_EQ(loaded.statement.notes.size(), 1u);
  EXPECT_NE(loaded.statement.notes[0].find("palette"), std::string::npos);
}

}  // namespace
}  // namespace cuesta::test
