#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "models/oracle/verdict.h"

namespace cuesta {

/// Counts over random maps and rays on bilinear surfaces, in float and double.
struct BilinearCheck {
  /// Answers of one arithmetic against the exact surface, of the ray as quantised.
  struct Exact {
    VerdictCounts verdicts;
    int64_t times = 0;          ///< of hits in the exact cell
    int64_t within_4 = 0;       ///< of these: at most 4 ulps from the exact time
    double largest_ulps = 0;    ///< of the exact time, between it and the time found
    double largest_height = 0;  ///< height LSBs between the ray, at the time found, and the surface
  };

  int64_t maps = 0;
  int64_t rays = 0;
  int64_t hits = 0;         ///< in double
  int64_t comparisons = 0;  ///< of a schedule with the leaf walk, in the same arithmetic
  int64_t mismatches = 0;   ///< another hit, cell, t or face
  int64_t endless = 0;      ///< walks given up
  std::array<int64_t, 4> rays_by_mode{};
  std::array<Exact, 2> exact;      ///< float, double
  int64_t borders = 0;             ///< crossings from patch to patch
  int64_t border_differences = 0;  ///< where the two patches disagree on the ray's height above the surface
  int64_t falling = 0;             ///< rays that reach the floor of an endless surface in time
  int64_t gaps = 0;                ///< of these: misses
  std::string first_failure;       ///< decoded; empty: none

  bool passed() const { return mismatches + endless + border_differences + gaps == 0; }
  void add(const BilinearCheck& other);
};

/// Every schedule against the leaf walk, to the bit. The same seed gives the same counts, here and below.
BilinearCheck check_bilinear_walks(uint64_t seed, int64_t rays, int max_side);

/// The leaf walk against the exact surface: any place and direction, the lattice, and fans as below.
BilinearCheck check_bilinear_exactly(uint64_t seed, int64_t rays, int max_side);

/// Fans of rays, a grid step apart, swept across corners and borders of patches of surfaces without an edge: what two
/// patches say of the border that they share, and whether every ray that falls to the floor hits.
BilinearCheck check_bilinear_borders(uint64_t seed, int64_t rays, int max_side);

}  // namespace cuesta
