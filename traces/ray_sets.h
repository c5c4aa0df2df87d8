#pragma once

#include <cstdint>

#include "models/traversal/machine_ray.h"
#include "traces/ray_trace.h"

namespace cuesta {

/// Rays without a camera, for tests and verification: the same seed gives the same rays everywhere. Ray k has id
/// k and the k-th pixel of a grid that is at most 1024 wide. `count` is at most 2^28 (throws usage_error).

/// Ray k is of angle class k mod 10: five ranges between the view and the surface's normal (0, 30, 60, 80, 89, 89.99
/// degrees), descending; horizontal; and the first four rising. Azimuth, start and slab thickness are uniform; three
/// in four start where they enter the slab (but in border mode descending rays on top), the others inside; one in
/// eight has a finite t_max. But in border mode starts spread over four tiles each way.
RayTrace random_rays(const MapShape& map, uint64_t seed, uint64_t count);

/// Rays on the map's lattice, where traversal meets its ties: origins on texel planes, texel middles, corners, edges
/// and integer heights; directions that are small whole numbers of texels and height steps, so along an axis, along
/// a diagonal, vertical, horizontal and rising; starts on the top plane, on the map's sides and before them, inside.
RayTrace lattice_rays(const MapShape& map, uint64_t seed, uint64_t count);

}  // namespace cuesta
