#include "models/heightmap/pyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "models/common/error.h"
#include "models/common/random.h"

namespace cuesta {
namespace {

HeightGrid random_grid(int width, int height, int bits, Random& random) {
  HeightGrid grid{width, height, bits, {}};
  grid.texels.resize(static_cast<size_t>(width) * height);
  for (uint16_t& texel : grid.texels)
    texel = static_cast<uint16_t>(random.below(uint64_t{grid.full_scale()} + 1));
  return grid;
}

/// Sizes that real files hold, then random ones.
std::vector<std::pair<int, int>> sizes(Random& random) {
  std::vector<std::pair<int, int>> list = {{1, 1},   {1, 2},   {2, 1},   {1, 37},   {64, 1},
                                           {2, 2},   {3, 3},   {33, 33}, {257, 65}, {32, 32},
                                           {31, 33}, {5, 200}, {129, 1}, {1, 128},  {17, 16}};
  for (int k = 0; k < 40; ++k) {
    list.emplace_back(static_cast<int>(random.between(1, 70)), static_cast<int>(random.between(1, 70)));
  }
  return list;
}

/// Maximum and rounded mean of a node, straight from the definition: over the texels that it covers.
struct NodeTruth {
  uint32_t max = 0;
  uint64_t mean = 0;
};

NodeTruth node_truth(const HeightGrid& grid, int level, int i, int j) {
  NodeTruth truth;
  uint64_t sum = 0, count = 0;
  for (int y = j << level; y < std::min((j + 1) << level, grid.height); ++y) {
    for (int x = i << level; x < std::min((i + 1) << level, grid.width); ++x) {
      truth.max = std::max<uint32_t>(truth.max, grid.at(x, y));
      sum += grid.at(x, y);
      ++count;
    }
  }
  truth.mean = sum / count + (2 * (sum % count) >= count ? 1 : 0);
  return truth;
}

TEST(Pyramid, EveryNodeHoldsTheMaximumAndTheMeanOfTheTexelsItCovers) {
  Random random(1);
  for (auto [width, height] : sizes(random)) {
    int bits = static_cast<int>(random.between(1, 16));
    HeightGrid grid = random_grid(width, height, bits, random);
    Pyramid max = build_max_pyramid(grid);
    Pyramid mean = build_mean_pyramid(grid);
    for (int level = 0; level <= max.root_level(); ++level) {
      for (int j = 0; j < max.height(level); ++j) {
        for (int i = 0; i < max.width(level); ++i) {
          NodeTruth truth = node_truth(grid, level, i, j);
          ASSERT_EQ(max.at(level, i, j), truth.max)
              << width << " x " << height << " node " << level << ", " << i << ", " << j;
          ASSERT_EQ(mean.at(level, i, j), truth.mean)
              << width << " x " << height << " node " << level << ", " << i << ", " << j;
          ASSERT_LE(mean.at(level, i, j), max.at(level, i, j));
        }
      }
    }
  }
}

TEST(Pyramid, LevelsHaveCeilingSizesAndTheRootIsTheFirstOfOneNode) {
  Random random(2);
  for (auto [width, height] : sizes(random)) {
    Pyramid pyramid = build_max_pyramid(random_grid(width, height, 8, random));
    int root = 0;
    while ((1 << root) < std::max(width, height)) ++root;
    ASSERT_EQ(pyramid.root_level(), root) << width << " x " << height;
    size_t nodes = 0;
    for (int level = 0; level <= root; ++level) {
      int side = 1 << level;
      ASSERT_EQ(pyramid.width(level), (width + side - 1) / side);
      ASSERT_EQ(pyramid.height(level), (height + side - 1) / side);
      nodes += static_cast<size_t>(pyramid.width(level)) * pyramid.height(level);
    }
    ASSERT_EQ(pyramid.node_count(), nodes);
    ASSERT_EQ(pyramid.width(root) * pyramid.height(root), 1);
  }
}

TEST(Pyramid, MeanRoundsHalfUpFromTheTexelsAndNotFromTheLevelBelow) {
  // 3 x 1: texels 0, 1, 1. Level 1: (0 + 1) / 2 = 0.5 -> 1, and 1. Root: 2 / 3 -> 1.
  Pyramid small = build_mean_pyramid({3, 1, 8, {0, 1, 1}});
  EXPECT_EQ(small.at(1, 0, 0), 1);
  EXPECT_EQ(small.at(2, 0, 0), 1);
  // 4 x 1: 0, 1, 0, 0. Level 1: 0.5 -> 1 and 0; a mean of those would round to 1, the texels' 1 / 4 to 0.
  Pyramid chained = build_mean_pyramid({4, 1, 8, {0, 1, 0, 0}});
  EXPECT_EQ(chained.at(1, 0, 0), 1);
  EXPECT_EQ(chained.at(2, 0, 0), 0);
}

TEST(Pyramid, AStoppedOneHoldsTheMeansAtItsLevelTheMaximaAboveAndTheWholeMapsHighest) {
  Random random(3);
  for (auto [width, height] : sizes(random)) {
    if (width * height > 20000) continue;
    const Pyramid max = build_max_pyramid(random_grid(width, height, 8, random));
    HeightGrid grid{width, height, 8, {max.level(0), max.level(0) + static_cast<ptrdiff_t>(width) * height}};
    for (int stop = 0; stop <= max.root_level(); ++stop) {
      const Pyramid stopped = build_stopped_pyramid(max, stop);
      EXPECT_EQ(stopped.highest(), node_truth(grid, max.root_level(), 0, 0).max);
      EXPECT_EQ(stopped.lowest_level(), stop);
      EXPECT_EQ(stopped.root_level(), max.root_level());
      for (int level = stop; level <= max.root_level(); ++level) {
        ASSERT_EQ(stopped.width(level), max.width(level));
        for (int j = 0; j < max.height(level); ++j) {
          for (int i = 0; i < max.width(level); ++i) {
            const NodeTruth truth = node_truth(grid, level, i, j);
            ASSERT_EQ(stopped.at(level, i, j), level == stop ? truth.mean : truth.max)
                << width << " x " << height << ", stop " << stop << ", node " << level << ", " << i << ", "
                << j;
          }
        }
      }
    }
  }
}

TEST(Pyramid, AFourCornerOneBoundsThePatchesBetweenTheSamplesOfItsLevelZero) {
  // Node (1, 0, 0) holds patches 0 and 1 of both axes, whose samples are all nine; the others the last patches.
  const HeightGrid grid{3, 3, 8, {9, 2, 3, 4, 5, 6, 1, 8, 7}};
  const Pyramid wraps = build_four_corner_pyramid(build_max_pyramid(grid), true);
  const Pyramid repeats = build_four_corner_pyramid(build_max_pyramid(grid), false);
  for (const Pyramid* pyramid : {&wraps, &repeats}) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 3; ++i) EXPECT_EQ(pyramid->at(0, i, j), grid.at(i, j));
    }
    EXPECT_EQ(pyramid->at(1, 0, 0), 9);
    EXPECT_EQ(pyramid->at(2, 0, 0), 9);
    EXPECT_EQ(pyramid->highest(), 9);
  }
  EXPECT_EQ(wraps.at(1, 0, 1), 9);    // rows 2 and 0
  EXPECT_EQ(repeats.at(1, 0, 1), 8);  // row 2 alone
  EXPECT_EQ(wraps.at(1, 1, 0), 9);    // columns 2 and 0
  EXPECT_EQ(repeats.at(1, 1, 0), 7);  // column 2 alone, rows 0 to 2
  EXPECT_EQ(wraps.at(1, 1, 1), 9);    // the corner: 7, 1, 3, 9
  EXPECT_EQ(repeats.at(1, 1, 1), 7);
}

