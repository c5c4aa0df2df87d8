#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "models/common/statistics.h"
#include "models/heightmap/pyramid.h"
#include "models/search/search_map.h"
#include "models/traversal/hit.h"
#include "models/traversal/machine_ray.h"
#include "models/traversal/schedule.h"
#include "sim/config/architecture.h"

namespace cuesta {

/// kTransaction: kCycle with rays that run ahead of time; its cycles are an estimate. kRtl: kCycle with the hardware in
/// the place of ray_setup, traverse and height_l1 (units.hmt_top).
enum class Fidelity : uint8_t { kFunctional, kTransaction, kCycle, kRtl };

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

/// Every unit in time, traverse loosely: a transaction is a run of steps that find their lines in height_l1
/// (models/traversal/run_ahead_traverse.h). Hits, steps and addresses are those of the other fidelities; the order in
/// which height_l1 is asked, and with it traffic and machine.cycles, is nearly that of run_cycle. The same counters,
/// planes and laws. Throws usage_error for units in hardware, and Error(kNoProgress) as run_cycle.
Outcome run_transaction(const Workload& work, const Architecture& architecture,
                        const Progress& progress = {});

/// Every cycle of every unit. Throws Error(kNoProgress) with each queue's fill and who waits for whom.
Outcome run_cycle(const Workload& work, const Architecture& architecture, const Progress& progress = {});

/// The algorithm with what the architecture's [traverse] section says of its schedule; its id is the canonical name.
/// Throws usage_error where that section speaks of a schedule and the algorithm is a search.
Algorithm algorithm_on(const Algorithm& algorithm, const TraverseParameters& traverse);
/// The same of several, in order, those left out that have become the same schedule as an earlier one.
std::vector<Algorithm> distinct_on(const Architecture& architecture, std::span<const Algorithm> algorithms);

/// The widths that the architecture's [traverse] section gives on this map (mantissa 0 = bits + 4).
NumberFormat number_format(const TraverseParameters& traverse, const MapShape& map);

/// Conservation laws over one outcome: in = out at every unit, stall reasons add up, bytes balance, planes +
/// nobody = totals. One sentence per broken law; empty when all hold.
std::vector<std::string> broken_laws(const Workload& work, const Architecture& architecture,
                                     Fidelity fidelity, const Outcome& outcome);

}  // namespace cuesta
