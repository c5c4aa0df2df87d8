#include "traces/parallel_view.h"

#include "models/common/elementary.h"

namespace cuesta {
namespace {

/// The place within its tile; |v| < 2^31.
double in_tile(double v) {
  const double rest = v - static_cast<double>(static_cast<int64_t>(v));
  const double place = rest < 0 ? rest + 1 : rest;
  return place < 1 ? place : 0;
}

}  // namespace

RayTrace parallel_rays(const ParallelView& view) {
  const double angle = elementary::radians(view.angle_degrees), turn = elementary::radians(view.turn_degrees);
  const double sine = view.angle_degrees == 0 ? 0 : elementary::sin(angle), cosine = elementary::cos(angle);
  const double right[2] = {elementary::cos(turn), elementary::sin(turn)};
  const double away[2] = {elementary::sin(turn),
                          -elementary::cos(turn)};  // from the viewer, along the surface
  const double pixel = view.tiles_across / view.width;
  RayTrace trace{view.width, view.height, {}};
  trace.rays.reserve(static_cast<size_t>(view.width) * static_cast<size_t>(view.height));
  for (int y = 0; y < view.height; ++y) {
    const double down = pixel * (y + 0.5 - view.height * 0.5) / cosine;
    for (int x = 0; x < view.width; ++x) {
      const double across = pixel * (x + 0.5 - view.width * 0.5);
      TracedRay ray;
      ray.id = static_cast<uint64_t>(y) * static_cast<uint64_t>(view.width) + static_cast<uint64_t>(x);
      ray.pixel_x = static_cast<uint32_t>(x);
      ray.pixel_y = static_cast<uint32_t>(y);
      for (int axis = 0; axis < 2; ++axis) {
        ray.origin[axis] = in_tile(across * right[axis] - down * away[axis]);
        ray.direction[axis] = sine * away[axis];
        ray.gradient[axis] = static_cast<float>(pixel * right[axis]);
        ray.gradient[2 + axis] = static_cast<float>(-pixel / cosine * away[axis]);
      }
      ray.origin[2] = 1;
      ray.direction[2] = -cosine / view.depth;
      trace.rays.push_back(ray);
    }
  }
  return trace;
}

}  // namespace cuesta
