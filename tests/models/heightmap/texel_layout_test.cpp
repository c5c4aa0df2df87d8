#include "models/heightmap/texel_layout.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "models/common/error.h"
#include "models/common/random.h"

namespace cuesta {
namespace {

HeightGrid numbered_grid(int width, int height, int bits) {
  HeightGrid grid{width, height, bits, {}};
  for (int k = 0; k < width * height; ++k) grid.texels.push_back(static_cast<uint16_t>(k + 1));
  return grid;
}

std::vector<int> bytes_of(const std::vector<std::byte>& image) {
  std::vector<int> bytes;
  for (std::byte byte : image) bytes.push_back(static_cast<int>(byte));
  return bytes;
}

TEST(TexelLayout, IsInjectiveAlignedAndInsideTheImageForAnySize) {
  Random random(7);
  std::vector<std::pair<int, int>> sizes = {{1, 1},   {1, 9},   {9, 1},    {2, 1},
                                            {64, 64}, {65, 65}, {128, 32}, {3, 100}};
  for (int k = 0; k < 25; ++k) {
    sizes.emplace_back(static_cast<int>(random.between(1, 90)), static_cast<int>(random.between(1, 90)));
  }
  for (auto [width, height] : sizes) {
    for (const TexelLayoutEntry& entry : texel_layouts()) {
      for (int texel_bytes : {1, 2, 4}) {
        TexelLayout layout(entry.kind, width, height, texel_bytes);
        std::set<uint64_t> seen;
        int level = 0;
        for (int w = width, h = height;; w = (w + 1) / 2, h = (h + 1) / 2, ++level) {
          for (int j = 0; j < h; ++j) {
            for (int i = 0; i < w; ++i) {
              uint64_t offset = layout.offset(level, i, j);
              ASSERT_EQ(offset % static_cast<uint64_t>(texel_bytes), 0u);
              ASSERT_LE(offset + static_cast<uint64_t>(texel_bytes), layout.size_bytes());
              ASSERT_TRUE(seen.insert(offset).second) << entry.name << " " << width << " x " << height
                                                      << " node " << level << ", " << i << ", " << j;
            }
          }
          if (entry.kind != TexelLayoutKind::kMipAtlas && entry.kind != TexelLayoutKind::kKi2007Slices) {
            ASSERT_EQ(layout.offset(level, 0, 0) % 64, 0u);
          }
          if (w == 1 && h == 1) break;
        }
        ASSERT_EQ(layout.root_level(), level);
      }
    }
  }
}

TEST(TexelLayout, RowMajorBytesAreThoseWorkedByHand) {
  // 3 x 2 texels 1..6 of two bytes; level 1 is 2 x 1 at byte 64, level 2 one texel at byte 128.
  Pyramid pyramid = build_max_pyramid(numbered_grid(3, 2, 9));
  TexelLayout layout(TexelLayoutKind::kRowMajor, pyramid);
  std::vector<int> expected(130, 0);
  for (int k = 0; k < 6; ++k) expected[static_cast<size_t>(2 * k)] = k + 1;
  expected[64] = 5;
  expected[66] = 6;
  expected[128] = 6;
  EXPECT_EQ(bytes_of(layout.write_image(pyramid)), expected);
}

TEST(TexelLayout, MortonBytesOfAFourByFourMapAreThoseWorkedByHand) {
  Pyramid pyramid = build_max_pyramid(numbered_grid(4, 4, 8));
  TexelLayout layout(TexelLayoutKind::kMorton, pyramid);
  std::vector<int> image = bytes_of(layout.write_image(pyramid));
  ASSERT_EQ(image.size(), 129u);
  // Rows 1 2 3 4 / 5 6 7 8 / 9 10 11 12 / 13 14 15 16, read in the shape of a Z, squares of two first.
  std::vector<int> order = {1, 2, 5, 6, 3, 4, 7, 8, 9, 10, 13, 14, 11, 12, 15, 16};
  EXPECT_EQ(std::vector<int>(image.begin(), image.begin() + 16), order);
  EXPECT_EQ(std::vector<int>(image.begin() + 64, image.begin() + 68), (std::vector<int>{6, 8, 14, 16}));
  EXPECT_EQ(image[128], 16);
}

TEST(TexelLayout, MortonOfAWideMapIsARowOfSquares) {
  TexelLayout layout(TexelLayoutKind::kMorton, 8, 2, 1);
  EXPECT_EQ(layout.offset(0, 1, 1), 3u);
  EXPECT_EQ(layout.offset(0, 2, 0), 4u);
  EXPECT_EQ(layout.offset(0, 7, 1), 15u);
  TexelLayout tall(TexelLayoutKind::kMorton, 2, 8, 1);
  EXPECT_EQ(tall.offset(0, 0, 2), 4u);
  EXPECT_EQ(tall.offset(0, 1, 7), 15u);
  TexelLayout row(TexelLayoutKind::kMorton, 300, 1, 2);
  EXPECT_EQ(row.offset(0, 299, 0), 598u);
}

TEST(TexelLayout, MipAtlasBytesOfAFourByFourMapAreThoseWorkedByHand) {
  Pyramid pyramid = build_max_pyramid(numbered_grid(4, 4, 8));
  TexelLayout layout(TexelLayoutKind::kMipAtlas, pyramid);
  std::vector<int> expected = {1,  2,  3,  4,  6,  8,   //
                               5,  6,  7,  8,  14, 16,  //
                               9,  10, 11, 12, 16, 0,   //
                               13, 14, 15, 16, 0,  0};
  EXPECT_EQ(bytes_of(layout.write_image(pyramid)), expected);
}

TEST(TexelLayout, BlockBytesOfAMapWhoseSidesAreNoMultiplesOfFourAreThoseWorkedByHand) {
  // 5 x 6 texels 1..30: two blocks across, two down; level 1 is 3 x 3 in one block, level 2 2 x 2.
  Pyramid pyramid = build_max_pyramid(numbered_grid(5, 6, 8));
  TexelLayout layout(TexelLayoutKind::kBlocks4x4, pyramid);
  std::vector<int> image = bytes_of(layout.write_image(pyramid));
  std::vector<int> level_0 = {1,  2,  3,  4,  6,  7,  8,  9,  11, 12, 13, 14, 16, 17, 18, 19,  //
                              5,  0,  0,  0,  10, 0,  0,  0,  15, 0,  0,  0,  20, 0,  0,  0,   //
                              21, 22, 23, 24, 26, 27, 28, 29, 0,  0,  0,  0,  0,  0,  0,  0,   //
                              25, 0,  0,  0,  30};
  EXPECT_EQ(std::vector<int>(image.begin(), image.begin() + 53), level_0);
  EXPECT_EQ(std::vector<int>(image.begin() + 64, image.begin() + 75),
            (std::vector<int>{7, 9, 10, 0, 17, 19, 20, 0, 27, 29, 30}));
  EXPECT_EQ(std::vector<int>(image.begin() + 128, image.begin() + 134),
            (std::vector<int>{19, 20, 0, 0, 29, 30}));
  ASSERT_EQ(image.size(), 193u);
  EXPECT_EQ(image[192], 30);
}

TEST(TexelLayout, SixteenTexelsOfABlockLieInOneLineOfTheirSize) {
  for (int texel_bytes : {1, 2, 4}) {
    TexelLayout layout(TexelLayoutKind::kBlocks4x4, 40, 36, texel_bytes);
    const uint64_t block = 16 * static_cast<uint64_t>(texel_bytes);
    for (int j = 0; j < 36; ++j) {
      for (int i = 0; i < 40; ++i) {
        ASSERT_EQ(layout.offset(0, i, j) / block, static_cast<uint64_t>(j / 4 * 10 + i / 4));
      }
    }
  }
}

TEST(TexelLayout, KiAndOhsSlicesOfAFourByFourMapAreThoseWorkedByHand) {
  Pyramid pyramid = build_max_pyramid(numbered_grid(4, 4, 8));
  TexelLayout layout(TexelLayoutKind::kKi2007Slices, pyramid);
  std::vector<int> expected = {1,  2,  3,  4,   //
                               5,  6,  7,  8,   //
                               9,  10, 11, 12,  //
                               13, 14, 15, 16,  //
                               6,  8,  16, 0,   //
                               14, 16, 0,  0,   //
                               0,  0,  0,  0,   //
                               0,  0,  0,  0};
  EXPECT_EQ(bytes_of(layout.write_image(pyramid)), expected);
  for (int side = 1; side <= 16384; side *= 2) {
    EXPECT_EQ(TexelLayout(TexelLayoutKind::kKi2007Slices, side, side, 1).size_bytes(),
              2 * static_cast<uint64_t>(side) * static_cast<uint64_t>(side));
  }
}

TEST(TexelLayout, SquarePowersOfTwoTakeFourThirdsOrOneAndAHalfOfLevelZero) {
  // 256 x 256: 65536 + 16384 + ... + 64 (8 x 8) full lines, then 16, 4 and 1 texel in a line each.
  uint64_t levels = 65536 + 16384 + 4096 + 1024 + 256 + 64 + 64 + 64 + 1;
  EXPECT_EQ(TexelLayout(TexelLayoutKind::kRowMajor, 256, 256, 1).size_bytes(), levels);
  EXPECT_EQ(TexelLayout(TexelLayoutKind::kMorton, 256, 256, 1).size_bytes(), levels);
  EXPECT_EQ(TexelLayout(TexelLayoutKind::kMipAtlas, 256, 256, 1).size_bytes(), 65536u * 3 / 2);
}

TEST(TexelLayout, OffsetsOfTheLargestMapAreThoseWorkedByHand) {
  TexelLayout layout(TexelLayoutKind::kMorton, 16384, 16384, 4);
  EXPECT_EQ(layout.offset(0, 16383, 16383), (uint64_t{1} << 30) - 4);
  EXPECT_EQ(layout.offset(1, 0, 0), uint64_t{1} << 30);
  EXPECT_EQ(layout.offset(0, 8192, 0), uint64_t{1} << 28);
  EXPECT_EQ(layout.offset(0, 0, 8192), uint64_t{1} << 29);
}

TEST(TexelLayout, RefusesSizesAndTexelBytesThatItCannotHold) {
  EXPECT_THROW(TexelLayout(TexelLayoutKind::kMorton, 0, 1, 1), Error);
  EXPECT_THROW(TexelLayout(TexelLayoutKind::kMorton, 1, 16385, 1), Error);
  EXPECT_THROW(TexelLayout(TexelLayoutKind::kMorton, 4, 4, 3), Error);
  Pyramid pyramid = build_max_pyramid(numbered_grid(4, 4, 8));
  EXPECT_THROW(TexelLayout(TexelLayoutKind::kRowMajor, 5, 4, 1).write_image(pyramid), Error);
}

}  // namespace
}  // namespace cuesta
