#include "traces/ray_trace.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "models/common/error.h"

namespace cuesta {

void keep_watch(const RayWatch& watch, uint64_t finished) {
  if (!watch || watch(finished)) return;
  throw Error(ExitCode::kIncomplete,
              "Stopped after " + std::to_string(finished) + " rays; nothing of them is kept.");
}

std::string fault_of(const TracedRay& ray, int width, int height) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "uvz"[axis]);
    if (!std::isfinite(ray.origin[axis])) return "its origin's " + name + " is not a finite number";
    if (!std::isfinite(ray.direction[axis])) return "its direction's " + name + " is not a finite number";
  }
  if (ray.direction[0] == 0 && ray.direction[1] == 0 && ray.direction[2] == 0) return "its direction is zero";
  if (!std::isfinite(ray.t_min) || ray.t_min < 0) return "its t_min is not a finite number >= 0";
  if (!(ray.t_max >= 0)) return "its t_max is not a number >= 0";
  for (float gradient : ray.gradient) {
    if (!std::isfinite(gradient)) return "one of its gradients is not a finite number";
  }
  if (ray.kind > RayKind::kRefraction) {
    return "its kind is " + std::to_string(static_cast<int>(ray.kind)) + ", and 0 to 3 are accepted";
  }
  if (ray.fixed_axis > FixedAxis::kZ) {
    return "its fixed axis is " + std::to_string(static_cast<int>(ray.fixed_axis)) +
           ", and 0 to 3 are accepted";
  }
  if (ray.pixel_x >= static_cast<uint32_t>(width) || ray.pixel_y >= static_cast<uint32_t>(height)) {
    return "its pixel (" + std::to_string(ray.pixel_x) + ", " + std::to_string(ray.pixel_y) +
           ") lies outside the grid of " + std::to_string(width) + " x " + std::to_string(height);
  }
  return "";
}

std::string fault_of_grid(uint64_t width, uint64_t height) {
  if (width >= 1 && height >= 1 && width <= kLongestSide && height <= kLongestSide &&
      width * height <= kMostPixels) {
    return "";
  }
  return "a grid of " + std::to_string(width) + " x " + std::to_string(height) +
         " pixels; 1 to 65536 on a side and at most 2^28 pixels are accepted";
}

void require_distinct_ids(std::vector<uint64_t> ids, const std::string& where) {
  if (std::adjacent_find(ids.begin(), ids.end(), std::greater_equal<>()) == ids.end()) return;
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) {
    throw input_error(where + ": two rays have the id " + std::to_string(*twice) +
                      "; each ray of a trace needs an id of its own.");
  }
}

std::string_view name_of(RayKind kind) {
  static constexpr std::string_view kNames[] = {"primary", "shadow", "reflection", "refraction"};
  return kNames[static_cast<int>(kind) & 3];
}

std::string_view name_of(FixedAxis axis) {
  static constexpr std::string_view kNames[] = {"none", "x", "y", "z"};
  return kNames[static_cast<int>(axis) & 3];
}

bool identical(const TracedRay& a, const TracedRay& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<uint64_t>(x) == std::bit_cast<uint64_t>(y);
  };
  for (int axis = 0; axis < 3; ++axis) {
    if (!same(a.origin[axis], b.origin[axis]) || !same(a.direction[axis], b.direction[axis])) return false;
  }
  for (int k = 0; k < 4; ++k) {
    if (std::bit_cast<uint32_t>(a.gradient[k]) != std::bit_cast<uint32_t>(b.gradient[k])) return false;
  }
  return a.id == b.id && same(a.t_min, b.t_min) && same(a.t_max, b.t_max) && a.pixel_x == b.pixel_x &&
         a.pixel_y == b.pixel_y && a.kind == b.kind && a.fixed_axis == b.fixed_axis && a.light == b.light &&
         a.fixed_coordinate == b.fixed_coordinate && a.parent == b.parent;
}

bool identical(const RayTrace& a, const RayTrace& b) {
  return a.width == b.width && a.height == b.height &&
         std::equal(a.rays.begin(), a.rays.end(), b.rays.begin(), b.rays.end(),
                    [](const TracedRay& x, const TracedRay& y) { return identical(x, y); });
}

}  // namespace cuesta
