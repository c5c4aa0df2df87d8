#pragma once

#include <memory>
#include <span>
#include <vector>

#include "models/heightmap/pyramid.h"
#include "models/rays/hit.h"
#include "models/search/search_map.h"
#include "models/traversal/traversal.h"
#include "models/units/architecture.h"

namespace cuesta::twins {

/// What the rays of a run do, without time: the twins ask, the project's value code answers. A ray is named by
/// its place in the machine's order.
class RayValues {
 public:
  virtual ~RayValues() = default;
  /// ray_setup's answer: kMiss = dead at set-up.
  virtual Visit start(int ray) = 0;
  /// Where the texels that the ray's next step fetches lie in the pyramid image, bytes; none: the ray has kept them.
  virtual std::vector<uint64_t> addresses(int ray) const = 0;
  /// Slots of arithmetic before them.
  virtual int compute_slots(int) const { return 0; }
  /// One step, with what `addresses` named.
  virtual Visit step(int ray) = 0;
  /// Of a ray that has ended.
  virtual HitRecord record(int ray) const = 0;
};

std::unique_ptr<RayValues> make_ray_values(const Architecture& architecture, const Pyramid& pyramid,
                                           const MapShape& map, const NumberFormat& format,
                                           const Schedule& schedule, std::span<const MachineRay> rays);

/// Of a search, whose steps are asked for when a ray starts.
std::unique_ptr<RayValues> make_search_values(Arithmetic arithmetic, const Search& search,
                                              const SearchMap& search_map, const MapShape& map,
                                              const NumberFormat& format, double depth,
                                              std::span<const MachineRay> rays);

}  // namespace cuesta::twins
