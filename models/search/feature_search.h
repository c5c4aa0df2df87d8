#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "models/heightmap/pyramid.h"
#include "models/search/search_map.h"

// What cone maps and safety radii ask of every texel: the flattest line from its centre, at its own height, to a feature
// of the map and of the map's repetitions: the smallest distance / rise.

namespace cuesta {

/// A line's horizontal length, squared and in half texels, and its rise; rise = 0: there is no feature.
struct FlattestLine {
  uint64_t distance2 = 0;
  uint64_t rise = 0;
  int64_t i = 0, j = 0;  ///< the feature's texel, unwrapped

  /// Strictly flatter, exactly: a.distance / a.rise < b.distance / b.rise.
  friend bool operator<(const FlattestLine& a, const FlattestLine& b) {
    __extension__ using Wide = unsigned __int128;
    if (a.rise == 0 || b.rise == 0) return a.rise != 0 && b.rise == 0;
    return static_cast<Wide>(a.distance2) * (b.rise * b.rise) <
           static_cast<Wide>(b.distance2) * (a.rise * a.rise);
  }
};

/// From the centre of texel 0 to the nearest point of texel `d` along one axis, in half texels.
inline int64_t gap_to_texel(int64_t d) { return d == 0 ? 0 : 2 * (d < 0 ? -d : d) - 1; }

/// Branch and bound through a max pyramid over the features' heights: a node is left out when even its highest feature
/// at its nearest point would not be flatter than the best line so far. The answer is the exact minimum over all texels
/// of the map and of `repetitions` copies of it on each side; of equal ones, which is found says nothing of the result.
/// `Reach` gives the squared distance, in half texels, from the centre of a texel to the features of the texel (di, dj)
/// away, stored at (i, j), of a copy that is turned over along x, y: reach(di, dj, i, j, turned_x, turned_y); nothing
/// (kNoFeature) if it has none in that direction.
inline constexpr uint64_t kNoFeature = ~uint64_t{0};

template <class Reach>
class FeatureSearch {
 public:
  FeatureSearch(const Pyramid& features, AddressMode mode, int repetitions, Reach reach)
      : features_(&features), reach_(std::move(reach)) {
    const bool tiles = mode == AddressMode::kWrap || mode == AddressMode::kMirror;
    const int copies = tiles ? repetitions : 0;
    for (int k = -copies; k <= copies; ++k) {
      const bool turned = mode == AddressMode::kMirror && k % 2 != 0;
      tiles_x_.push_back({int64_t{k} * features.width(0), turned});
      tiles_y_.push_back({int64_t{k} * features.height(0), turned});
    }
    // Nearest copies first, so that far ones are left out at their roots.
    const auto nearer = [](const Tile& a, const Tile& b) { return std::abs(a.first) < std::abs(b.first); };
    std::stable_sort(tiles_x_.begin(), tiles_x_.end(), nearer);
    std::stable_sort(tiles_y_.begin(), tiles_y_.end(), nearer);
  }

  /// From the centre of texel (i, j) at height `base`. `guess`: a line found nearby, any; it only saves time.
  FlattestLine flattest(int i, int j, uint32_t base, const FlattestLine& guess) {
    i_ = i;
    j_ = j;
    base_ = base;
    best_ = {};
    bound_ = 0;
    if (guess.rise != 0) ask_texel(guess.i, guess.j);
    const int root = features_->root_level();
    for (const Tile& y : tiles_y_) {
      for (const Tile& x : tiles_x_) {
        const Node node = make_node(x, y, root, 0, 0);
        if (promising(node)) visit(x, y, root, node);
      }
    }
    return best_;
  }

  uint64_t nodes_read() const { return nodes_read_; }

 private:
  struct Tile {
    int64_t first;  ///< its first texel, unwrapped
    bool turned;
  };
  struct Node {
    int i, j;
    uint32_t value;
    uint64_t gap2;
  };

