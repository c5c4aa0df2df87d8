#include <algorithm>
#include <cmath>
#include <utility>

#include "models/search/preprocessing.h"

namespace cuesta {
namespace {

/// The distance from a texel's centre to a whole texel.
struct TexelReach {
  uint64_t operator()(int64_t di, int64_t dj, int, int, bool, bool) const {
    const int64_t x = gap_to_texel(di), y = gap_to_texel(dj);
    return static_cast<uint64_t>(x * x + y * y);
  }
};

/// The eight neighbours of a texel, as bits 3 (dy + 1) + dx + 1.
constexpr int neighbour_bit(int dx, int dy) { return 1 << (3 * (dy + 1) + dx + 1); }

/// The distance from a texel's centre to the nearest edge or corner of a texel over which a ray from there comes down:
/// it lies outward, and the neighbour behind is lower.
class EdgeReach {
 public:
  EdgeReach(const Pyramid& pyramid, AddressMode mode)
      : width_(pyramid.width(0)), height_(pyramid.height(0)), clamp_(mode == AddressMode::kClamp) {
    const int height = height_;
    const auto outside = [mode](int64_t k, int size) {
      return mode == AddressMode::kBorder && (k < 0 || k >= size);
    };
    lower_.reserve(static_cast<size_t>(width_) * static_cast<size_t>(height));
    for (int j = 0; j < height; ++j) {
      for (int i = 0; i < width_; ++i) {
        int lower = 0;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if (outside(i + dx, width_) || outside(j + dy, height) ||
                pyramid.at(0, stored_index(i + dx, width_, mode), stored_index(j + dy, height, mode)) <
                    pyramid.at(0, i, j)) {
              lower |= neighbour_bit(dx, dy);
            }
          }
        }
        lower_.push_back(static_cast<uint16_t>(lower));
      }
    }
  }

  /// Edges that a way toward (dx, dy), each 1 or -1, comes down over.
  bool has_edges(int i, int j, int dx, int dy) const {
    const int ways = neighbour_bit(dx, 0) | neighbour_bit(0, dy) | neighbour_bit(dx, dy);
    // The texel itself counts for its clamped repetition, whatever the direction.
    return (lower_[index(i, j)] & ways) != 0 || (goes_on(i, j) && lower_[index(i, j)] != 0);
  }

  uint64_t operator()(int64_t di, int64_t dj, int i, int j, bool turned_x, bool turned_y) const {
    const int lower = lower_[index(i, j)];
    if (di == 0 && dj == 0) {
      // Clamped, the map goes on beside its outermost texels with their own height and edges: the nearest is at a
      // corner.
      if (!goes_on(i, j)) return kNoFeature;
      const bool beside_x = i == 0 || i == width_ - 1, beside_y = j == 0 || j == height_ - 1;
      const bool edges = (beside_x && (lower & (neighbour_bit(0, -1) | neighbour_bit(0, 1))) != 0) ||
                         (beside_y && (lower & (neighbour_bit(-1, 0) | neighbour_bit(1, 0))) != 0);
      return edges ? 2 : kNoFeature;
    }
    uint64_t nearest = kNoFeature;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const bool outward = dx * di >= 0 && dy * dj >= 0;
        if (!outward || (lower & neighbour_bit(turned_x ? -dx : dx, turned_y ? -dy : dy)) == 0) continue;
        const int64_t x = dx == 0 ? gap_to_texel(di) : 2 * (di < 0 ? -di : di) + 1;
        const int64_t y = dy == 0 ? gap_to_texel(dj) : 2 * (dj < 0 ? -dj : dj) + 1;
        nearest = std::min(nearest, static_cast<uint64_t>(x * x + y * y));
      }
    }
    return nearest;
  }

 private:
  bool goes_on(int i, int j) const {
    return clamp_ && (i == 0 || j == 0 || i == width_ - 1 || j == height_ - 1);
  }
  size_t index(int i, int j) const {
    return static_cast<size_t>(j) * static_cast<size_t>(width_) + static_cast<size_t>(i);
  }

  int width_, height_;
  bool clamp_;
  std::vector<uint16_t> lower_;  ///< bits of neighbours that are lower
};

/// A byte for every texel. `base(i, j)`: the height from which lines rise; `full_rise`: the rise whose line counts in
/// tile sides alone.
template <class Reach, class Base>
Preprocessed flattest_everywhere(const FeaturePyramids& features, AddressMode mode, int repetitions,
                                 const Reach& reach, Base&& base, uint32_t full_rise) {
  const int width = features.toward[0]->width(0), height = features.toward[0]->height(0);
  Preprocessed result;
  result.bytes.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  FeatureSearch<Reach> search(features, mode, repetitions, reach);
  std::vector<FlattestLine> above(static_cast<size_t>(width));  // of the row above
  for (int j = 0; j < height; ++j) {
    FlattestLine line;
    for (int i = 0; i < width; ++i) {
      FlattestLine& place = above[static_cast<size_t>(i)];
      line = place = search.flattest(i, j, base(i, j), line.rise != 0 ? line : place);
      result.bytes.push_back(cone_byte(line, std::max(width, height), full_rise));
    }
  }
  result.texels_read = search.nodes_read();
  return result;
}

