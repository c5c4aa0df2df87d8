#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "models/traversal/traversal.h"

// The exact bilinear surface, in float and double. Patch (i, j) spans [i, i+1) x [j, j+1) and interpolates the four
// samples at its corners; the pyramid is `build_four_corner_pyramid`. The walk is that of traversal.h; only the leaf
// answers otherwise: along a ray the distance to a patch is a quadratic in time, here by its Bernstein coefficients.
//
// A ray hits where it first goes below the surface: at the least time of the leaf's interval from which on it is
// below; touching is not going below. Every leaf applies its own bound, the highest of its samples, as a node does;
// and the quadratic is taken over [t_in, min(t_out, t_max)], never from t_cur: so the answer is a function of ray
// and cell, and every schedule returns the same bits.
//
// Watertight: at a time at which the ray stands on a shared border the place across the border is exact, and the
// interpolation takes the same samples in the same order from both patches.

namespace cuesta {

/// Which samples lie at a patch's corners, by their places in the map after the address mode; in the mirrored frame,
/// the lower side first.
struct PatchCorners {
  std::array<int, 2> i, j;

  /// Different samples: 4, or fewer where the map's edge is repeated.
  int samples() const { return (i[0] == i[1] ? 1 : 2) * (j[0] == j[1] ? 1 : 2); }
};

/// Heights at (i[0], j[0]), (i[1], j[0]), (i[0], j[1]), (i[1], j[1]).
using PatchHeights = std::array<uint16_t, 4>;

/// A ray on its way over a bilinear surface.
template <class A, class G>
struct BilinearState {
  using Real = typename A::Time;
  RayState<A, G> ray;
  Real dx, dy, dz;  ///< per unit of time, in texels and height LSBs; dx, dy >= 0
};

/// As `start`. The walk's surface is bilinear, its address mode not mirror, its stop level 0.
template <class A, class G>
Visit start_bilinear(const Walk<A, G>& walk, const MachineRay& input, BilinearState<A, G>& state) {
  using Real = typename A::Time;
  state.dx = static_cast<Real>(input.dx < 0 ? -input.dx : input.dx);
  state.dy = static_cast<Real>(input.dy < 0 ? -input.dy : input.dy);
  state.dz = static_cast<Real>(input.dz);
  return start(walk, input, state.ray);
}

namespace bilinear_detail {

/// Along one axis.
template <class G>
std::array<int, 2> corner_indices(const AxisMap& map, AddressMode mode, const G& place) {
  int64_t first = place.fetch_index(map, 0), second = first + 1;
  if (mode == AddressMode::kClamp) {
    const int64_t index = place.real_index(map, 0);
    first = std::clamp<int64_t>(index, 0, map.size - 1);
    second = std::clamp<int64_t>(index + 1, 0, map.size - 1);
  } else if (second == map.size) {
    second = mode == AddressMode::kWrap ? 0 : first;
  }
  if (place.flip) std::swap(first, second);
  return {static_cast<int>(first), static_cast<int>(second)};
}

/// a + (b - a) * weight; b itself at weight 1.
template <class Real>
Real interpolate(Real a, Real b, Real weight) {
  return weight == 1 ? b : a + (b - a) * weight;
}

template <class Real>
struct Samples {
  Real h00, h10, h01, h11;

  explicit Samples(const PatchHeights& h)
      : h00(static_cast<Real>(h[0])),
        h10(static_cast<Real>(h[1])),
        h01(static_cast<Real>(h[2])),
        h11(static_cast<Real>(h[3])) {}

  /// At weights 0 and 1 of either axis this is `interpolate` of two samples, to the bit.
  Real at(Real u, Real v) const { return interpolate(interpolate(h00, h10, u), interpolate(h01, h11, u), v); }
};

/// One axis of a patch: where the ray is in it, 0 to 1, at a time at which it is inside.
template <class Real>
struct PatchAxis {
  Real from_lower;        ///< the ray's origin, counted from the lower plane, texels
  Real speed;             ///< texels per unit of time
  Real t_lower, t_upper;  ///< when it crosses the two planes

