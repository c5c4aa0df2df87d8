#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/units/ray_dispatch/parameters.h"

namespace cuesta {

/// Returns the order in which ray_dispatch sends rays: a permutation of 0 .. pixels.size() - 1. `pixels` holds
/// y * width + x for each ray of the trace; rays of one pixel keep their order.
/// kScanline: by y, then x. kTile: tiles of `tile_size` squared pixels by scanline, scanline within.
/// kMorton, kHilbert: along the curve over the smallest square power of two that holds the image
/// (Hilbert: Warren, Hacker's Delight, section 16).
std::vector<uint32_t> dispatch_order(std::span<const uint32_t> pixels, int width, DispatchOrder order,
                                     int tile_size);

/// Returns the number of the tile that a pixel lies in, by scanline.
inline uint32_t tile_number(uint32_t pixel, int width, int tile_size) {
  const uint32_t w = static_cast<uint32_t>(width), size = static_cast<uint32_t>(tile_size);
  const uint32_t x = pixel % w, y = pixel / w;
  return (y / size) * ((w + size - 1) / size) + x / size;
}

}  // namespace cuesta
