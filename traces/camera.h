#pragma once

#include "traces/scene.h"

namespace cuesta {

/// A perspective camera in world units: 1 is the width of a tile, x along u, y along v, z up from the slab's
/// floor. Rows of the picture run down, as v does, so a front view shows the map as its image.
struct Camera {
  double position[3];
  double forward[3];  ///< unit vectors, at right angles to each other
  double right[3];
  double up[3];
  double half_width;  ///< tangent of half the field of view, over the picture's width
};

/// The scene's camera over a map whose tile is `tile_height` world units long in v.
Camera make_camera(const Scene& scene, double tile_height);

}  // namespace cuesta
