#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "models/heightmap/pyramid.h"
#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"
#include "sim/explore/study/study.h"
#include "sim/machine/machine.h"
#include "traces/parallel_view.h"

namespace cuesta {

/// The picture that studies of traversal look at: 256 x 128 square pixels in parallel projection over two tiles'
/// breadth, turned by 25 degrees. One direction for all rays makes the angle exact, an endless plane makes every
/// pixel a ray that hits, and two tiles' breadth meets every part of the map about equally often. A perspective
/// camera would mix angles, and show less of the map the more it is tilted.
ParallelView study_view(double angle_degrees, double depth);

/// Axes that studies of traversal have in common. `names` are kinds of generated maps, seed 1, 8 bits.
StudyAxis map_axis(std::vector<std::string> names);
StudyAxis size_axis(std::vector<std::string> texels);
StudyAxis depth_axis(std::vector<std::string> values);
StudyAxis angle_axis(std::vector<std::string> degrees);
StudyAxis turn_axis(std::vector<std::string> degrees);
StudyAxis algorithm_axis(std::vector<std::string> ids);

/// All published algorithms and each of Yun's parts alone.
std::vector<std::string> study_algorithms();
/// What holds for every case of a study that looks at `study_view`.
std::vector<std::string> view_conditions();
/// Whether a place has that value on that axis; its value as a number.
bool is_at(const StudyData& plan, const StudyPlace& place, std::string_view axis, std::string_view value);
double number_at(const StudyData& plan, const StudyPlace& place, std::string_view axis);

/// Pixels of the picture, row by row: all, or with `sampled` those of one warp of 8 x 4 pixels in four, evenly spread.
std::vector<uint32_t> picture_pixels(bool sampled);

/// A map with its pyramid, and the rays of one view after the other. For axes that begin with size, map, depth, angle;
/// a turn, where the plan has that axis, takes the place of study_view's.
class ViewBench : public StudyBench {
 public:
  /// `pixels`: of the picture, those whose rays are traced.
  ViewBench(const StudyData& plan, std::span<const uint16_t> size_and_map, std::vector<uint32_t> pixels);

 protected:
  /// The place's algorithm over the rays of its depth and angle, which are made once for all algorithms.
  Workload work_at(const StudyPlace& place, const Architecture& architecture);
  /// Throws Error(kMismatch) when another algorithm has found other hits on the same rays.
  void check_same_hits(const StudyPlace& place, std::span<const HitRecord> hits);
  const std::string& value(const StudyPlace& place, std::string_view axis) const;

  /// Slots of warps of 8 x 4 pixels that run until their longest ray has ended: 32 times the sum of the maxima. Steps
  /// over these slots: SIMT efficiency.
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
  std::string view_;  ///< depth and angle of rays_
  std::string hits_digest_, first_algorithm_;
};

}  // namespace cuesta