  /// First and last texel of a node in the unwrapped frame, then the gap from `place`.
  static int64_t gap_to_node(const Tile& tile, int index, int level, int size, int64_t place) {
    const int64_t low = int64_t{index} << level;
    const int64_t high = std::min<int64_t>((int64_t{index} + 1) << level, size) - 1;
    const int64_t first = tile.first + (tile.turned ? size - 1 - high : low);
    const int64_t last = tile.first + (tile.turned ? size - 1 - low : high);
    return gap_to_texel(place < first ? first - place : place > last ? place - last : 0);
  }

  Node make_node(const Tile& x, const Tile& y, int level, int i, int j) {
    const int64_t gap_x = gap_to_node(x, i, level, features_->width(0), i_);
    const int64_t gap_y = gap_to_node(y, j, level, features_->height(0), j_);
    ++nodes_read_;
    return {i, j, features_->at(level, i, j), static_cast<uint64_t>(gap_x * gap_x + gap_y * gap_y)};
  }

  /// Can this node hold a flatter line? `bound_` is at least the best line's square, so that no rounding says no.
  bool promising(const Node& node) const {
    if (node.value <= base_) return false;
    if (best_.rise == 0) return true;
    const double rise = node.value - base_;
    return static_cast<double>(node.gap2) <= bound_ * (rise * rise);
  }

  void take(const FlattestLine& line) {
    if (!(line < best_)) return;
    best_ = line;
    const double rise = static_cast<double>(line.rise);
    bound_ = static_cast<double>(line.distance2) / (rise * rise) * (1 + 0x1p-40);
  }

  void ask(const Tile& x, const Tile& y, const Node& node) {
    const int64_t i = x.first + (x.turned ? features_->width(0) - 1 - node.i : node.i);
    const int64_t j = y.first + (y.turned ? features_->height(0) - 1 - node.j : node.j);
    const uint64_t distance2 = reach_(i - i_, j - j_, node.i, node.j, x.turned, y.turned);
    if (distance2 != kNoFeature) take({distance2, node.value - base_, i, j});
  }

  void ask_texel(int64_t i, int64_t j) {
    const auto tile_of = [](const std::vector<Tile>& tiles, int64_t place, int size) -> const Tile* {
      for (const Tile& tile : tiles) {
        if (place >= tile.first && place < tile.first + size) return &tile;
      }
      return nullptr;
    };
    const int width = features_->width(0), height = features_->height(0);
    const Tile *x = tile_of(tiles_x_, i, width), *y = tile_of(tiles_y_, j, height);
    if (x == nullptr || y == nullptr) return;
    const auto stored = [](const Tile& tile, int64_t place, int size) {
      const auto local = static_cast<int>(place - tile.first);
      return tile.turned ? size - 1 - local : local;
    };
    const Node node = make_node(*x, *y, 0, stored(*x, i, width), stored(*y, j, height));
    if (promising(node)) ask(*x, *y, node);
  }

  void visit(const Tile& x, const Tile& y, int level, const Node& node) {
    if (level == 0) return ask(x, y, node);
    std::array<Node, 4> children;
    int count = 0;
    for (int j = 2 * node.j; j < std::min(2 * node.j + 2, features_->height(level - 1)); ++j) {
      for (int i = 2 * node.i; i < std::min(2 * node.i + 2, features_->width(level - 1)); ++i) {
        const Node child = make_node(x, y, level - 1, i, j);
        if (!promising(child)) continue;
        int place = count++;
        for (; place > 0 && child.gap2 < children[static_cast<size_t>(place - 1)].gap2; --place) {
          children[static_cast<size_t>(place)] = children[static_cast<size_t>(place - 1)];
        }
        children[static_cast<size_t>(place)] = child;
      }
    }
    for (int k = 0; k < count; ++k) {
      if (promising(children[static_cast<size_t>(k)]))
        visit(x, y, level - 1, children[static_cast<size_t>(k)]);
    }
  }

  const Pyramid* features_;
  Reach reach_;
  std::vector<Tile> tiles_x_, tiles_y_;
  int64_t i_ = 0, j_ = 0;
  uint32_t base_ = 0;
  FlattestLine best_;
  double bound_ = 0;
  uint64_t nodes_read_ = 0;
};

}  // namespace cuesta
