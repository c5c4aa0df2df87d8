#pragma once

#include "models/heightmap/height_grid.h"
#include "models/rays/map_shape.h"

namespace cuesta {

/// Of a grid: its shape, without a pyramid.
inline MapShape shape_of(const HeightGrid& grid, AddressMode mode, Surface surface = Surface::kTexel) {
  return map_shape(grid.width, grid.height, grid.bits, mode, surface);
}

/// A ray written by hand, for formats of 8 fraction bits: origin in texels and height LSBs, direction and t_max as they
/// enter the machine.
inline MachineRay ray_from(double x, double y, double z, int64_t dx, int64_t dy, int64_t dz,
                           int64_t t_max = int64_t{1} << 32) {
  MachineRay ray;
  ray.x0 = static_cast<int64_t>(x * 256);
  ray.y0 = static_cast<int64_t>(y * 256);
  ray.z0 = static_cast<int64_t>(z * 256);
  ray.dx = dx;
  ray.dy = dy;
  ray.dz = dz;
  ray.t_max = t_max;
  return ray;
}

}  // namespace cuesta
