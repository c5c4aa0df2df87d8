#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <vector>

#include "models/heightmap/pyramid.h"
#include "models/search/search_map.h"

// What cone maps and safety radii ask of every texel: the flattest line from its centre, at its own height, to a
// feature of the map and of the map's repetitions: the smallest distance / rise.

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

/// From the centre of texel 0 to the nearest of the texels first .. last along one axis, `place` being 0's; half
/// texels.
inline int64_t gap_to_range(int64_t first, int64_t last, int64_t place) {
  return place < first ? 2 * (first - place) - 1 : place > last ? 2 * (place - last) - 1 : 0;
}

/// The features' heights as max pyramids by the direction in which they are met: [0] toward larger i and j, [1] smaller
/// i, [2] smaller j, [3] both smaller; 0: none. All the same where the direction does not matter.
struct FeaturePyramids {
  std::array<const Pyramid*, 4> toward;
  bool directed;
};

/// No feature in that direction.
inline constexpr uint64_t kNoFeature = ~uint64_t{0};

/// Branch and bound through max pyramids over the features' heights: a node is left out when even its highest feature
/// at its nearest point would not be flatter than the best line so far. The answer is the exact minimum over all texels
/// of the map and of `repetitions` copies of it on each side; of equal ones, which is found says nothing of the result.
/// `Reach` gives the squared distance, in half texels, from the centre of a texel to the features of the texel (di, dj)
/// away, stored at (i, j), of a copy that is turned over along x, y: reach(di, dj, i, j, turned_x, turned_y);
/// kNoFeature if it has none in that direction.
template <class Reach>
class FeatureSearch {
 public:
  FeatureSearch(const FeaturePyramids& features, AddressMode mode, int repetitions, const Reach& reach)
      : features_(features),
        shape_(features.toward[0]),
        reach_(&reach),
        width_(shape_->width(0)),
        height_(shape_->height(0)) {
    const bool tiles = mode == AddressMode::kWrap || mode == AddressMode::kMirror;
    const int copies = tiles ? repetitions : 0;
    for (int k = -copies; k <= copies; ++k) {
      const bool turned = mode == AddressMode::kMirror && k % 2 != 0;
      tiles_x_.push_back({int64_t{k} * width_, width_, turned});
      tiles_y_.push_back({int64_t{k} * height_, height_, turned});
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
    bound_ = std::numeric_limits<double>::infinity();
    if (guess.rise != 0) ask_texel(guess.i, guess.j);
    const int root = shape_->root_level();
    for (const Tile& y : tiles_y_) {
      for (const Tile& x : tiles_x_) {
        const Node node = make_node(x, y, root, 0, 0, span(x, 0, root, i_), span(y, 0, root, j_));
        if (promising(node)) visit(x, y, root, node);
      }
    }
    return best_;
  }

  uint64_t nodes_read() const { return nodes_read_; }

 private:
  /// A copy of the map along one axis.
  struct Tile {
    int64_t first;  ///< its first texel, unwrapped
    int size;
    bool turned;
  };
  /// A node along one axis, seen from the texel that asks.
  struct Span {
    int64_t gap;
    int side;  ///< -1, 1: all of it lies toward smaller, larger places; 0: neither
  };
  struct Node {
    int i, j;
    uint32_t value;
    double gap2;
  };

  Span span(const Tile& tile, int index, int level, int64_t place) const {
    const int64_t low = int64_t{index} << level;
    const int64_t high = std::min<int64_t>((int64_t{index} + 1) << level, tile.size) - 1;
    const int64_t first = tile.first + (tile.turned ? tile.size - 1 - high : low);
    const int64_t last = tile.first + (tile.turned ? tile.size - 1 - low : high);
    return {gap_to_range(first, last, place), place < first ? 1 : place > last ? -1 : 0};
  }

  /// The highest feature of the node that can be met on a way that goes there.
  uint32_t value_of(const Tile& x, const Tile& y, int level, int i, int j, int side_x, int side_y) {
    ++nodes_read_;
    if (!features_.directed) return shape_->at(level, i, j);
    const int stored_x = x.turned ? -side_x : side_x, stored_y = y.turned ? -side_y : side_y;
    uint32_t highest = 0;
    for (int k = 0; k < 4; ++k) {
      const bool away = stored_x == ((k & 1) != 0 ? 1 : -1) || stored_y == ((k & 2) != 0 ? 1 : -1);
      if (!away)
        highest = std::max<uint32_t>(highest, features_.toward[static_cast<size_t>(k)]->at(level, i, j));
    }
    return highest;
  }

  Node make_node(const Tile& x, const Tile& y, int level, int i, int j, const Span& span_x,
                 const Span& span_y) {
    return {i, j, value_of(x, y, level, i, j, span_x.side, span_y.side),
            static_cast<double>(span_x.gap * span_x.gap + span_y.gap * span_y.gap)};
  }

  /// Can this node hold a flatter line? `bound_` is at least the best line's square, so that no rounding says no.
  bool promising(const Node& node) const {
    if (node.value <= base_) return false;
    const double rise = node.value - base_;
    return node.gap2 < bound_ * (rise * rise);
  }

  void take(const FlattestLine& line) {
    if (!(line < best_)) return;
    best_ = line;
    const double rise = static_cast<double>(line.rise);
    bound_ = static_cast<double>(line.distance2) / (rise * rise) * (1 + 0x1p-40);
  }

  void ask(const Tile& x, const Tile& y, const Node& node) {
    const int64_t i = x.first + (x.turned ? width_ - 1 - node.i : node.i);
    const int64_t j = y.first + (y.turned ? height_ - 1 - node.j : node.j);
    const uint64_t distance2 = (*reach_)(i - i_, j - j_, node.i, node.j, x.turned, y.turned);
    if (distance2 != kNoFeature) take({distance2, node.value - base_, i, j});
  }

  void ask_texel(int64_t i, int64_t j) {
    const auto tile_of = [](const std::vector<Tile>& tiles, int64_t place) -> const Tile* {
      for (const Tile& tile : tiles) {
        if (place >= tile.first && place < tile.first + tile.size) return &tile;
      }
      return nullptr;
    };
    const Tile *x = tile_of(tiles_x_, i), *y = tile_of(tiles_y_, j);
    if (x == nullptr || y == nullptr) return;
    const auto stored = [](const Tile& tile, int64_t place) {
      const auto local = static_cast<int>(place - tile.first);
      return tile.turned ? tile.size - 1 - local : local;
    };
    const int k = stored(*x, i), l = stored(*y, j);
    const Node node = make_node(*x, *y, 0, k, l, span(*x, k, 0, i_), span(*y, l, 0, j_));
    if (promising(node)) ask(*x, *y, node);
  }

  void visit(const Tile& x, const Tile& y, int level, const Node& node) {
    if (level == 0) return ask(x, y, node);
    const int below = level - 1, i = 2 * node.i, j = 2 * node.j;
    const int columns = i + 1 < shape_->width(below) ? 2 : 1, rows = j + 1 < shape_->height(below) ? 2 : 1;
    const std::array<Span, 2> spans_x = {span(x, i, below, i_), span(x, i + 1, below, i_)};
    const std::array<Span, 2> spans_y = {span(y, j, below, j_), span(y, j + 1, below, j_)};
    std::array<Node, 4> children;
    size_t count = 0;
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const Node child = make_node(x, y, below, i + column, j + row, spans_x[static_cast<size_t>(column)],
                                     spans_y[static_cast<size_t>(row)]);
        if (!promising(child)) continue;
        size_t place = count++;
        for (; place > 0 && child.gap2 < children[place - 1].gap2; --place)
          children[place] = children[place - 1];
        children[place] = child;
      }
    }
    for (size_t k = 0; k < count; ++k) {
      if (promising(children[k])) visit(x, y, below, children[k]);
    }
  }

  FeaturePyramids features_;
  const Pyramid* shape_;
  const Reach* reach_;
  int width_, height_;
  std::vector<Tile> tiles_x_, tiles_y_;
  int64_t i_ = 0, j_ = 0;
  uint32_t base_ = 0;
  FlattestLine best_;
  double bound_ = 0;
  uint64_t nodes_read_ = 0;
};

}  // namespace cuesta
