#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "models/algorithms/schedule.h"
#include "models/common/random.h"
#include "models/heightmap/height_grid.h"
#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"

// Metamorphic relations: what must become of a hit when map and ray are changed together. On rays as the machine takes
// them, so that nothing is rounded between the two sides.

namespace cuesta {

struct Instance {
  HeightGrid grid;
  MapShape shape;
  NumberFormat format;
  MachineRay ray;
};

/// One walk; kDidNotFinish after more steps than any can need.
HitRecord walk(const Instance& instance, Arithmetic arithmetic, const Schedule& schedule);

/// The other side of a relation: an instance, and what must be found there.
struct Moved {
  Instance instance;
  HitRecord expected;
};

struct Relation {
  std::string_view name;
  std::string_view exact_in;  ///< where the relation holds to the bit
  /// `found`: the answer of `instance` in `arithmetic`. The same seed gives the same change, as far as the instance
  /// has it.
  /// Nothing where the relation does not apply.
  std::optional<Moved> (*move)(const Instance& instance, const HitRecord& found, Arithmetic arithmetic,
                               uint64_t seed);
  bool steps_too;   ///< the same schedule takes the same steps
  bool swaps_axes;  ///< then a wall hit in a corner, which counts as x, stays x
};
std::span<const Relation> relations();

/// Small maps of every kind and mode, rays that are likely to meet trouble. Nothing for a ray that does not fit.
std::optional<Instance> random_instance(Random& random, int max_side);

/// Hit, cell, t, face.
bool agree(const Relation& relation, const HitRecord& expected, const HitRecord& found);

/// A smaller instance of which `fails` is still true: texels, sides and the ray's numbers are cut while it is.
Instance shrink(const Instance& failing, const std::function<bool(const Instance&)>& fails);

/// Texels, ray, numbers.
std::string describe(const Instance& instance);

}  // namespace cuesta
