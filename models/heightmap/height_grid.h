#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cuesta {

/// The heights that the machine stores: one unsigned integer of `bits` bits per texel, row by row, heights up.
/// Full scale, 2^bits - 1, is the top plane z = 1. Texel (i, j) covers [i, i+1) x [j, j+1) in texel units;
/// i runs along u, j along v.
struct HeightGrid {
  int width = 0;   ///< texels along u, 1 to 16384
  int height = 0;  ///< texels along v, 1 to 16384
  int bits = 8;    ///< 1 to 16
  std::vector<uint16_t> texels;

  uint32_t full_scale() const { return (1u << bits) - 1; }
  uint16_t at(int i, int j) const { return texels[static_cast<size_t>(j) * width + i]; }
  uint16_t& at(int i, int j) { return texels[static_cast<size_t>(j) * width + i]; }
  /// Bytes of a texel in the machine's memory: 1 up to 8 bits, else 2.
  int texel_bytes() const { return bits <= 8 ? 1 : 2; }
};

}  // namespace cuesta
