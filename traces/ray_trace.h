#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "models/rays/traced_ray.h"

namespace cuesta {

/// Rays for a grid of pixels; the unit of work that a renderer hands to the machine.
struct RayTrace {
  int width = 0;  ///< pixels of the whole frame, 1 to 65536, even where the rays cover a part of it
  int height = 0;
  std::vector<TracedRay> rays;  ///< any number, in any order, several or none per pixel; ids differ
};

inline constexpr int kLongestSide = 65536;
inline constexpr uint64_t kMostPixels = uint64_t{1} << 28;

/// Called now and then by whatever makes, reads or writes many rays, with how many it has done; false: stop.
using RayWatch = std::function<bool(uint64_t finished)>;

/// Throws Error(kIncomplete) when `watch` (may be empty) says stop: whoever writes then leaves no file behind.
void keep_watch(const RayWatch& watch, uint64_t finished);

/// What makes a ray unusable as input, such as "its direction is zero", or "" for a ray that is in order: finite
/// origin and direction, a direction that is not zero, t_min finite and >= 0, t_max >= 0 (infinity is allowed),
/// finite gradients, a known kind and fixed axis, a pixel inside the grid.
std::string fault_of(const TracedRay& ray, int width, int height);

/// "" or what is wrong with a pixel grid of this size.
std::string fault_of_grid(uint64_t width, uint64_t height);

/// Throws input_error naming `where` and an id that two rays share.
void require_distinct_ids(std::vector<uint64_t> ids, const std::string& where);

std::string_view name_of(RayKind kind);    ///< primary, shadow, reflection, refraction
std::string_view name_of(FixedAxis axis);  ///< none, x, y, z

/// Same bits in every field: tells -0.0 from 0.0.
bool identical(const TracedRay& a, const TracedRay& b);
bool identical(const RayTrace& a, const RayTrace& b);

}  // namespace cuesta
