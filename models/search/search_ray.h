#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"
#include "models/traversal/arithmetic.h"

// The part of a ray that an approximate search looks at, and how what it finds is written down.

namespace cuesta {

/// Largest integer <= x; |x| < 2^62.
template <class Real>
int64_t floor_of(Real x) {
  const auto k = static_cast<int64_t>(x);
  return static_cast<Real>(k) > x ? k - 1 : k;
}

/// A point of the ray, in texels and height LSBs of the map's own frame, unwrapped. On a plane between two cells it
/// lies in the one that the ray goes to.
template <class Real>
struct SearchPoint {
  Real t, x, y, z;
  bool back_x, back_y;  ///< the ray moves toward smaller x, y

  int64_t cell_x() const { return back_x ? -floor_of(-x) - 1 : floor_of(x); }
  int64_t cell_y() const { return back_y ? -floor_of(-y) - 1 : floor_of(y); }
};

/// The segment [t_start, t_end] that is searched. t counts as the float and double traversals count it: texels (or
/// LSBs) over the machine ray's integers. t_start = max(0, entering the map (border)), t_end the first of t_max,
/// leaving the slab (z = 0 descending, full scale rising) and leaving the map (border); planes are crossed at
/// RealArithmetic's times, so that t_start is the traversal's, bit for bit.
template <class Real>
struct SearchRay {
  using A = RealArithmetic<Real>;

  /// An axis of the mirrored frame, on the machine's grid.
  struct Axis {
    int64_t origin = 0;  ///< f fraction bits
    int64_t speed = 0;   ///< >= 0
    bool back = false;   ///< it was mirrored: the ray moves toward smaller coordinates
  };

  bool alive = false;  ///< false: a miss without a step
  Real x0 = 0, y0 = 0, z0 = 0;
  Real dx = 0, dy = 0, dz = 0;
  Real t_start = 0, t_end = 0, t_max = 0;
  Real z_end = 0;               ///< at t_end, exact where the slab ends
  bool ends_at_bottom = false;  ///< t_end is where the ray reaches z = 0
  Axis x, y;
  typename A::PlaneTime time_x, time_y, time_z;  ///< mirrored so that x and y never decrease

  bool descending() const { return dz < 0; }
  /// A sample of height h at ray height z lies under the surface: touching counts for descending rays only.
  bool under(Real z, Real h) const { return descending() ? z <= h : z < h; }

  SearchPoint<Real> point(Real t) const {
    return {t, x0 + t * dx, y0 + t * dy, t >= t_end ? z_end : z0 + t * dz, dx < 0, dy < 0};
  }
  /// When the ray has height h; dz != 0.
  Real reaches(Real h) const { return (h - z0) * time_z.inverse; }
};

template <class Real>
SearchRay<Real> make_search_ray(const MachineRay& input, const MapShape& map,
                                const typename RealArithmetic<Real>::Format& format) {
  using A = RealArithmetic<Real>;
  const int f = format.number.fraction_bits;
  SearchRay<Real> ray;
  if (input.dead) return ray;
  const auto place = [&](int64_t v) {
    return static_cast<Real>(static_cast<double>(v) * format.unit_of_position);
  };
  ray.x0 = place(input.x0);
  ray.y0 = place(input.y0);
  ray.z0 = place(input.z0);
  ray.dx = static_cast<Real>(input.dx);
  ray.dy = static_cast<Real>(input.dy);
  ray.dz = static_cast<Real>(input.dz);
  const auto axis = [&](int64_t origin, int64_t d, int size) -> typename SearchRay<Real>::Axis {
    if (d < 0) return {(int64_t{size} << f) - origin, -d, true};
    return {origin, d, false};
  };
  ray.x = axis(input.x0, input.dx, map.width);
  ray.y = axis(input.y0, input.dy, map.height);
  ray.time_x = A::plane_time(ray.x.origin, ray.x.speed, format);
  ray.time_y = A::plane_time(ray.y.origin, ray.y.speed, format);
  ray.time_z = A::height_time(input.z0, input.dz, format);
  ray.t_max = A::limit(input, format);

  ray.t_end = ray.t_max;
  if (input.dz < 0) {
    ray.t_start = std::max<Real>(0, A::at(ray.time_z, map.full_scale()));
    const Real bottom = A::at(ray.time_z, 0);
    ray.ends_at_bottom = bottom <= ray.t_end;
    ray.t_end = std::min(ray.t_end, bottom);
  } else if (input.dz > 0) {
    ray.t_end = std::min(ray.t_end, A::at(ray.time_z, map.full_scale()));
  }
  if (map.address_mode == AddressMode::kBorder) {
    ray.t_start = std::max(ray.t_start, std::max(A::at(ray.time_x, 0), A::at(ray.time_y, 0)));
    const Real leaves = std::min(A::at(ray.time_x, map.width), A::at(ray.time_y, map.height));
    if (!(ray.t_start < leaves)) return ray;
    if (leaves < ray.t_end) {
      ray.t_end = leaves;
      ray.ends_at_bottom = false;
    }
  }
  if (ray.t_start >= ray.t_max || ray.t_end < ray.t_start) return ray;
  ray.z_end = ray.ends_at_bottom ? Real{0} : ray.z0 + ray.t_end * ray.dz;
  ray.z_end = std::clamp<Real>(ray.z_end, 0, static_cast<Real>(map.full_scale()));
  ray.alive = true;
  return ray;
}

/// The time in the unit that `times` has in a hit record; machine time units are rounded to nearest.
template <class Real>
int64_t time_in_record(Real t, Arithmetic times, const typename RealArithmetic<Real>::Format& format) {
  if (times == Arithmetic::kFloat) return FloatArithmetic::bits(static_cast<float>(t));
  if (times == Arithmetic::kDouble) return DoubleArithmetic::bits(static_cast<double>(t));
  const double units = static_cast<double>(t) / format.unit_of_time + 0.5;
  if (units >= static_cast<double>(format.t_end)) return format.t_end;
  return static_cast<int64_t>(units);
}

/// The cosine between the view and the surface's normal, tile and slab as wide and deep as `depth` says.
template <class Real>
Real normal_view(const SearchRay<Real>& ray, const MapShape& map, double depth) {
  const Real u = ray.dx / static_cast<Real>(map.width), v = ray.dy / static_cast<Real>(map.height);
  const Real w = ray.dz / static_cast<Real>(map.full_scale()) * static_cast<Real>(depth);
  const Real length = std::sqrt(u * u + v * v + w * w);
  return length > 0 ? std::abs(w) / length : Real{1};
}

}  // namespace cuesta
