#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "models/heightmap/height_grid.h"

namespace cuesta {

/// Relief of width x height texels, row by row, in any unit.
using Relief = std::vector<double>;

/// A kind of height map that can be made.
struct MapKind {
  std::string_view name;
  std::string_view meaning;  ///< one sentence
  int width;                 ///< unless asked otherwise
  int height;
  int bits;
  bool stretch;  ///< the lowest texel becomes 0 and the highest full scale; else the relief is 0 to 1 already
  Relief (*make)(int width, int height, uint64_t seed);
};

/// All kinds, `fractal` first.
std::span<const MapKind> map_kinds();
/// nullptr when there is none of that name.
const MapKind* find_map_kind(std::string_view name);

/// Makes a height map. The same arguments give the same bytes with every compiler: only + - * / and sqrt on
/// float64, and integers. Every map tiles without a seam. The highest texel is at full scale (z = 1), except
/// `flat`, which is at half of it. width, height, bits 0: the kind's own.
/// Throws usage_error for an unknown kind (naming those there are), a side beyond 1 to 16384 or bits beyond 1
/// to 16.
HeightGrid generate(std::string_view kind, int width = 0, int height = 0, int bits = 0, uint64_t seed = 1);

}  // namespace cuesta
