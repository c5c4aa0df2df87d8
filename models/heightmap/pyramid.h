#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "models/heightmap/height_grid.h"

namespace cuesta {

/// An image pyramid over a height grid. Level 0 holds the leaf texels, level `root_level()` = n the root; n
/// is the smallest integer with 2^n >= max(width, height). Level L has ceil(width / 2^L) x ceil(height / 2^L)
/// nodes and nothing is padded. Node (L, i, j) covers the texels [i << L, (i+1) << L) x [j << L, (j+1) << L)
/// that lie inside the map.
class Pyramid {
 public:
  int root_level() const { return static_cast<int>(levels_.size()) - 1; }
  int width(int level) const { return levels_[level].width; }
  int height(int level) const { return levels_[level].height; }
  int bits() const { return bits_; }
  uint32_t full_scale() const { return (1u << bits_) - 1; }
  int texel_bytes() const { return bits_ <= 8 ? 1 : 2; }
  /// Row-major nodes of a level, `width(level)` apart.
  const uint16_t* level(int level) const { return values_.data() + levels_[level].first; }
  uint16_t at(int level, int i, int j) const {
    return values_[levels_[level].first + static_cast<size_t>(j) * levels_[level].width + i];
  }
  size_t node_count() const { return values_.size() - 1; }
  /// The highest texel of the map, whatever the levels hold.
  uint16_t highest() const { return highest_; }
  /// The lowest level that has values: above 0 in a stopped pyramid.
  int lowest_level() const { return lowest_level_; }

 private:
  struct Level {
    size_t first;
    int width;
    int height;
  };
  std::vector<Level> levels_;
  std::vector<uint16_t> values_;  ///< all levels, and one more: texels may be read two at a time
  int bits_ = 8;
  int lowest_level_ = 0;
  uint16_t highest_ = 0;

  friend Pyramid make_pyramid_levels(HeightGrid&& grid);
  friend Pyramid build_max_pyramid(HeightGrid&& grid);
  friend Pyramid build_mean_pyramid(HeightGrid&& grid);
  friend Pyramid build_stopped_pyramid(const Pyramid& max_pyramid, int stop_level);
  friend void build_maxima(Pyramid& pyramid, int first_level);
  friend Pyramid build_four_corner_pyramid(Pyramid&& max_pyramid, bool wraps);
};

/// Places that all levels of a map take, and one more. A grid whose vector has this capacity becomes a pyramid without
/// a copy.
size_t pyramid_storage(int width, int height);

/// Every node holds the maximum of the texels it covers (Oh, Ki, Lee 2006; Ki & Oh 2007, section 2.1).
/// Throws input_error for an empty or oversized grid, and for a height above full scale.
/// A grid that is given away becomes level 0.
Pyramid build_max_pyramid(HeightGrid&& grid);
Pyramid build_max_pyramid(const HeightGrid& grid);

/// Every node holds the mean of the texels it covers: exact 64-bit sums, rounded half up once per level,
/// hence never above the node of the max pyramid. Throws input_error as build_max_pyramid does.
Pyramid build_mean_pyramid(HeightGrid&& grid);
Pyramid build_mean_pyramid(const HeightGrid& grid);

/// What a traversal that stops at `stop_level` looks at: means at that level, the maxima above it, nothing below. Sizes
/// and `highest` are those of the whole map. `stop_level` is 0 (a copy) to the root's level.
Pyramid build_stopped_pyramid(const Pyramid& max_pyramid, int stop_level);

/// The pyramid of a bilinear surface: patch (i, j) lies between the samples (i, j), (i + 1, j), (i, j + 1) and
/// (i + 1, j + 1). Level 0 holds the samples; node (L, i, j) above it the highest sample of the patches [i << L,
/// (i+1) << L) x [j << L, (j+1) << L). Beyond the last column and row lie the first ones if `wraps`, else the last
/// ones again.
Pyramid build_four_corner_pyramid(Pyramid&& max_pyramid, bool wraps);

}  // namespace cuesta
