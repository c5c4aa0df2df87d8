#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "models/search/linear_search.h"
#include "models/search/preprocessing.h"
#include "models/search/search_cells.h"
#include "models/search/search_surface.h"

// The searches that leap as far as the map says is safe, or likely so. One sample is one step; a leap's arithmetic,
// divisions included, belongs to its step. When the steps are used up, the place reached is the hit (Dummer 2006,
// Donnelly 2005), so that they miss nothing but what lies beyond t_max, the map's border or above all.

namespace cuesta {
namespace search_detail {

/// Cones open in all directions: reach in texels per height LSB.
template <class Real>
Real cone_ratio(Real byte, const SearchMap& map) {
  const Real root = byte / Real{kConeScale};
  return root * root * static_cast<Real>(std::max(map.width(), map.height())) /
         static_cast<Real>((1 << map.bits()) - 1);
}

/// A radius in texels.
template <class Real>
Real safety_radius(Real byte, const SearchMap& map) {
  const Real root = byte / Real{kConeScale};
  return root * root * static_cast<Real>(std::max(map.width(), map.height()));
}

/// Texels along the map per unit of t.
template <class Real>
Real ground_speed(const SearchRay<Real>& ray) {
  return std::sqrt(ray.dx * ray.dx + ray.dy * ray.dy);
}

/// The time in which a ray at `point` over a cone of `ratio` that stands `offset` texels aside at `height` surely stays
/// inside it; infinite if it never leaves. `margin` texels are held back.
template <class Real>
Real time_in_cone(const SearchRay<Real>& ray, const SearchPoint<Real>& point, Real height, Real ratio,
                  Real offset, Real margin) {
  const Real room = ratio * (point.z - height) - offset - margin;
  if (!(room > 0)) return 0;
  const Real closing = ground_speed(ray) - ratio * ray.dz;
  return closing > 0 ? room / closing : std::numeric_limits<Real>::infinity();
}

/// Upper bound, in texels, of what rounding does to a leap from `point`: a few units in the last place of everything
/// that is added on the way.
template <class Real>
Real rounding_margin(const SearchRay<Real>& ray, const SearchPoint<Real>& point, const SearchMap& map) {
  const Real side = static_cast<Real>(std::max(map.width(), map.height()));
  return 16 * std::numeric_limits<Real>::epsilon() *
         (side + std::abs(ray.x0) + std::abs(ray.y0) +
          std::abs(point.t) * (std::abs(ray.dx) + std::abs(ray.dy)));
}

/// The segment ends at `t` without a hit: at the bottom alone a descending ray may still have one.
template <class Real>
bool over(const SearchRay<Real>& ray, Real t) {
  return t >= ray.t_max || (t >= ray.t_end && !ray.ends_at_bottom);
}

/// The distance of a point from its cell's centre, texels.
template <class Real>
Real off_centre(const SearchPoint<Real>& point, const SearchCells<Real>& cells) {
  const Real x = point.x - (static_cast<Real>(cells.i()) + Real{0.5});
  const Real y = point.y - (static_cast<Real>(cells.j()) + Real{0.5});
  return std::sqrt(x * x + y * y);
}

}  // namespace search_detail

/// Cone step mapping (Dummer 2006) over constant texels, made safe there (ours): the cone stands on its texel's centre,
/// not under the ray; a texel is left at its border at the least, and asked exactly, as the exact walk asks it. A hit
/// is therefore the exact walk's, bit for bit in the same arithmetic, unless the steps were used up: then it is
/// earlier.
template <class Real, class Sink>
SearchFound<Real> cone_search(const Search& search, const SearchRay<Real>& ray,
                              const SearchSurface<Real>& surface, SearchCells<Real> cells, Sink& sink) {
  using namespace search_detail;
  const SearchMap& map = surface.map();
  const bool border = map.address_mode() == AddressMode::kBorder;
  Real t = ray.t_start;
  for (int k = 0; k < search.steps; ++k) {
    if (over(ray, t) || (border && !cells.inside_map())) return {};
    const int i = cells.stored_i(), j = cells.stored_j();
    sink.read(map.offset(i, j));
    sink.end_step();
    const auto leaf = cells.ask(map.height_at(i, j));
    if (leaf.hit) return {true, leaf.t_hit, leaf.face, true, cells.i(), cells.j()};
    const SearchPoint<Real> point = ray.point(t);
    const Real ratio = cone_ratio<Real>(map.added_at(i, j), map);
    const Real leap = time_in_cone(ray, point, static_cast<Real>(map.height_at(i, j)), ratio,
                                   off_centre(point, cells), rounding_margin(ray, point, map));
    if (t + leap > leaf.t_out) {
      t = std::min(t + leap, ray.t_end);
      cells.go_to(t);
    } else {
      t = leaf.t_out;
      cells.cross(t);
    }
  }
  if (over(ray, t)) return {};
  return {true, t, HitFace::kTop, true, cells.i(), cells.j()};
}

/// Safety radii (Baboud & Decoret 2006, march and bisection reconstructed) over constant texels (the exact questions
/// ours): a ray that does not rise and is above the surface leaps by the radius; found under the surface, it has
/// pierced it once since, and halving finds where. Samples of the halving count as `refinements`; each moves an end
/// to its cell's border or its exact hit, so that the halving ends by itself. A hit is the exact walk's, bit for bit,
/// unless steps or refinements were used up: then it is earlier, a place that the ray reaches above the surface.
/// Rising rays, whose every exit is through a top, and in clamp mode places outside the map go texel by texel.
template <class Real, class Sink>
SearchFound<Real> safety_radius_search(const Search& search, const SearchRay<Real>& ray,
                                       const SearchSurface<Real>& surface, SearchCells<Real> cells,
                                       Sink& sink) {
  using namespace search_detail;
  const SearchMap& map = surface.map();
  const AddressMode mode = map.address_mode();
  const Real speed = ground_speed(ray);
  const auto read = [&] {
    sink.read(map.offset(cells.stored_i(), cells.stored_j()));
    sink.end_step();
    return cells.ask(map.height_at(cells.stored_i(), cells.stored_j()));
  };
  const auto here = [&](Real t, HitFace face) -> SearchFound<Real> {
    return {true, t, face, true, cells.i(), cells.j()};
  };
  Real t = ray.t_start, above = ray.t_start;  // the ray is over the surface up to `above`
  bool leapt = false;
  for (int k = 0; k < search.steps; ++k) {
    const bool outside = !cells.inside_map();
    if ((!leapt && over(ray, t)) || (mode == AddressMode::kBorder && outside)) return {};
    auto leaf = read();
    if (leapt && leaf.t_hit <= t && leaf.t_hit <= leaf.t_in) {
      // Under the surface since before this cell: one piercing in [above, t_in].
      SearchFound<Real> hit = here(leaf.t_hit, leaf.face);
      for (int m = 0; m < search.refinements && above < hit.t; ++m) {
        const Real middle = above + (hit.t - above) / 2;
        cells.go_to(middle);
        leaf = read();
        if (leaf.t_hit < leaf.t_out && (leaf.t_hit > middle || leaf.t_hit > leaf.t_in)) {
          hit = here(leaf.t_hit, leaf.face);
          above = hit.t;
        } else if (leaf.t_hit <= middle) {
          hit = here(leaf.t_hit, leaf.face);
        } else {
          above = leaf.t_out;
        }
      }
      if (above < hit.t) {
        cells.go_to(above);
        hit = here(above, HitFace::kTop);
      }
      return hit.t < ray.t_max ? hit : SearchFound<Real>{};
    }
    if (leaf.hit) return here(leaf.t_hit, leaf.face);
    if (leapt && over(ray, t)) return {};
    above = leaf.t_out;
    leapt = false;
    if (ray.dz <= 0 && speed > 0 && !(mode == AddressMode::kClamp && outside)) {
      const SearchPoint<Real> point = ray.point(t);
      const Real radius = safety_radius<Real>(map.added_at(cells.stored_i(), cells.stored_j()), map);
      const Real room = radius - off_centre(point, cells) - rounding_margin(ray, point, map);
      const Real leap = std::min(t + room / speed, ray.t_end);
      leapt = leap > leaf.t_out;
      if (leapt) t = leap;
    }
    if (leapt) {
      cells.go_to(t);
    } else {
      t = leaf.t_out;
      cells.cross(t);
    }
  }
  if (!leapt && over(ray, t)) return {};
  cells.go_to(above);
  return here(above, HitFace::kTop);
}

/// Cones and radii over the filtered surface, where neither is safe (printed of cones: EGSR 2024), and relaxed cones,
/// which are not on either. A sample under the surface ends the search. cone           the cone stands under the ray
/// and there is no smallest step, as published: the ray nears the surface without reaching it, and stops short of it
/// when the steps are used up relaxed-cone   Policarpo & Oliveira 2007, reconstructed: the same, then `refinements`
/// halvings between the last place above the surface and the last one reached safety-radius  the next texel border at
/// the least (ours), then `refinements` halvings of the last leap
template <class Real, class Sink>
SearchFound<Real> leaping_search(const Search& search, const SearchRay<Real>& ray,
                                 const SearchSurface<Real>& surface, SearchCells<Real> cells, Sink& sink) {
  using namespace search_detail;
  const SearchMap& map = surface.map();
  const bool radius = search.kind == SearchKind::kSafetyRadius,
             relaxed = search.kind == SearchKind::kRelaxedCone;
  const Real speed = ground_speed(ray);
  Real t = ray.t_start, above = ray.t_start;
  for (int k = 0; k < search.steps; ++k) {
    const SearchPoint<Real> point = ray.point(t);
    const auto sample = surface.both(point, sink);
    sink.end_step();
    if (ray.under(point.z, sample.height)) {
      if (k == 0) return {true, t, HitFace::kInside};
      if (!radius && !relaxed) return {true, t, HitFace::kTop};
      return {true, halve(ray, surface, above, t, search.refinements, sink), HitFace::kTop};
    }
    if (t >= ray.t_end) return {};
    above = t;
    if (radius) {
      if (speed > 0) t += safety_radius(sample.added, map) / speed;
      cells.go_to(above);
      t = std::max(t, cells.ask(0).t_out);
    } else {
      t += time_in_cone(ray, point, sample.height, cone_ratio(sample.added, map), Real{0}, Real{0});
    }
    t = std::min(t, ray.t_end);
  }
  if (relaxed) t = halve(ray, surface, above, t, search.refinements, sink);
  return {true, t, HitFace::kTop};
}

/// Sphere tracing through the distance field (Donnelly 2005, reconstructed): the texel's byte in the layer of the ray's
/// height; a byte of 0 (in the surface, or nearer than a byte tells) or the last step is the hit.
template <class Real, class Sink>
SearchFound<Real> distance_search(const Search& search, const SearchRay<Real>& ray,
                                  const SearchSurface<Real>& surface, Sink& sink) {
  using namespace search_detail;
  const SearchMap& map = surface.map();
  const Real full = static_cast<Real>((1 << map.bits()) - 1);
  const Real slab = static_cast<Real>(distance_slab_texels(map.width(), map.height()));
  const Real rise = ray.dz * (slab / full);
  const Real speed = std::sqrt(ray.dx * ray.dx + ray.dy * ray.dy + rise * rise);
  Real t = ray.t_start;
  for (int k = 0; k < search.steps; ++k) {
    const SearchPoint<Real> point = ray.point(t);
    const auto layer = static_cast<int>(point.z * Real{kDistanceLayers} / full);
    const Real byte = surface.distance(point, std::clamp(layer, 0, kDistanceLayers - 1), sink);
    sink.end_step();
    if (!(byte > 0)) return {true, t, k == 0 ? HitFace::kInside : HitFace::kTop};
    t += byte / 255 * slab / speed;
    if (t >= ray.t_end) {
      if (!ray.ends_at_bottom) return {};
      return {true, ray.t_end, HitFace::kTop};
    }
  }
  return {true, t, HitFace::kTop};
}

}  // namespace cuesta
