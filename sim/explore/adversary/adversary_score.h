#pragma once

#include <span>
#include <string>
#include <string_view>

#include "models/algorithms/schedule.h"
#include "models/heightmap/height_grid.h"
#include "models/rays/machine_ray.h"
#include "models/rays/traced_ray.h"
#include "sim/machine/machine.h"

namespace cuesta {

/// What an adversary makes as large as it can.
enum class Maximise : uint8_t { kSteps, kCycles, kError };

/// Lists their names: steps, cycles, error.
std::span<const std::string_view> maximise_names();
/// Says what a score counts: "steps per ray" ...
std::string_view unit_of(Maximise maximise);

/// What a case is worth.
struct AdversaryScore {
  double score = 0;
  /// An exact algorithm that differs from the leaf walk, or the leaf walk in fixed point from exact
  /// arithmetic: a fault of the simulator. Empty: none.
  std::string fault;
};

/// Runs one algorithm on one machine over small cases.
///   steps   machine.steps per ray, of a functional run
///   cycles  machine.cycles per ray, of a run cycle by cycle
///   error   how far up or down the slab the found place lies from the exact one, in slabs, mean over the rays;
///           a hit that is missed or invented counts as 1, a tie as 0
class AdversaryScorer {
 public:
  AdversaryScorer(Algorithm algorithm, const Architecture& architecture, AddressMode mode, Maximise maximise);

  /// Scores a case. Throws as `quantise` and `number_format` do.
  AdversaryScore score(const HeightGrid& grid, std::span<const TracedRay> rays) const;
  /// Scores another algorithm on the same machine; its fault is not looked for.
  double score_of(const Algorithm& algorithm, const HeightGrid& grid, std::span<const TracedRay> rays) const;

 private:
  struct Prepared;
  Prepared prepare(const HeightGrid& grid, std::span<const TracedRay> rays) const;
  double score_of(const Algorithm& algorithm, const Prepared& prepared) const;
  std::string fault_of(const Prepared& prepared) const;
  std::vector<HitRecord> hits_of(const Schedule& schedule, Arithmetic arithmetic,
                                 const Prepared& prepared) const;

  Algorithm algorithm_;
  Architecture architecture_;
  AddressMode mode_;
  Maximise maximise_;
};

}  // namespace cuesta
