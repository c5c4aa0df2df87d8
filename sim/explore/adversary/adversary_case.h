#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/common/random.h"
#include "models/heightmap/height_grid.h"
#include "models/rays/traced_ray.h"

namespace cuesta {

/// The bounds of what cases are made of.
struct AdversaryBounds {
  int width = 16, height = 16;  ///< texels, 1 to 64 each
  int bits = 8;                 ///< 1 to 16
  int rays = 8;                 ///< 1 to 4096
  /// Tiles that a ray moves at most, along u and along v, from the slab's top to its floor.
  double reach = 1;
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

  /// Gives the rays as a trace has them: ray k has id k and pixel (k, 0).
  std::vector<TracedRay> traced() const;
};

/// Makes a case: a map that is flat, noise, spikes, pits, checker or steps, and rays with a liking for
/// planes, corners and axes.
AdversaryCase random_adversary_case(Random& random, const AdversaryBounds& bounds);

/// Makes a case like `from` with one to three changes of texels or rays.
AdversaryCase changed(Random& random, const AdversaryCase& from, const AdversaryBounds& bounds);

/// Makes a case with the map of `a` and rays of both.
AdversaryCase crossed(Random& random, const AdversaryCase& a, const AdversaryCase& b);

}  // namespace cuesta
