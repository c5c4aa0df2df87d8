#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "models/heightmap/pyramid.h"

namespace cuesta {

enum class TexelLayoutKind : uint8_t { kRowMajor, kMorton, kMipAtlas, kBlocks4x4, kKi2007Slices };

/// A layout's name in configuration files, and what it means in one sentence.
struct TexelLayoutEntry {
  std::string_view name;
  TexelLayoutKind kind;
  std::string_view meaning;
};

/// All layouts, in the order of TexelLayoutKind: `row_major` first.
inline constexpr std::array<TexelLayoutEntry, 5> kTexelLayouts = {{
    {"row_major", TexelLayoutKind::kRowMajor, "Level after level, each row by row, levels 64-byte aligned."},
    {"morton", TexelLayoutKind::kMorton, "Level after level, each in Morton order, levels 64-byte aligned."},
    {"mip_atlas", TexelLayoutKind::kMipAtlas,
     "One row-major image of 1.5 times the width: level 0 at the left, the others below each other at its "
     "right."},
    {"blocks_4x4", TexelLayoutKind::kBlocks4x4,
     "Level after level, each in rows of blocks of 4 x 4 texels, levels 64-byte aligned."},
    {"ki2007_slices", TexelLayoutKind::kKi2007Slices,
     "A 3-D texture n x n x 2 (Ki & Oh 2007): slice 0 level 0, slice 1 the others as a mip atlas."},
}};
inline std::span<const TexelLayoutEntry> texel_layouts() { return kTexelLayouts; }
std::string_view name_of(TexelLayoutKind kind);

/// Where each pyramid texel lies in the machine's memory: the one byte image used by address counts, cache
/// and bus models alike. Level 0 comes first; gaps are zero bytes.
///
/// - row_major: level after level, each row by row without padding; a level begins on a multiple of 64 bytes.
///   At most 63 bytes a level are lost.
/// - morton: level after level, as above, each in Morton (Z) order over the rectangle 2^a x 2^b that holds
/// it:
///   the lower min(a, b) bits of j and i interleave, i in the even places, and the longer axis's other bits
///   stand above them. Sides that are powers of two lose nothing; other sizes leave holes: a level takes less
///   than 4 times its texels, the most just above a power of two (2^k + 1 square: 3 times).
///   The image ends a level at its last texel, not at the end of the rectangle.
/// - mip_atlas: one row-major image, ceil(1.5 x width) texels across: level 0 at the left, levels 1, 2 ...
///   below each other at its right. Its rows are max(height, the sum of the upper levels' heights). Levels
///   begin where they fall, not on multiples of 64 bytes. A square power of two takes 1.5 times level 0, of
///   which 1/9 is never read.
/// - blocks_4x4: level after level, as row_major, each in rows of 4 x 4 blocks: a block's 16 texels follow
///   each other row by row. A level whose sides are not multiples of 4 has full blocks at its right and lower
///   edge, with holes; it ends at its last texel. A block of bytes is 16 bytes, of 16-bit texels 32.
/// - ki2007_slices: a 3-D texture n x n x 2 after Ki & Oh 2007, stored slice after slice, each row by row.
///   Slice 0 is level 0; slice 1 holds level 1 at the left and levels 2, 3 ... below each other at its right.
///   Printed are the two slices and what is in them; the places inside slice 1 are reconstructed. Sizes that
///   are no square powers of two are ours: a slice is max(width, level 1's + level 2's width) across and has
///   max(height, the heights of levels 2, 3 ... summed) rows. A square power of two takes 2 times level 0, of
///   which 1/3 is never read.
class TexelLayout {
 public:
  static constexpr uint64_t kLevelAlignment = 64;  ///< bytes

  /// `width` x `height` texels at level 0, 1 to 16384 each; `texel_bytes` 1, 2 or 4.
  /// Throws usage_error for anything else.
  TexelLayout(TexelLayoutKind kind, int width, int height, int texel_bytes);
  TexelLayout(TexelLayoutKind kind, const Pyramid& pyramid)
      : TexelLayout(kind, pyramid.width(0), pyramid.height(0), pyramid.texel_bytes()) {}

  /// Byte offset of node (level, i, j) from the image's base, a multiple of texel_bytes. No two nodes share
  /// one. The node must exist: this is the simulator's inner loop and checks nothing.
  uint64_t offset(int level, int i, int j) const {
    const Level& shape = levels_[level];
    uint32_t x = static_cast<uint32_t>(i), y = static_cast<uint32_t>(j);
    uint64_t texel;
    if (kind_ == TexelLayoutKind::kMorton) {
      uint32_t low = (1u << shape.shared_bits) - 1;
      uint64_t high = (x | y) >> shape.shared_bits;  // at most one axis has bits here
      texel = (high << (2 * shape.shared_bits)) | interleave(x & low, y & low);
    } else if (kind_ == TexelLayoutKind::kBlocks4x4) {
      texel = uint64_t{y >> 2} * shape.pitch + (((x >> 2) << 4) | ((y & 3) << 2) | (x & 3));
    } else {
      texel = uint64_t{y} * shape.pitch + x;
    }
    return shape.base + (texel << texel_shift_);
  }

  /// Bytes of the whole image; every offset + texel_bytes is at most this.
  uint64_t size_bytes() const { return size_bytes_; }
  TexelLayoutKind kind() const { return kind_; }
  int texel_bytes() const { return 1 << texel_shift_; }
  int root_level() const { return static_cast<int>(levels_.size()) - 1; }

  /// The image of a pyramid of this layout's shape: little-endian texels at their offsets, zeros between and where a
  /// stopped pyramid has no level.
  /// Throws usage_error when the shape differs or the pyramid has more bytes a texel.
  std::vector<std::byte> write_image(const Pyramid& pyramid) const;

 private:
  struct Level {
    uint64_t base = 0;    ///< bytes
    uint32_t pitch = 0;   ///< texels from row to row (row_major, the atlases), from block row to block row
    int shared_bits = 0;  ///< bits that interleave (morton)
    int width = 0;
    int height = 0;
  };

  /// Bits of x in the even places, bits of y in the odd ones; both below 2^16.
  static uint64_t interleave(uint32_t x, uint32_t y) {
    uint64_t both = x | (uint64_t{y} << 32);
    both = (both | (both << 8)) & 0x00FF00FF00FF00FFull;
    both = (both | (both << 4)) & 0x0F0F0F0F0F0F0F0Full;
    both = (both | (both << 2)) & 0x3333333333333333ull;
    both = (both | (both << 1)) & 0x5555555555555555ull;
    return (both & 0xFFFFFFFFull) | (both >> 31);
  }

  void place_level_after_level();
  void place_in_atlas();
  void place_in_slices();

  TexelLayoutKind kind_;
  int texel_shift_;
  std::vector<Level> levels_;
  uint64_t size_bytes_ = 0;
};

}  // namespace cuesta
