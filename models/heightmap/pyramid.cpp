#include "models/heightmap/pyramid.h"

#include <algorithm>
#include <string>
#include <utility>

#include "models/common/error.h"

namespace cuesta {
namespace {

constexpr int kMaxSide = 16384;

void check_grid(const HeightGrid& grid) {
  if (grid.width < 1 || grid.height < 1 || grid.width > kMaxSide || grid.height > kMaxSide) {
    throw input_error("The height grid is " + std::to_string(grid.width) + " x " +
                      std::to_string(grid.height) + " texels; 1 to " + std::to_string(kMaxSide) +
                      " on each side are accepted.");
  }
  if (grid.bits < 1 || grid.bits > 16) {
    throw input_error("The height grid has " + std::to_string(grid.bits) +
                      " bits in a height; 1 to 16 are accepted.");
  }
  size_t expected = static_cast<size_t>(grid.width) * grid.height;
  if (grid.texels.size() != expected) {
    throw input_error("The height grid holds " + std::to_string(grid.texels.size()) + " heights; " +
                      std::to_string(grid.width) + " x " + std::to_string(grid.height) + " needs " +
                      std::to_string(expected) + ".");
  }
}

/// `above[k]` = max of `first` and `second` at 2k and 2k + 1; the last node of an odd width has one column.
void max_row(const uint16_t* first, const uint16_t* second, int width, uint16_t* above) {
  int pairs = width / 2;
  for (int k = 0; k < pairs; ++k) {
    uint16_t upper = std::max(first[2 * k], first[2 * k + 1]);
    uint16_t lower = std::max(second[2 * k], second[2 * k + 1]);
    above[k] = std::max(upper, lower);
  }
  if (width % 2 != 0) above[pairs] = std::max(first[width - 1], second[width - 1]);
}

/// Texels of [index << level, (index + 1) << level) that lie below `size`.
uint64_t covered(int index, int level, int size) {
  int64_t first = static_cast<int64_t>(index) << level;
  int64_t last = std::min<int64_t>(first + (int64_t{1} << level), size);
  return static_cast<uint64_t>(last - first);
}

/// A copy with room for its pyramid.
HeightGrid roomy_copy(const HeightGrid& grid) {
  check_grid(grid);
  HeightGrid copy{grid.width, grid.height, grid.bits, {}};
  copy.texels.reserve(pyramid_storage(grid.width, grid.height));
  copy.texels.assign(grid.texels.begin(), grid.texels.end());
  return copy;
}

}  // namespace

size_t pyramid_storage(int width, int height) {
  size_t nodes = 1;
  while (width > 1 || height > 1) {
    nodes += static_cast<size_t>(width) * static_cast<size_t>(height);
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
  return nodes + 1;
}

/// Sizes of all levels and the leaf texels; the levels above are still zero.
Pyramid make_pyramid_levels(HeightGrid&& grid) {
  check_grid(grid);
  Pyramid pyramid;
  pyramid.bits_ = grid.bits;
  size_t first = 0;
  int width = grid.width, height = grid.height;
  while (true) {
    pyramid.levels_.push_back({first, width, height});
    first += static_cast<size_t>(width) * height;
    if (width == 1 && height == 1) break;
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
  pyramid.values_ = std::move(grid.texels);
  pyramid.values_.resize(first + 1);
  return pyramid;
}

Pyramid build_max_pyramid(const HeightGrid& grid) { return build_max_pyramid(roomy_copy(grid)); }
Pyramid build_mean_pyramid(const HeightGrid& grid) { return build_mean_pyramid(roomy_copy(grid)); }

/// From `first_level` up every node becomes the maximum of its children.
void build_maxima(Pyramid& pyramid, int first_level) {
  for (int level = first_level; level <= pyramid.root_level(); ++level) {
    const Pyramid::Level& below = pyramid.levels_[level - 1];
    const Pyramid::Level& above = pyramid.levels_[level];
    const uint16_t* source = pyramid.values_.data() + below.first;
    uint16_t* target = pyramid.values_.data() + above.first;
    for (int j = 0; j < above.height; ++j) {
      const uint16_t* first = source + static_cast<size_t>(2 * j) * below.width;
      const uint16_t* second = 2 * j + 1 < below.height ? first + below.width : first;
      max_row(first, second, below.width, target + static_cast<size_t>(j) * above.width);
    }
  }
}

Pyramid build_max_pyramid(HeightGrid&& grid) {
  Pyramid pyramid = make_pyramid_levels(std::move(grid));
  build_maxima(pyramid, 1);
  // The root is the highest texel: one comparison finds a height that does not fit the bits.
  pyramid.highest_ = pyramid.at(pyramid.root_level(), 0, 0);
  const uint32_t highest = pyramid.highest_;
  if (highest > pyramid.full_scale()) {
    throw input_error("The height grid holds the height " + std::to_string(highest) + "; " +
                      std::to_string(pyramid.bits()) + " bits hold at most " +
                      std::to_string(pyramid.full_scale()) + ".");
  }
  return pyramid;
}

/// Sums travel up as rows: each level keeps the sums of its current row only, so that the exact 64-bit sums
/// (at most 2^28 texels of 16 bits) cost one row per level instead of four times the map.
Pyramid build_mean_pyramid(HeightGrid&& grid) {
  Pyramid pyramid = make_pyramid_levels(std::move(grid));
  const int width = pyramid.width(0), height = pyramid.height(0);
  const uint16_t* leaves = pyramid.level(0);
  pyramid.highest_ = *std::max_element(leaves, leaves + static_cast<size_t>(width) * height);
  int root = pyramid.root_level();
  std::vector<std::vector<uint64_t>> sums(root + 1);
  for (int level = 1; level <= root; ++level) sums[level].assign(pyramid.width(level), 0);

  for (int texel_row = 0; texel_row < height && root > 0; ++texel_row) {
    const uint16_t* texels = pyramid.level(0) + static_cast<size_t>(texel_row) * width;
    for (int i = 0; i < width; ++i) sums[1][i / 2] += texels[i];
    int row = texel_row;  // the row of `level - 1` that has just become complete
    for (int level = 1; level <= root; ++level) {
      bool complete = row % 2 != 0 || row == pyramid.height(level - 1) - 1;
      if (!complete) break;
      row /= 2;
      const Pyramid::Level& shape = pyramid.levels_[level];
      uint16_t* means = pyramid.values_.data() + shape.first + static_cast<size_t>(row) * shape.width;
      uint64_t rows = covered(row, level, height);
      for (int i = 0; i < shape.width; ++i) {
        uint64_t count = rows * covered(i, level, width);
        means[i] = static_cast<uint16_t>((2 * sums[level][i] + count) / (2 * count));
        if (level < root) sums[level + 1][i / 2] += sums[level][i];
        sums[level][i] = 0;
      }
    }
  }
  return pyramid;
}

Pyramid build_stopped_pyramid(const Pyramid& max_pyramid, int stop_level) {
  Pyramid pyramid;
  pyramid.bits_ = max_pyramid.bits_;
  pyramid.highest_ = max_pyramid.highest_;
  pyramid.lowest_level_ = stop_level;
  pyramid.levels_ = max_pyramid.levels_;
  const size_t dropped = max_pyramid.levels_[stop_level].first;
  for (Pyramid::Level& level : pyramid.levels_)
    level.first = level.first < dropped ? 0 : level.first - dropped;
  pyramid.values_.assign(max_pyramid.values_.begin() + static_cast<ptrdiff_t>(dropped),
                         max_pyramid.values_.end());
  const int width = max_pyramid.width(0), height = max_pyramid.height(0);
  const uint16_t* texels = max_pyramid.level(0);
  std::vector<uint64_t> sums(static_cast<size_t>(pyramid.width(stop_level)));
  for (int j = 0; j < pyramid.height(stop_level); ++j) {
    std::fill(sums.begin(), sums.end(), 0);
    const uint64_t rows = covered(j, stop_level, height);
    for (uint64_t row = 0; row < rows; ++row) {
      const uint16_t* line =
          texels + ((static_cast<size_t>(j) << stop_level) + row) * static_cast<size_t>(width);
      for (int x = 0; x < width; ++x) sums[static_cast<size_t>(x >> stop_level)] += line[x];
    }
    uint16_t* means = pyramid.values_.data() + static_cast<size_t>(j) * sums.size();
    for (size_t i = 0; i < sums.size(); ++i) {
      const uint64_t count = rows * covered(static_cast<int>(i), stop_level, width);
      means[i] = static_cast<uint16_t>((2 * sums[i] + count) / (2 * count));
    }
  }
  return pyramid;
}

Pyramid build_four_corner_pyramid(Pyramid&& max_pyramid, bool wraps) {
  Pyramid pyramid = std::move(max_pyramid);
  if (pyramid.root_level() == 0) return pyramid;
  const int width = pyramid.width(0), height = pyramid.height(0);
  const auto after = [&](int index, int size) { return index < size ? index : wraps ? 0 : size - 1; };
  const Pyramid::Level& above = pyramid.levels_[1];
  std::vector<uint16_t> highest(static_cast<size_t>(width));  // of three rows, column by column
  for (int j = 0; j < above.height; ++j) {
    const uint16_t* rows[3];
    for (int k = 0; k < 3; ++k) {
      rows[k] = pyramid.level(0) +
                static_cast<size_t>(after(std::min(2 * j + k, height), height)) * static_cast<size_t>(width);
    }
    for (int i = 0; i < width; ++i) {
      highest[static_cast<size_t>(i)] = std::max({rows[0][i], rows[1][i], rows[2][i]});
    }
    uint16_t* nodes =
        pyramid.values_.data() + above.first + static_cast<size_t>(j) * static_cast<size_t>(above.width);
    for (int i = 0; i < above.width; ++i) {
      const auto column = [&](int k) {
        return highest[static_cast<size_t>(after(std::min(2 * i + k, width), width))];
      };
      nodes[i] = std::max({column(0), column(1), column(2)});
    }
  }
  build_maxima(pyramid, 2);
  return pyramid;
}

}  // namespace cuesta
