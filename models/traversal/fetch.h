#pragma once

#include <algorithm>
#include <cstdint>

#include "models/heightmap/pyramid.h"

// What visits read from memory under FetchRule::kQuad. It stands beside the walk and never changes it. Nodes are named
// as they are fetched: in the map's own frame, after flip and address mode.

namespace cuesta {

/// The 2 x 2 siblings that a ray fetched last.
class KeptQuad {
 public:
  /// Says whether the visit of node (level, i, j) must fetch; if so, the node's siblings are kept from now on.
  bool fetches(int level, int64_t i, int64_t j) {
    const int64_t x = i >> 1, y = j >> 1;
    if (level == level_ && x == x_ && y == y_) return false;
    level_ = level;
    x_ = x;
    y_ = y;
    return true;
  }

 private:
  int level_ = -1;
  int64_t x_ = 0, y_ = 0;
};

/// A node's siblings: those of (i | 1, j | 1) that the level has.
struct Quad {
  int level;
  int i, j;           ///< the first
  int width, height;  ///< 1 or 2

  static Quad of(const Pyramid& pyramid, int level, int i, int j) {
    const int first_i = i & ~1, first_j = j & ~1;
    return {level, first_i, first_j, std::min(2, pyramid.width(level) - first_i),
            std::min(2, pyramid.height(level) - first_j)};
  }
};

/// What a ray, or all of them, read.
struct FetchCounts {
  int64_t fetches = 0;  ///< node visits that read memory
  int64_t texels = 0;   ///< that these brought

  void add(const FetchCounts& other) {
    fetches += other.fetches;
    texels += other.texels;
  }
};

}  // namespace cuesta
