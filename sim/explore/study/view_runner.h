#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "models/heightmap/pyramid.h"
#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"
#include "models/work/outcome.h"
#include "models/work/workload.h"
#include "sim/explore/study/plan_parts.h"
#include "sim/explore/study/study.h"
#include "sim/machine/machine.h"

namespace cuesta {

/// Holds a map with its pyramid, and the rays of one view after the other. It fits plans whose axes begin
/// with size, map, depth, angle; a turn, where the plan has that axis, takes the place of study_view's.
class ViewRunner : public CaseRunner {
 public:
  /// `pixels`: of the picture, those whose rays are traced.
  ViewRunner(const StudyData& plan, std::span<const uint16_t> size_and_map, std::vector<uint32_t> pixels);

 protected:
  /// Gives the place's algorithm over the rays of its depth and angle, which are made once for all
  /// algorithms, in the numbers of `architecture`; those of the default one where none is given.
  Workload work_at(const StudyPlace& place, const Architecture& architecture = {});
  /// Throws Error(kMismatch) when another algorithm has found other hits on the same rays.
  void check_same_hits(const StudyPlace& place, std::span<const HitRecord> hits);
  /// Throws Error(kMismatch) with the first law of accounting that the outcome breaks.
  static void check_laws(const Workload& work, const Architecture& architecture, Fidelity fidelity,
                         const Outcome& outcome);
  /// Gives the value that a place has on an axis, as it is written.
  const std::string& value(const StudyPlace& place, std::string_view axis) const {
    return value_at(plan_, place, axis);
  }

  /// Counts the slots of warps of neighbouring pixels that run until their longest ray has ended: a warp's
  /// size times the sum of the maxima. Steps over these slots are the SIMT efficiency.
  int64_t simt_slots(std::span<const HitRecord> hits) const;

  const StudyData& plan_;
  Pyramid pyramid_;
  MapShape map_;
  std::vector<uint32_t> pixels_;

 private:
  const std::vector<MachineRay>& rays_at(const StudyPlace& place, const NumberFormat& format);

  bool turns_ = false;
  std::map<SearchKind, SearchMap> search_maps_;
  std::vector<MachineRay> rays_;
  std::string view_;  ///< depth, angle and turn of rays_
  std::string hits_digest_, first_algorithm_;
};

}  // namespace cuesta
