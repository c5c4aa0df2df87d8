#include "models/units/ray_dispatch/dispatch_order.h"

#include <algorithm>
#include <numeric>

namespace cuesta {

namespace {

uint64_t morton_key(uint32_t x, uint32_t y) {
  uint64_t key = 0;
  for (int bit = 0; bit < 32; ++bit) {
    key |= static_cast<uint64_t>((x >> bit) & 1) << (2 * bit) | static_cast<uint64_t>((y >> bit) & 1)
                                                                    << (2 * bit + 1);
  }
  return key;
}

uint64_t hilbert_key(uint32_t x, uint32_t y) {
  uint64_t key = 0;
  for (uint32_t side = 1u << 16; side > 0; side >>= 1) {
    const uint32_t right = (x & side) != 0, upper = (y & side) != 0;
    key = key * 4 + ((3 * right) ^ upper);
    if (upper == 0) {
      if (right == 1) {
        x = ~x;
        y = ~y;
      }
      std::swap(x, y);
    }
  }
  return key;
}

}  // namespace

std::vector<uint32_t> dispatch_order(std::span<const uint32_t> pixels, int width, DispatchOrder order,
                                     int tile_size) {
  std::vector<uint64_t> keys(pixels.size());
  for (size_t k = 0; k < pixels.size(); ++k) {
    const uint32_t x = pixels[k] % static_cast<uint32_t>(width), y = pixels[k] / static_cast<uint32_t>(width);
    switch (order) {
      case DispatchOrder::kScanline:
        keys[k] = pixels[k];
        break;
      case DispatchOrder::kTile:
        keys[k] = static_cast<uint64_t>(tile_number(pixels[k], width, tile_size)) << 32 |
                  (y % static_cast<uint32_t>(tile_size) * static_cast<uint32_t>(tile_size) +
                   x % static_cast<uint32_t>(tile_size));
        break;
      case DispatchOrder::kMorton:
        keys[k] = morton_key(x, y);
        break;
      case DispatchOrder::kHilbert:
        keys[k] = hilbert_key(x, y);
        break;
    }
  }
  std::vector<uint32_t> permutation(pixels.size());
  std::iota(permutation.begin(), permutation.end(), 0u);
  if (!std::is_sorted(keys.begin(), keys.end())) {
    std::stable_sort(permutation.begin(), permutation.end(),
                     [&](uint32_t a, uint32_t b) { return keys[a] < keys[b]; });
  }
  return permutation;
}

}  // namespace cuesta
