#pragma once

#include "models/common/random.h"
#include "models/rays/machine_ray.h"

namespace cuesta {

/// What a maker of a set's rays knows besides the ray's class.
struct RaySetPlace {
  const MapShape& map;
  int64_t tiles;  ///< 2^tile_bits: how far from tile 0 a ray may start, both ways
};

// One maker per kind; `ray` comes without origin, direction and range, and leaves with them.
void make_random_ray(Random& random, const RaySetPlace& place, int ray_class, TracedRay& ray);
void make_stratified_ray(Random& random, const RaySetPlace& place, int ray_class, TracedRay& ray);
void make_lattice_ray(Random& random, const RaySetPlace& place, int ray_class, TracedRay& ray);
void make_adversarial_ray(Random& random, const RaySetPlace& place, int ray_class, TracedRay& ray);

/// Uniform in [low, high).
inline double uniform(Random& random, double low, double high) { return low + (high - low) * random.unit(); }

/// The ray, whose direction is set, passes through a random point of the tile's slab; one in four starts there, the
/// others where they enter: on top, on a side, or rising, on the floor. Where the map repeats, sides mean nothing:
/// descending rays start on top, and the tile is one of the eight each way around tile 0 that `place` allows.
void start_in_slab(Random& random, const RaySetPlace& place, TracedRay& ray);

}  // namespace cuesta
