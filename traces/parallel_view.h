#pragma once

#include "traces/ray_trace.h"

namespace cuesta {

/// A picture of an endless plane of tiles under a parallel projection: every ray has the same direction, so that the
/// angle is exact; pixels are square on the screen, so that neighbours stand as far apart on the surface as in a
/// picture; every pixel is a ray.
struct ParallelView {
  double angle_degrees = 0;  ///< between the view and the surface's normal: 0 to below 90
  double turn_degrees = 0;   ///< of the view around the normal; 0: along -v
  double depth = 0.1;        ///< thickness of the slab in widths of a tile
  double tiles_across = 1;   ///< that the picture's width spans
  int width = 256;           ///< pixels
  int height = 256;
};

/// One ray through the middle of each pixel, row by row; its id is pixel_y * width + pixel_x. A ray starts on the
/// plane z = 1 at u, v in [0, 1): for a map that repeats, tiles are alike.
RayTrace parallel_rays(const ParallelView& view);

}  // namespace cuesta