TEST(Pyramid, MeanOfALargeFlatMapOfFullScaleDoesNotOverflow) {
  HeightGrid grid{4096, 2049, 16, {}};
  grid.texels.assign(size_t{4096} * 2049, 65535);
  Pyramid mean = build_mean_pyramid(grid);
  EXPECT_EQ(mean.at(mean.root_level(), 0, 0), 65535);
}

TEST(Pyramid, RefusesEmptyOversizedRaggedAndTooHighGrids) {
  auto code_of = [](const HeightGrid& grid) {
    try {
      build_max_pyramid(grid);
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::kOk;
  };
  EXPECT_EQ(code_of({0, 0, 8, {}}), ExitCode::kInput);
  EXPECT_EQ(code_of({1, 0, 8, {}}), ExitCode::kInput);
  EXPECT_EQ(code_of({16385, 1, 8, std::vector<uint16_t>(16385)}), ExitCode::kInput);
  EXPECT_EQ(code_of({2, 2, 8, {1, 2, 3}}), ExitCode::kInput);
  EXPECT_EQ(code_of({2, 1, 8, {1, 256}}), ExitCode::kInput);
  EXPECT_EQ(code_of({2, 1, 17, {1, 2}}), ExitCode::kInput);
  EXPECT_EQ(code_of({16384, 1, 8, std::vector<uint16_t>(16384)}), ExitCode::kOk);
}

}  // namespace
}  // namespace cuesta
