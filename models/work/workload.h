#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "models/common/statistics.h"
#include "models/heightmap/pyramid.h"
#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"
#include "models/search/search_map.h"
#include "models/units/architecture.h"

namespace cuesta {

/// One run's work: rays in the order of the trace.
struct Workload {
  const Pyramid* pyramid =
      nullptr;  ///< max pyramid, or four-corner pyramid as map.surface is; schedule.stop_level > 0: stopped there, with its means
  MapShape map;
  std::span<const MachineRay> rays;
  std::span<const uint32_t> pixel_of_ray;  ///< y * width + x, as long as rays
  int width = 0, height = 0;               ///< of the planes
  Schedule schedule;
  std::optional<Search> search = {};      ///< in the place of the schedule
  const SearchMap* search_map = nullptr;  ///< what `search` reads in the place of the pyramid's image

  double depth = 0.1;  ///< of the slab, in tile widths: what a search knows of the view's angle

  /// Of what a fetch brings: a texel of the pyramid, or a record of the search's map.
  int texel_bytes() const { return search ? search_map->record_bytes() : pyramid->texel_bytes(); }
};

/// Called now and then with rays finished and rays in all; returning false ends the run early.
using Progress = std::function<bool(uint64_t finished, uint64_t all)>;

struct Outcome {
  std::vector<HitRecord>
      hits;  ///< in the order of the trace; when partial, unfinished rays are kDidNotFinish
  Measurements measurements;
  uint64_t finished_rays = 0;  ///< < rays: partial
  std::string hits_digest;     ///< over rays and hit records
  std::string digest;          ///< and counters and planes; empty when partial
};

/// Hits, steps, texel fetches; no time.
Outcome run_functional(const Workload& work, const Architecture& architecture, const Progress& progress = {});

/// The widths that the architecture's [traverse] section gives on this map (mantissa 0 = bits + 4).
NumberFormat number_format(const TraverseParameters& traverse, const MapShape& map);

}  // namespace cuesta
