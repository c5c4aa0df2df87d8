#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "models/common/random.h"
#include "models/heightmap/height_grid.h"
#include "models/rays/machine_ray.h"

// The catalogue of hard cases: a case is a map, an address mode, a number format and a family of rays. README.md lists
// them and is held against these tables.

namespace cuesta {

/// A map that has made traversals fail.
struct HardMap {
  std::string_view name;
  std::string_view holds;   ///< what it is
  std::string_view reason;  ///< what breaks on it, and where that is known from
  HeightGrid (*make)();     ///< the same texels every time
};
std::span<const HardMap> hard_maps();

/// Widths of the machine's numbers.
struct HardNumbers {
  std::string_view name;
  std::string_view holds;
  std::string_view reason;
  NumberFormat (*of)(const MapShape& map);  ///< times stay within 60 bits
};
/// The machine's own first.
std::span<const HardNumbers> hard_numbers();
/// 2^20 tiles: for maps of few texels alone, which a ray then crosses for a million tiles.
const HardNumbers& far_numbers();

/// What a family's rays are made for.
struct HardPlace {
  const HeightGrid& grid;
  const MapShape& map;
  const NumberFormat& format;
};

/// What must come of a family's rays whatever the map.
enum class Expected : uint8_t {
  kExact,    ///< what exact arithmetic finds
  kMiss,     ///< a miss without a step
  kRefused,  ///< an Error with a sentence, before anything is traversed
};

/// Rays that have made traversals fail.
struct HardRays {
  std::string_view name;
  std::string_view holds;
  std::string_view reason;
  Expected expected;
  void (*make)(Random& random, const HardPlace& place, std::vector<TracedRay>& rays);
};
std::span<const HardRays> hard_rays();
/// Through 2^w2 tiles, for `far_numbers`.
const HardRays& far_rays();

}  // namespace cuesta
