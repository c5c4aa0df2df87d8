#pragma once

#include <bit>
#include <cstdint>

#include "models/traversal/machine_ray.h"

// Where a ray is along one axis: which tile, which node. Two forms that give the same planes, nodes and steps:
// one for any size, one for square powers of two, where a tile's border is a node's border like any other.
// All in the mirrored frame, in which the ray moves toward larger indices; planes are in leaf units.

namespace cuesta {

/// What does not change along a ray, per axis.
struct AxisMap {
  int64_t size;    ///< w or h, texels
  int64_t padded;  ///< 2^n
  int root_level;  ///< n
};

/// Square powers of two: the node's index runs on over tiles.
struct PlainAxis {
  int64_t node = 0;  ///< at the current level, unwrapped
  int64_t flip = 0;  ///< all ones when the axis is mirrored

  void start(const AxisMap&, int64_t cell, bool flipped) {
    node = cell;
    flip = flipped ? -1 : 0;
  }
  void go_to_level(int level) { node >>= level; }
  int64_t enter_plane(const AxisMap&, int level) const { return node << level; }
  int64_t exit_plane(const AxisMap&, int level) const { return (node + 1) << level; }
  int64_t middle_plane(const AxisMap&, int level) const { return ((2 * node + 1) << level) >> 1; }
  void descend(bool upper) { node = 2 * node + (upper ? 1 : 0); }
  void ascend(bool up) { node >>= static_cast<int>(up); }
  /// Skipped: crosses to the next node, if `crossed`. Else goes down, to the upper child if `upper`.
  void move(const AxisMap&, int, bool skipped, bool crossed, bool upper) {
    const int64_t base = skipped ? node : node + node;
    node = base + static_cast<int64_t>(skipped ? crossed : upper);
  }
  bool index_is_even() const { return (node & 1) == 0; }
  bool outside(const AxisMap& map, int level) const { return (node << level) >= map.size; }
  int64_t fetch_index(const AxisMap& map, int level) const {
    return (node ^ flip) & ((map.padded >> level) - 1);
  }
  /// In the map's own frame, unwrapped.
  int64_t real_index(const AxisMap& map, int level) const {
    return flip ? (map.padded >> level) - 1 - node : node;
  }
  /// Levels needed to hold the leaf cells `a` and `b` in one node.
  static int common_level(const AxisMap& map, int64_t a, int64_t b, bool) {
    const int bits = std::bit_width(static_cast<uint64_t>(a ^ b));
    return bits < map.root_level ? bits : map.root_level;
  }
};

/// Any size: tile `tile`, node `node` in it. A mirrored axis has its padding in front: `offset` = 2^n - size.
struct TiledAxis {
  int64_t tile = 0;
  int64_t base = 0;  ///< tile * size
  int64_t node = 0;  ///< at the current level, in the tile, padding included
  int64_t offset = 0;
  bool flip = false;

  static int64_t tile_of(const AxisMap& map, int64_t cell) {
    const int64_t quotient = cell / map.size;
    return quotient * map.size > cell ? quotient - 1 : quotient;
  }
  void start(const AxisMap& map, int64_t cell, bool flipped) {
    flip = flipped;
    offset = flipped ? map.padded - map.size : 0;
    tile = tile_of(map, cell);
    base = tile * map.size;
    node = cell - base + offset;
  }
  void go_to_level(int level) { node >>= level; }
  int64_t enter_plane(const AxisMap&, int level) const {
    const int64_t inside = (node << level) - offset;
    return base + (inside > 0 ? inside : 0);
  }
  int64_t exit_plane(const AxisMap& map, int level) const {
    const int64_t inside = ((node + 1) << level) - offset;
    return base + (inside < map.size ? inside : map.size);
  }
  int64_t middle_plane(const AxisMap&, int level) const {
    return base + (((2 * node + 1) << level) >> 1) - offset;
  }
  void descend(bool upper) { node = 2 * node + (upper ? 1 : 0); }
  void ascend(bool up) { node >>= static_cast<int>(up); }
  /// Skipped: crosses to the next node or tile, if `crossed`. Else goes down, to the upper child if `upper`.
  void move(const AxisMap& map, int level, bool skipped, bool crossed, bool upper) {
    if (!skipped) return descend(upper);
    if (!crossed) return;
    if (((node + 1) << level) - offset < map.size) {
      ++node;
    } else {
      ++tile;
      base += map.size;
      node = offset >> level;
    }
  }
  bool index_is_even() const { return (node & 1) == 0; }
  bool outside(const AxisMap&, int) const { return tile != 0; }
  int64_t fetch_index(const AxisMap& map, int level) const {
    return flip ? (map.padded >> level) - 1 - node : node;
  }
  int64_t real_index(const AxisMap& map, int level) const {
    const int64_t per_tile = (map.size + (int64_t{1} << level) - 1) >> level;
    return (flip ? -tile : tile) * per_tile + fetch_index(map, level);
  }
  static int common_level(const AxisMap& map, int64_t a, int64_t b, bool flipped) {
    const int64_t tile = tile_of(map, a);
    if (tile != tile_of(map, b)) return map.root_level;
    const int64_t shift = (flipped ? map.padded - map.size : 0) - tile * map.size;
    const int bits = std::bit_width(static_cast<uint64_t>((a + shift) ^ (b + shift)));
    return bits < map.root_level ? bits : map.root_level;
  }
};

}  // namespace cuesta
