#include "traces/slab.h"

#include <algorithm>
#include <limits>

namespace cuesta {

bool Slab::enter(TracedRay& ray) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double end[3] = {u_end, v_end, 1};
  const double margin[3] = {u_margin, v_margin, 0};
  double first = 0, last = kInfinity, edge = kInfinity;
  int entry_axis = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = ray.origin[axis], direction = ray.direction[axis];
    if (direction == 0) {
      if (origin < 0 || origin > end[axis]) return false;
      continue;
    }
    const double near = ((direction > 0 ? 0 : end[axis]) - origin) / direction;
    const double far = ((direction > 0 ? end[axis] : 0) - origin) / direction;
    if (near > first) {
      first = near;
      entry_axis = axis;
    }
    last = std::min(last, far);
    if (axis < 2) edge = std::min(edge, far - margin[axis] / (direction > 0 ? direction : -direction));
  }
  if (!(first < last)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const bool on_plane = axis == entry_axis;
    const double moved = ray.origin[axis] + first * ray.direction[axis];
    ray.origin[axis] =
        on_plane ? (ray.direction[axis] > 0 ? 0 : end[axis]) : std::clamp(moved, 0.0, end[axis]);
  }
  ray.t_min = 0;
  ray.t_max = ends_rays ? edge - first : kInfinity;
  return ray.t_max > 0;
}

}  // namespace cuesta
