#pragma once

#include "models/rays/traced_ray.h"

namespace cuesta {

/// The box over the plane that holds the surface, in tile units: [0, u_end] x [0, v_end] x [0, 1].
struct Slab {
  double u_end, v_end;
  bool ends_rays;             ///< a ray's t_max ends it at the plane's edge, `margin` before it
  double u_margin, v_margin;  ///< tile units

  /// Moves the ray's origin to where it enters the box, exactly onto the plane that it enters through, and sets its
  /// t range; an origin inside stays. False when the ray never is inside: touching an edge is not being inside.
  bool enter(TracedRay& ray) const;
};

}  // namespace cuesta
