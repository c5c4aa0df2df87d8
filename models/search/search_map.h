#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "models/algorithms/search.h"
#include "models/heightmap/pyramid.h"
#include "models/heightmap/texel_layout.h"
#include "models/rays/machine_ray.h"

namespace cuesta {

/// What making a search's map took, beside the height grid and its max pyramid. The same on every host; time is
/// measured by the caller.
struct PreprocessingCost {
  uint64_t texels_read = 0;      ///< heights and pyramid nodes looked at
  uint64_t records_written = 0;  ///< 0: the height grid itself is searched
  uint64_t bytes = 0;            ///< of the heights read and the records written, without any cache
};

/// The smallest step that a stored cone ratio tells apart: byte b stands for (b / 255)^2 tile sides (the longer side)
/// of reach for the full scale of height. The square root in the texture is Dummer's (field knowledge): small ratios,
/// which are the frequent ones, keep their digits.
inline constexpr int kConeScale = 255;
inline constexpr int kDistanceLayers = 16;  ///< Donnelly 2005

/// What a search reads: one record per texel, row by row, of 1, 2 or 4 bytes so that none lies in two lines (ours): the
/// height, little-endian, in 1 or 2 bytes as the machine
/// stores it, then what the kind adds (all of it one byte, unsigned):
///   cone, relaxed-cone   a ratio, rounded down: (byte / 255)^2 longer tile sides of reach per full scale of height
///   safety-radius        a radius, rounded down: (byte / 255)^2 longer tile sides
///   normal               instead of the height: 3 bytes of unit normal, (n + 1) / 2 * 255, rounded to nearest
///   distance             instead of the height: 16 layers, one after the other, each a byte a texel
/// The printed kinds read the max pyramid's own image, row_major (TexelLayout), and nothing else.
class SearchMap {
 public:
  /// Keeps a reference to `max_pyramid`, which has its leaf level. Throws usage_error as check_map.
  SearchMap(const Search& search, const Pyramid& max_pyramid, AddressMode mode);

  int width() const { return width_; }
  int height() const { return height_; }
  int bits() const { return pyramid_->bits(); }
  AddressMode address_mode() const { return mode_; }
  int record_bytes() const { return record_bytes_; }
  int layers() const { return layers_; }
  int root_level() const { return pyramid_->root_level(); }
  uint64_t size_bytes() const {
    return image_ ? image_->size_bytes() : texels() * static_cast<uint64_t>(record_bytes_ * layers_);
  }
  /// Where the record of texel (i, j) begins; 0 <= i < width, 0 <= j < height.
  uint64_t offset(int i, int j, int layer = 0) const {
    return (static_cast<uint64_t>(layer) * texels() + index(i, j)) * static_cast<uint64_t>(record_bytes_);
  }
  /// Of the printed kinds: where node (level, i, j) of the pyramid lies, and its height.
  uint64_t offset_at(int level, int i, int j) const { return image_->offset(level, i, j); }
  uint16_t node_at(int level, int i, int j) const { return pyramid_->at(level, i, j); }
  const PreprocessingCost& cost() const { return cost_; }

  uint16_t height_at(int i, int j) const { return heights_[index(i, j)]; }
  /// The byte that a cone, relaxed cone or safety radius map adds.
  uint8_t added_at(int i, int j) const { return added_[index(i, j)]; }
  uint8_t distance_at(int i, int j, int layer) const {
    return added_[static_cast<size_t>(layer) * texels() + index(i, j)];
  }
  const uint8_t* normal_at(int i, int j) const { return added_.data() + 3 * index(i, j); }

 private:
  size_t texels() const { return static_cast<size_t>(width_) * static_cast<size_t>(height_); }
  size_t index(int i, int j) const {
    return static_cast<size_t>(j) * static_cast<size_t>(width_) + static_cast<size_t>(i);
  }

  const Pyramid* pyramid_;
  const uint16_t* heights_;
  int width_, height_;
  AddressMode mode_;
  int record_bytes_ = 1;
  int layers_ = 1;
  std::vector<uint8_t> added_;
  std::optional<TexelLayout> image_;
  PreprocessingCost cost_;
};

/// Throws usage_error where a search cannot go: the printed kinds need a square power of two, repeated.
void check_map(const Search& search, int width, int height, AddressMode mode);

/// The texel of the map that stands for `index` (any integer) on an axis of `size` texels. border: as clamp; who asks
/// has made sure that it lies inside.
inline int stored_index(int64_t index, int size, AddressMode mode) {
  if (mode == AddressMode::kBorder || mode == AddressMode::kClamp) {
    return static_cast<int>(index < 0 ? 0 : index >= size ? size - 1 : index);
  }
  const int64_t period = mode == AddressMode::kMirror ? 2 * int64_t{size} : size;
  int64_t place = index % period;
  if (place < 0) place += period;
  return static_cast<int>(place < size ? place : period - 1 - place);
}

}  // namespace cuesta
