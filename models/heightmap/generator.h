#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "models/heightmap/height_grid.h"

namespace cuesta {

/// Writes the `width` heights of row j, in any unit, to its second argument. Rows are asked for once each, in the
/// order 0, 1, ...
using ReliefRows = std::function<void(int j, double* row)>;

/// Told how much of a long work is done; returns false to stop it.
using Watch = std::function<bool(uint64_t done, uint64_t all)>;

/// A kind of height map that can be made.
struct MapKind {
  std::string_view name;
  std::string_view meaning;  ///< one sentence
  int width;                 ///< unless asked otherwise
  int height;
  int bits;
  bool stretch;  ///< the lowest texel becomes 0 and the highest full scale; else the relief is 0 to 1 already
  ReliefRows (*make)(int width, int height, uint64_t seed);
};

/// 128 MiB of relief are kept, more are made twice.
inline constexpr size_t kKeptTexels = size_t{4096} * 4096;

/// All kinds, `fractal` first.
std::span<const MapKind> map_kinds();
/// nullptr when there is none of that name.
const MapKind* find_map_kind(std::string_view name);

/// Makes a height map. The same arguments give the same bytes with every compiler: only + - * / and sqrt on
/// float64, and integers. Every map tiles without a seam but `steps`, whose seam is a cliff, and a `checker` of sides
/// that are no multiples of 16. The highest texel is at full scale (z = 1), except `flat`, which is at half of it.
/// width, height, bits 0: the kind's own.
/// In memory: the grid, with room for its pyramid; the relief beside it (8 bytes a texel) up to `kept_texels`;
/// above, it is made twice, with the same heights in the end. `watch` hears of rows.
/// Throws usage_error for an unknown kind (naming those there are), a side beyond 1 to 16384 or bits beyond 1
/// to 16; Error (incomplete) when `watch` stops it.
HeightGrid generate(std::string_view kind, int width = 0, int height = 0, int bits = 0, uint64_t seed = 1,
                    const Watch& watch = {}, size_t kept_texels = kKeptTexels);

}  // namespace cuesta