/// Max pyramids of the edges, by direction: the heights of texels with edges (or 1, where `height_counts` is not set).
class EdgePyramids {
 public:
  EdgePyramids(const Pyramid& pyramid, const EdgeReach& edges, bool height_counts) {
    for (int k = 0; k < 4; ++k) {
      HeightGrid grid{pyramid.width(0), pyramid.height(0), height_counts ? pyramid.bits() : 1, {}};
      grid.texels.reserve(pyramid_storage(grid.width, grid.height));
      const int dx = (k & 1) != 0 ? -1 : 1, dy = (k & 2) != 0 ? -1 : 1;
      for (int j = 0; j < grid.height; ++j) {
        for (int i = 0; i < grid.width; ++i) {
          const uint16_t value = height_counts ? pyramid.at(0, i, j) : uint16_t{1};
          grid.texels.push_back(edges.has_edges(i, j, dx, dy) ? value : uint16_t{0});
        }
      }
      pyramids_.push_back(build_max_pyramid(std::move(grid)));
    }
  }
  FeaturePyramids features() const {
    return {{&pyramids_[0], &pyramids_[1], &pyramids_[2], &pyramids_[3]}, true};
  }

 private:
  std::vector<Pyramid> pyramids_;
};

/// Reads of making the neighbours' bits.
uint64_t neighbour_reads(const Pyramid& pyramid) {
  return 9 * static_cast<uint64_t>(pyramid.width(0)) * static_cast<uint64_t>(pyramid.height(0));
}

// An edge that lies outward of a texel on the one side may be met first two turned copies further on.
int edge_repetitions(AddressMode mode) { return mode == AddressMode::kMirror ? 2 : 1; }

}  // namespace

uint8_t cone_byte(const FlattestLine& line, int longer_side, uint32_t full_scale) {
  if (line.rise == 0) return kConeScale;
  __extension__ using Wide = unsigned __int128;
  // (b / 255)^4 <= (distance2 / 4 / side^2) * (full / rise)^2
  const auto side = static_cast<uint64_t>(longer_side), full = static_cast<uint64_t>(full_scale);
  const Wide right = static_cast<Wide>(line.distance2) * (full * full) *
                     (uint64_t{kConeScale} * kConeScale * kConeScale * kConeScale);
  const Wide unit = static_cast<Wide>(4 * side * side) * (line.rise * line.rise);
  const auto fits = [&](uint64_t b) { return unit * (b * b * b * b) <= right; };
  const double ratio = std::sqrt(static_cast<double>(line.distance2)) / (2.0 * static_cast<double>(side)) *
                       (static_cast<double>(full) / static_cast<double>(line.rise));
  auto byte = static_cast<uint64_t>(kConeScale * std::sqrt(std::min(1.0, ratio)));
  while (byte < kConeScale && fits(byte + 1)) ++byte;
  while (byte > 0 && !fits(byte)) --byte;
  return static_cast<uint8_t>(byte);
}

Preprocessed make_cone_map(const Pyramid& max_pyramid, AddressMode mode) {
  const FeaturePyramids features{{&max_pyramid, &max_pyramid, &max_pyramid, &max_pyramid}, false};
  return flattest_everywhere(
      features, mode, 1, TexelReach{}, [&](int i, int j) { return max_pyramid.at(0, i, j); },
      max_pyramid.full_scale());
}

Preprocessed make_relaxed_cone_map(const Pyramid& max_pyramid, AddressMode mode) {
  const EdgeReach edges(max_pyramid, mode);
  const EdgePyramids pyramids(max_pyramid, edges, true);
  Preprocessed result = flattest_everywhere(
      pyramids.features(), mode, edge_repetitions(mode), edges,
      [&](int i, int j) { return max_pyramid.at(0, i, j); }, max_pyramid.full_scale());
  result.texels_read += neighbour_reads(max_pyramid);
  return result;
}

Preprocessed make_safety_radii(const Pyramid& max_pyramid, AddressMode mode) {
  const EdgeReach edges(max_pyramid, mode);
  const EdgePyramids pyramids(max_pyramid, edges, false);
  Preprocessed result = flattest_everywhere(
      pyramids.features(), mode, edge_repetitions(mode), edges, [](int, int) { return 0; }, 1);
  result.texels_read += neighbour_reads(max_pyramid);
  return result;
}

}  // namespace cuesta
