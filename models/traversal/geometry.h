#pragma once

#include <bit>
#include <cstdint>

#include "models/rays/machine_ray.h"

// Where a ray is along one axis: which tile, which node. Four forms, chosen by address mode and size: PlainAxis and
// TiledAxis give the same planes, nodes and steps, one for square powers of two, where a tile's border is a node's
// border like any other, one for any size; MirrorAxis, whose every second tile is turned over; ClampAxis without
// tiles. All in the mirrored frame, in which the ray moves toward larger indices; planes are in leaf units.

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
  /// Whether leaf cell `cell` lies in this node.
  bool holds(const AxisMap&, int level, int64_t cell) const { return cell >> level == node; }
  /// Levels needed to hold the leaf cells `a` and `b` in one node.
  static int common_level(const AxisMap& map, int64_t a, int64_t b, bool) {
    const int bits = std::bit_width(static_cast<uint64_t>(a ^ b));
    return bits < map.root_level ? bits : map.root_level;
  }
};

/// Any size: tile `tile`, node `node` in it. A flipped tile has its padding in front: `offset` = 2^n - size. With
/// `mirrors` odd tiles are turned over, so that a tile is flipped if the ray is mirrored on this axis or the tile is
/// odd, but not both.
template <bool mirrors>
struct TiledAxisOf {
  int64_t tile = 0;
  int64_t base = 0;  ///< tile * size
  int64_t node = 0;  ///< at the current level, in the tile, padding included
  int64_t offset = 0;
  bool flip = false;  ///< of this tile

  static int64_t tile_of(const AxisMap& map, int64_t cell) {
    const int64_t quotient = cell / map.size;
    return quotient * map.size > cell ? quotient - 1 : quotient;
  }
  static bool is_odd(int64_t tile) { return mirrors && (tile & 1) != 0; }

  void start(const AxisMap& map, int64_t cell, bool flipped) {
    tile = tile_of(map, cell);
    flip = flipped != is_odd(tile);
    offset = flip ? map.padded - map.size : 0;
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
      if constexpr (mirrors) {
        flip = !flip;
        offset = flip ? map.padded - map.size : 0;
      }
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
    const int64_t index = fetch_index(map, level);
    const bool odd = is_odd(tile);
    return (flip != odd ? -tile : tile) * per_tile + (odd ? per_tile - 1 - index : index);
  }
  bool holds(const AxisMap& map, int level, int64_t cell) const {
    const int64_t local = cell - base;
    return local >= 0 && local < map.size && (local + offset) >> level == node;
  }
  static int common_level(const AxisMap& map, int64_t a, int64_t b, bool flipped) {
    const int64_t tile = tile_of(map, a);
    if (tile != tile_of(map, b)) return map.root_level;
    const int64_t shift = (flipped != is_odd(tile) ? map.padded - map.size : 0) - tile * map.size;
    const int bits = std::bit_width(static_cast<uint64_t>((a + shift) ^ (b + shift)));
    return bits < map.root_level ? bits : map.root_level;
  }
};

using TiledAxis = TiledAxisOf<false>;
using MirrorAxis = TiledAxisOf<true>;

/// Any size, without tiles: the map's edge texels go on for ever, and so do the nodes, unclipped. A mirrored axis has
/// the offset of TiledAxis, so that its nodes are those of the axis as given.
struct ClampAxis {
  int64_t node = 0;  ///< at the current level, unwrapped, offset included
  int64_t offset = 0;
  bool flip = false;

  void start(const AxisMap& map, int64_t cell, bool flipped) {
    flip = flipped;
    offset = flipped ? map.padded - map.size : 0;
    node = cell + offset;
  }
  void go_to_level(int level) { node >>= level; }
  int64_t enter_plane(const AxisMap&, int level) const { return (node << level) - offset; }
  int64_t exit_plane(const AxisMap&, int level) const { return ((node + 1) << level) - offset; }
  int64_t middle_plane(const AxisMap&, int level) const { return (((2 * node + 1) << level) >> 1) - offset; }
  void descend(bool upper) { node = 2 * node + (upper ? 1 : 0); }
  void ascend(bool up) { node >>= static_cast<int>(up); }
  void move(const AxisMap&, int, bool skipped, bool crossed, bool upper) {
    const int64_t base = skipped ? node : node + node;
    node = base + static_cast<int64_t>(skipped ? crossed : upper);
  }
  bool index_is_even() const { return (node & 1) == 0; }
  bool outside(const AxisMap&, int) const { return false; }
  int64_t fetch_index(const AxisMap& map, int level) const {
    const int64_t last = ((map.size + (int64_t{1} << level) - 1) >> level) - 1;
    const int64_t index = real_index(map, level);
    return index < 0 ? 0 : index > last ? last : index;
  }
  int64_t real_index(const AxisMap& map, int level) const {
    return flip ? (map.padded >> level) - 1 - node : node;
  }
  bool holds(const AxisMap&, int level, int64_t cell) const { return (cell + offset) >> level == node; }
  static int common_level(const AxisMap& map, int64_t a, int64_t b, bool flipped) {
    const int64_t shift = flipped ? map.padded - map.size : 0;
    const int bits = std::bit_width(static_cast<uint64_t>((a + shift) ^ (b + shift)));
    return bits < map.root_level ? bits : map.root_level;
  }
};

}  // namespace cuesta
