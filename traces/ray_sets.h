#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "models/rays/machine_ray.h"
#include "traces/ray_trace.h"

namespace cuesta {

/// Rays without a camera that are asked for: the same values give the same rays everywhere.
struct RaySet {
  std::string kind;        ///< a name out of ray_set_kinds(); empty: no set
  uint64_t count = 65536;  ///< 1 to 2^28
  uint64_t seed = 1;
  int tile_bits =
      4;  ///< of the machine that shall take them: no ray starts beyond 2^tile_bits tiles; 0 to 20
};

/// A kind of ray set. Ray k is of class k mod classes.size(), so that each class has as many rays as another.
struct RaySetKind {
  std::string_view name;
  std::string_view meaning;  ///< one sentence
  std::span<const std::string_view> classes;
};

std::span<const RaySetKind> ray_set_kinds();

/// Ray k has id k and the k-th pixel, line by line, of a grid that is at most 1024 wide, so that every dispatch order
/// has something to order. Throws usage_error for an unknown kind, a count or tile_bits out of range;
/// Error(kIncomplete) when `watch` says stop.
RayTrace make_ray_set(const RaySet& set, const MapShape& map, const RayWatch& watch = {});

/// Throws usage_error where make_ray_set would.
void check_ray_set(const RaySet& set);

}  // namespace cuesta
