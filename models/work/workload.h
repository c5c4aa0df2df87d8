#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "models/algorithms/schedule.h"
#include "models/heightmap/pyramid.h"
#include "models/rays/machine_ray.h"
#include "models/search/search_map.h"

namespace cuesta {

/// One run's work: a surface, rays in the order of the trace, and the algorithm that finds where they meet, with the
/// numbers that it computes in. What it is worth (hits, steps, what is read) follows from it alone; machines add time.
struct Workload {
  /// The max pyramid, or the four-corner pyramid where map.surface is bilinear; with schedule.stop_level > 0 stopped
  /// there, with its means.
  const Pyramid* pyramid = nullptr;
  MapShape map;
  Arithmetic arithmetic = Arithmetic::kFixed;
  NumberFormat format;  ///< of `rays`, which `quantise` has made with it
  std::span<const MachineRay> rays;
  std::span<const uint32_t> pixel_of_ray;  ///< y * width + x, as long as rays
  int width = 0, height = 0;               ///< of the planes
  Schedule schedule;
  std::optional<Search> search = {};      ///< in the place of the schedule
  const SearchMap* search_map = nullptr;  ///< what `search` reads in the place of the pyramid's image
  double depth = 0.1;  ///< of the slab, in tile widths: what a search knows of the view's angle

  /// Returns the bytes of what a fetch brings: a texel of the pyramid, or a record of the search's map.
  int texel_bytes() const { return search ? search_map->record_bytes() : pyramid->texel_bytes(); }
};

/// Called now and then with rays finished and rays in all; returning false ends the run early.
using Progress = std::function<bool(uint64_t finished, uint64_t all)>;

}  // namespace cuesta
