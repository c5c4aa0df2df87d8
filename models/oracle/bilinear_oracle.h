#pragma once

#include <cstdint>

#include "models/heightmap/height_grid.h"
#include "models/oracle/traced_ray.h"
#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"

// The bilinear surface in exact arithmetic. Whether a ray goes below a patch is decided by signs of whole numbers;
// when, is then bisected as closely as one likes. No code is shared with the traversal.

namespace cuesta {

/// How edges are read. The machine's own: neither.
struct BilinearReading {
  bool touching = false;     ///< touching the surface counts as going below it
  bool edges_above = false;  ///< a patch holds the moment at which it is left, too
};

/// What a ray finds; i, j as in HitRecord. The time of the hit lies in [t_low, t_high], in grid steps per component
/// of the machine's ray (2^f times the time of float and double).
struct BilinearHit {
  bool hit = false;
  int64_t i = 0, j = 0;
  ExactTime<BigInt> t_low, t_high;
};

/// A machine ray over the patches of a map, as it is, unrounded: x0, y0 in the frame of the patches.
class BilinearOracle {
 public:
  /// `grid` must outlive it. Address modes: wrap, clamp, border.
  BilinearOracle(const MachineRay& ray, const HeightGrid& grid, const MapShape& shape,
                 const NumberFormat& format);

  /// From patch to patch; t_high - t_low is at most t_high / 2^precision (or what 400 halvings leave).
  BilinearHit walk(int precision, BilinearReading reading = {}) const;

  /// Whether the answer (hit, i, j) is right when touching counts, or edges are closed on the other side too.
  bool is_tie(bool hit, int64_t i, int64_t j) const;

  /// The ray's height above the surface at time `t` (as in BilinearHit) in height LSBs, over patch (i, j).
  long double height_above(long double t, int64_t i, int64_t j) const;

 private:
  /// unit^2 * (height above the patch) = c0 + c1 t + c2 t^2.
  struct Quadratic {
    BigInt c0, c1, c2;
  };
  struct Axis {
    BigInt lower;       ///< origin minus the patch's lower plane, grid steps, mirrored frame
    int first, second;  ///< stored samples at the lower and the upper plane
    int64_t index;      ///< of the patch, unwrapped, in the map's own frame
  };

  Axis axis_of(int64_t mirrored_leaf, const ExactAxis<BigInt>& axis, int size) const;
  Quadratic quadratic(const Axis& x, const Axis& y) const;
  static bool below(const Quadratic& q, const ExactTime<BigInt>& t, bool touching);
  /// The first time in [t0, t1) (or [t0, t1]) at which the ray goes below; false: none.
  static bool first_below(const Quadratic& q, const ExactTime<BigInt>& t0, const ExactTime<BigInt>& t1,
                          int precision, BilinearReading reading, BilinearHit& hit);

  ExactRay<BigInt> ray_;
  const HeightGrid& grid_;
  MapShape shape_;
  int64_t highest_ = 0;
};

}  // namespace cuesta
