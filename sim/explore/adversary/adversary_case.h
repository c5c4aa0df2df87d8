#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/common/random.h"
#include "models/heightmap/height_grid.h"
#include "models/rays/traced_ray.h"

namespace cuesta {

/// What cases are made of.
struct AdversaryBounds {
  int width = 16, height = 16;  ///< texels, 1 to 64 each
  int bits = 8;                 ///< 1 to 16
  int rays = 8;                 ///< 1 to 4096
  double reach =
      1;  ///< tiles that a ray moves at most, along u and along v, from the slab's top to its floor
};

/// A ray that enters through the slab's top and falls to its floor, in tile units.
struct FallingRay {
  double u, v;    ///< [0, 1)
  double du, dv;  ///< -reach to reach
};

/// A map and rays over it: what an adversary changes.
struct AdversaryCase {
  HeightGrid grid;
  std::vector<FallingRay> rays;

  /// Ray k has id k and pixel (k, 0).
  std::vector<TracedRay> traced() const;
};

/// Flat, noise, spikes, pits, checker or steps, and rays with a liking for planes, corners and axes.
AdversaryCase random_adversary_case(Random& random, const AdversaryBounds& bounds);

/// With one to three changes of texels or rays.
AdversaryCase changed(Random& random, const AdversaryCase& from, const AdversaryBounds& bounds);

/// The map of one with rays of both.
AdversaryCase crossed(Random& random, const AdversaryCase& a, const AdversaryCase& b);

}  // namespace cuesta
