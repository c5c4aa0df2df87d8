#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "models/work/hit_judge.h"
#include "reports/result.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/machine.h"
#include "sim/session/fidelity.h"
#include "sim/session/job.h"

namespace cuesta {

/// What runs a machine cycle by cycle: run_cycle, or a host around it. `rays`: as traced, in the order of
/// `work.rays`.
using CycleRunner = std::function<Outcome(const Workload& work, std::span<const TracedRay> rays,
                                          const Architecture& architecture, const Progress& progress)>;

/// Throws usage_error where the scene's surface does not go with the algorithm or with the machine's numbers: what a
/// bilinear one lacks. Needs no heights.
void check_surface(const Scene& scene, const Algorithm& named, const Architecture& architecture);

/// Runs algorithms on machines over one job, and holds every run against what must be true of it.
class Measurer {
 public:
  /// `job` must outlive it.
  explicit Measurer(const Job& job, CycleRunner cycle_runner = {})
      : job_(job), cycle_runner_(std::move(cycle_runner)) {}

  /// The algorithm as algorithm_on(..., architecture) has it; the entry carries that name. Throws usage_error as
  /// `check`.
  /// A search's hits are held against the true ones: counters error.* and what goes with them.
  /// Throws Error(kMismatch) for a broken law of the accounting, and when exact algorithms disagree: with the same
  /// numbers and leaves, every schedule returns the same hits. Throws input_error for a ray that does not fit the
  /// machine's numbers. Stopped early by `progress`, the entry is partial and only its finished rays count.
  RunEntry run(const Algorithm& named, const Architecture& architecture, Fidelity fidelity,
               const Progress& progress = {});

  /// Throws usage_error for what `run` would refuse on this job: a stop level above the map's root, a surface or a
  /// map that the algorithm or the machine's numbers cannot do.
  void check(const Algorithm& named, const Architecture& architecture) const;

  /// What was preprocessed for searches, in order, and how long it took.
  struct Preprocessing {
    std::string what;
    double seconds;
  };
  std::span<const Preprocessing> preprocessing() const { return preprocessing_; }

  /// Digest over the hits without their steps: equal for all exact algorithms with the same numbers.
  static std::string steps_free_digest(const std::vector<HitRecord>& hits);

 private:
  /// Quantised once for each number format.
  const std::vector<MachineRay>& rays_for(const NumberFormat& format);
  void check_same_hits(const Workload& work, const std::vector<HitRecord>& hits, const std::string& run_name);

  const Pyramid& pyramid_for(const Algorithm& algorithm);
  const SearchMap& search_map_for(const Search& search);
  /// How right a search's hits are: counters error.*, histograms and a plane.
  void judge(const Workload& work, Outcome& outcome);

  const Job& job_;
  std::map<SearchKind, SearchMap> search_maps_;
  std::vector<Preprocessing> preprocessing_;
  std::optional<HitJudge> judge_;  ///< of the numbers of judge_format_
  NumberFormat judge_format_;
  std::optional<Pyramid> stopped_;  ///< of the last stop level above 0
  CycleRunner cycle_runner_;        ///< empty: run_cycle
  std::vector<std::pair<NumberFormat, std::vector<MachineRay>>> rays_;
  std::map<std::string, std::pair<std::string, std::string>>
      hits_;  ///< numbers and leaves -> digest, who found it
};

}  // namespace cuesta
