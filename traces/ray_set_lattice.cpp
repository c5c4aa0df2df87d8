#include "traces/ray_set_makers.h"

namespace cuesta {

void make_lattice_ray(Random& random, const RaySetPlace& place, int, TracedRay& ray) {
  const MapShape& map = place.map;
  const int64_t size[3] = {map.width, map.height, map.full_scale()};
  // Directions in texels and height steps: zero in one component of two, else a small whole number, now and then
  // a power of two, so that rays run along axes, diagonals and through corners.
  int64_t step[3] = {0, 0, 0};
  while (step[0] == 0 && step[1] == 0 && step[2] == 0) {
    for (int64_t& value : step) {
      if (random.chance(0.4)) continue;
      value = random.chance(0.3) ? int64_t{1} << random.below(6) : random.between(1, 3);
      if (random.chance(0.5)) value = -value;
    }
    if (step[2] > 0 && random.chance(0.6)) step[2] = -step[2];
  }
  // Planes in halves, so that texel middles are among them.
  int64_t twice[3];
  for (int axis = 0; axis < 2; ++axis) {
    const uint64_t where = random.below(8);
    twice[axis] = where == 0   ? 0
                  : where == 1 ? 2 * size[axis]
                  : where == 2 ? random.between(0, 2 * size[axis])
                               : 2 * random.between(0, size[axis]);
    const bool outside = where == 3;
    if (place.tiles > 1 && (outside || map.address_mode != AddressMode::kBorder)) {
      twice[axis] += 2 * size[axis] * random.between(-1, 1);
    }
  }
  twice[2] = random.chance(0.5) ? 2 * size[2] : 2 * random.between(0, size[2]);
  for (int axis = 0; axis < 3; ++axis) {
    const double unit = static_cast<double>(size[axis]);
    ray.origin[axis] = static_cast<double>(twice[axis]) / (2 * unit);
    ray.direction[axis] = static_cast<double>(step[axis]) / unit;
  }
  if (random.chance(0.25)) ray.t_max = static_cast<double>(random.between(0, 64));
}

}  // namespace cuesta
