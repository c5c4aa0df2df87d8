#pragma once

#include <cstdint>
#include <limits>

namespace cuesta {

enum class RayKind : uint8_t { kPrimary = 0, kShadow = 1, kReflection = 2, kRefraction = 3 };

/// Which coordinate of a secondary ray's origin is known exactly, because its parent hit a wall or a top there.
enum class FixedAxis : uint8_t { kNone = 0, kX = 1, kY = 2, kZ = 3 };

/// A ray as traced, before the machine quantises it. Origin and direction are in tile units: u, v of one tile
/// are 0 to 1, z is 0 to 1 of the slab. The point at time t is origin + t * direction.
struct TracedRay {
  uint64_t id = 0;                  ///< unique in a trace; hit records carry it
  double origin[3] = {0, 0, 0};     ///< finite
  double direction[3] = {0, 0, 0};  ///< finite, not all zero; not normalised
  double t_min = 0;                 ///< >= 0; the ray starts at origin + t_min * direction
  double t_max = std::numeric_limits<double>::infinity();  ///< > t_min for a ray that can hit
  uint32_t pixel_x = 0;
  uint32_t pixel_y = 0;
  RayKind kind = RayKind::kPrimary;
  FixedAxis fixed_axis = FixedAxis::kNone;
  uint16_t light = 0;            ///< index of the light that a shadow ray goes to
  int32_t fixed_coordinate = 0;  ///< plane K (x, y) or height h (z), when fixed_axis is not kNone
  uint64_t parent = std::numeric_limits<uint64_t>::max();  ///< id of the parent ray; all ones: none
  float gradient[4] = {0, 0, 0, 0};  ///< du/dpx, dv/dpx, du/dpy, dv/dpy of the base surface's uv
};

}  // namespace cuesta
