#pragma once

#include <algorithm>
#include <cstdint>

#include "models/algorithms/search.h"
#include "models/rays/hit.h"
#include "models/search/leaping_search.h"
#include "models/search/linear_search.h"
#include "models/search/printed_search.h"
#include "models/search/search_map.h"
#include "models/search/search_ray.h"
#include "models/search/search_surface.h"

// The approximate searches' value: what one ray reads, step by step, and what it finds; without time.

namespace cuesta {

/// One search over one map. `Real` is float (also where the machine's arithmetic is fixed) or double; sqrt is the only
/// function of the library that is called.
///
/// A step is one sample of the surface (its records are read: 1, or 4 filtered), before which a division takes a slot
/// of arithmetic without memory; or such a slot alone, where no sample follows it: normal              no step: the
/// hit is the entry point. Ours in form.
///   parallax            1 sample at the entry, then straight to where the ray has that height (Kaneko et al. 2001,
///                       printed: uv + h V.xy / V.z, h counted from the plane that the eye sees).
///   parallax-limited    the same without the division: N.V times as far (Welsh 2004, printed).
///   steep, pom-printed, pom, pom-tatarchuk, relief, interval: linear_search.h.
///   cone, relaxed-cone, distance, safety-radius: leaping_search.h.
///   ki2007-printed, drobot2009-printed: printed_search.h; in float, whatever `Real` is.
/// A ray that is not descending is a miss without a step for normal, parallax, parallax-limited and the printed ones,
/// whose formulas have no meaning for it; of a descending one they miss nothing but what lies beyond t_max or, in
/// border mode, the map.
template <class Real>
class Searcher {
 public:
  /// Keeps a reference to `map`. `depth`: of the slab, in tile widths, where the view's angle is asked for
  /// (parallax-limited and the three of pom): a machine ray has lost it.
  Searcher(const Search& search, const SearchMap& map, const MapShape& shape, const NumberFormat& number,
           double depth)
      : search_(search),
        number_(number),
        shape_(shape),
        format_(RealArithmetic<Real>::format(shape, number)),
        surface_(map, search.filter),
        depth_(depth) {}

  /// `sink`: read(offset) for each record of the step, compute() for a slot without memory, end_step() after each step;
  /// a step is one or more reads, one compute, or a compute and then reads. HitRecord: `i`, `j` the cell of the found
  /// point in the map's own frame, unwrapped; `t` in the unit of `times`; `steps` the calls of end_step().
  template <class Sink>
  HitRecord trace(const MachineRay& input, Arithmetic times, Sink& sink) const {
    HitRecord record;
    record.ray_id = input.id;
    const SearchRay<Real> ray = make_search_ray<Real>(input, shape_, format_);
    if (!ray.alive) return record;
    Counting<Sink> counted{sink, 0};
    if (is_printed(search_.kind)) {
      if (ray.descending()) trace_printed(input, ray, times, counted, record);
      record.steps = counted.steps;
      return record;
    }
    const SearchFound<Real> found = find(ray, counted);
    record.steps = counted.steps;
    if (!found.found) return record;
    const SearchPoint<Real> point = ray.point(found.t);
    record.status = HitStatus::kHit;
    record.face = found.face;
    record.i = static_cast<int32_t>(found.has_cell ? found.i : surface_.cell_x(point));
    record.j = static_cast<int32_t>(found.has_cell ? found.j : surface_.cell_y(point));
    record.t = time_in_record(found.t, times, format_);
    return record;
  }

 private:
  template <class Sink>
  struct Counting {
    Sink& sink;
    uint32_t steps;
    void read(uint64_t offset) { sink.read(offset); }
    void compute() { sink.compute(); }
    void end_step() {
      sink.end_step();
      ++steps;
    }
  };

  /// The listings know no t_max: what lies there is a miss. Nothing is found before the ray's start.
  template <class Sink>
  void trace_printed(const MachineRay& input, const SearchRay<Real>& ray, Arithmetic times, Sink& sink,
                     HitRecord& record) const {
    const double texel = 1.0 / shape_.width;
    const auto delta = static_cast<float>(search_.delta / 1000.0 * texel * depth_);
    const PrintedFound found =
        printed_search(search_, make_printed_ray(input, shape_, number_), surface_.map(), delta, sink);
    if (found.end != PrintedEnd::kFound) {
      record.status =
          found.end == PrintedEnd::kNotANumber ? HitStatus::kNotANumber : HitStatus::kDidNotFinish;
      return;
    }
    const Real height = static_cast<Real>(shape_.full_scale()) * (1 - static_cast<Real>(found.place.z));
    const Real t = std::max<Real>(0, ray.reaches(height));
    if (!(t < ray.t_max)) return;
    record.status = HitStatus::kHit;
    record.face = HitFace::kTop;
    record.i = static_cast<int32_t>(found.i);
    record.j = static_cast<int32_t>(found.j);
    record.t = time_in_record(t, times, format_);
  }

  template <class Sink>
  SearchFound<Real> find(const SearchRay<Real>& ray, Sink& sink) const {
    switch (search_.kind) {
      case SearchKind::kNormal:
        if (!ray.descending()) return {};
        return {true, ray.t_start, HitFace::kTop};
      case SearchKind::kParallax:
        return parallax(ray, Real{1}, sink);
      case SearchKind::kParallaxLimited:
        return parallax(ray, normal_view(ray, shape_, depth_), sink);
      case SearchKind::kPomPrinted:
      case SearchKind::kPom:
      case SearchKind::kPomTatarchuk:
        return linear_search(search_, ray, surface_, normal_view(ray, shape_, depth_), sink);
      case SearchKind::kCone:
        if (surface_.bilinear()) return leaping_search(search_, ray, surface_, cells(ray), sink);
        return cone_search(search_, ray, surface_, cells(ray), sink);
      case SearchKind::kSafetyRadius:
        if (surface_.bilinear()) return leaping_search(search_, ray, surface_, cells(ray), sink);
        return safety_radius_search(search_, ray, surface_, cells(ray), sink);
      case SearchKind::kRelaxedCone:
        return leaping_search(search_, ray, surface_, cells(ray), sink);
      case SearchKind::kDistance:
        return distance_search(search_, ray, surface_, sink);
      default:
        return linear_search(search_, ray, surface_, Real{1}, sink);
    }
  }

  template <class Sink>
  SearchFound<Real> parallax(const SearchRay<Real>& ray, Real share, Sink& sink) const {
    if (!ray.descending()) return {};
    const SearchPoint<Real> entry = ray.point(ray.t_start);
    const Real height = surface_.height(entry, sink);
    sink.end_step();
    const Real offset = std::max<Real>(0, ray.reaches(height) - ray.t_start);
    const Real t = ray.t_start + share * offset;
    if (t > ray.t_end) return {};
    return {true, t, HitFace::kTop};
  }

  SearchCells<Real> cells(const SearchRay<Real>& ray) const { return {ray, shape_, format_}; }

  Search search_;
  NumberFormat number_;
  MapShape shape_;
  typename RealArithmetic<Real>::Format format_;
  SearchSurface<Real> surface_;
  double depth_;
};

}  // namespace cuesta