  Real at(Real t) const {
    if (t == t_lower) return 0;
    if (t == t_upper) return 1;
    return std::clamp<Real>(from_lower + speed * t, 0, 1);
  }
};

/// The least tau in [0, 1] from which on b0 (1 - tau)^2 + 2 b1 tau (1 - tau) + b2 tau^2 is negative; -1: none.
template <class Real>
Real first_below(Real b0, Real b1, Real b2) {
  if (b0 < 0) return 0;
  const bool ends_below = b2 < 0;
  if (!ends_below && !(b1 < 0)) return -1;
  if (b0 == 0 && !(b1 > 0)) return 0;
  const Real discriminant = b1 * b1 - b0 * b2;
  if (!ends_below && !(discriminant > 0)) return -1;
  // The smaller root, in the form whose terms have one sign.
  const Real root = std::sqrt(std::max<Real>(discriminant, 0));
  return b1 > 0 ? (b1 + root) / (b1 + root - b2) : b0 / (b0 - b1 + root);
}

}  // namespace bilinear_detail

/// The ray's height above a patch over [t_in, end], by its Bernstein coefficients, in height LSBs.
template <class Real>
struct PatchQuadratic {
  Real t_in, end;
  Real b0, b1, b2;
};

/// Over the leaf that the ray stands before, up to min(t_out, t_max); t_in < end, or only the times are set.
template <class A, class G>
PatchQuadratic<typename A::Time> quadratic_over(const Walk<A, G>& walk, const BilinearState<A, G>& state,
                                                const PatchHeights& heights, typename A::Time t_out) {
  using Real = typename A::Time;
  const RayState<A, G>& ray = state.ray;
  const int64_t lower_x = ray.gx.enter_plane(walk.x, 0), lower_y = ray.gy.enter_plane(walk.y, 0);
  const bilinear_detail::PatchAxis<Real> x{ray.x.origin - static_cast<Real>(lower_x), state.dx,
                                           A::at(ray.x, lower_x), A::at(ray.x, lower_x + 1)};
  const bilinear_detail::PatchAxis<Real> y{ray.y.origin - static_cast<Real>(lower_y), state.dy,
                                           A::at(ray.y, lower_y), A::at(ray.y, lower_y + 1)};
  PatchQuadratic<Real> q{std::max({ray.t_start, x.t_lower, y.t_lower}), std::min(t_out, ray.t_max), 0, 0, 0};
  if (!(q.t_in < q.end)) return q;
  const bilinear_detail::Samples<Real> samples(heights);
  const auto above = [&](Real t, Real u, Real v) { return (ray.z.origin - samples.at(u, v)) + state.dz * t; };
  const Real u0 = x.at(q.t_in), v0 = y.at(q.t_in), u1 = x.at(q.end), v1 = y.at(q.end);
  q.b0 = above(q.t_in, u0, v0);
  q.b1 = (above(q.t_in, u0, v1) + above(q.end, u1, v0)) / 2;
  q.b2 = above(q.end, u1, v1);
  return q;
}

namespace bilinear_detail {

/// Of a ray that is below the surface where it starts.
template <class A, class G>
HitFace face_of_start(const Walk<A, G>& walk, const RayState<A, G>& ray) {
  if (walk.map.address_mode != AddressMode::kBorder) return HitFace::kInside;
  const auto at_edge = [&](const typename A::PlaneTime& line, int64_t lower) {
    return lower == 0 && A::at(line, 0) == ray.t_start;
  };
  if (at_edge(ray.x, ray.gx.enter_plane(walk.x, 0))) return HitFace::kWallX;
  return at_edge(ray.y, ray.gy.enter_plane(walk.y, 0)) ? HitFace::kWallY : HitFace::kInside;
}

/// The leaf's answer. True: `t_hit` and `face` are set. A bilinear surface has no walls but at the map's border:
/// kWallX, kWallY there; kInside where the ray starts below the surface; kTop otherwise.
template <class A, class G>
bool patch_is_hit(const Walk<A, G>& walk, BilinearState<A, G>& state, const PatchHeights& heights,
                  typename A::Time t_z, typename A::Time t_out) {
  using Real = typename A::Time;
  RayState<A, G>& ray = state.ray;
  // The leaf's own bound first. A rising ray at its height is above all that follows, as at a node.
  if (!ray.rising && !(t_z < std::min(t_out, ray.t_max))) return false;
  const PatchQuadratic<Real> q = quadratic_over(walk, state, heights, t_out);
  if (!(q.t_in < q.end) || (ray.rising && t_z <= q.t_in)) return false;
  const Real tau = first_below(q.b0, q.b1, q.b2);
  if (tau < 0) return false;
  const Real t_hit = q.t_in + (q.end - q.t_in) * tau;
  if (!(t_hit < q.end)) return false;
  ray.t_hit = t_hit;
  const bool starts_below = q.b0 < 0 && q.t_in == ray.t_start && (ray.rising || t_z < q.t_in);
  ray.face = starts_below ? face_of_start(walk, ray) : HitFace::kTop;
  return true;
}

}  // namespace bilinear_detail

/// Of the leaf that the ray stands before: `state.ray.level` is 0.
template <class A, class G>
PatchCorners corners_of(const Walk<A, G>& walk, const BilinearState<A, G>& state) {
  const AddressMode mode = walk.map.address_mode;
  return {bilinear_detail::corner_indices(walk.x, mode, state.ray.gx),
          bilinear_detail::corner_indices(walk.y, mode, state.ray.gy)};
}

inline PatchHeights heights_at(const Pyramid& pyramid, const PatchCorners& corners) {
  return {pyramid.at(0, corners.i[0], corners.j[0]), pyramid.at(0, corners.i[1], corners.j[0]),
          pyramid.at(0, corners.i[0], corners.j[1]), pyramid.at(0, corners.i[1], corners.j[1])};
}

/// `visit` of a leaf, that learns the heights at the patch's corners. (Nodes above are visited as over texels.)
template <class A, class G>
Visit visit_patch(const Walk<A, G>& walk, BilinearState<A, G>& state, const PatchHeights& heights) {
  using Time = typename A::Time;
  const int64_t bound = *std::max_element(heights.begin(), heights.end());
  return visit_with(walk, state.ray, bound, [&](Time t_z, Time t_out) {
    return bilinear_detail::patch_is_hit(walk, state, heights, t_z, t_out);
  });
}

/// One step over a four-corner pyramid. `reader.node(level, i, j)` or `reader.patch(corners)` hears of what is read.
template <class A, class G, class Reader>
Visit step_bilinear(const Walk<A, G>& walk, const Pyramid& pyramid, BilinearState<A, G>& state,
                    Reader& reader) {
  RayState<A, G>& ray = state.ray;
  if (ray.level == 0) {
    const PatchCorners corners = corners_of(walk, state);
    reader.patch(corners);
    return visit_patch(walk, state, heights_at(pyramid, corners));
  }
  const int i = static_cast<int>(ray.gx.fetch_index(walk.x, ray.level));
  const int j = static_cast<int>(ray.gy.fetch_index(walk.y, ray.level));
  reader.node(ray.level, i, j);
  return visit(walk, ray, pyramid.at(ray.level, i, j));
}

/// Traverses one ray to its end.
template <class A, class G, class Reader>
HitRecord traverse_bilinear_ray(const Walk<A, G>& walk, const Pyramid& pyramid, const MachineRay& input,
                                Reader& reader) {
  BilinearState<A, G> state;
  Visit now = start_bilinear(walk, input, state);
  while (now == Visit::kContinue) now = step_bilinear(walk, pyramid, state, reader);
  return hit_record(walk, state.ray, input.id, now);
}

/// Calls `body.template operator()<A, G>()` with the types that fit; float or double, any address mode but mirror.
template <class Body>
decltype(auto) with_bilinear_types(Arithmetic arithmetic, const MapShape& map, Body&& body) {
  auto with_geometry = [&]<class A>() -> decltype(auto) {
    if (map.address_mode == AddressMode::kClamp) return body.template operator()<A, ClampAxis>();
    return map.is_square_power_of_two() ? body.template operator()<A, PlainAxis>()
                                        : body.template operator()<A, TiledAxis>();
  };
  return arithmetic == Arithmetic::kFloat ? with_geometry.template operator()<FloatArithmetic>()
                                          : with_geometry.template operator()<DoubleArithmetic>();
}

}  // namespace cuesta
