#pragma once

#include <algorithm>
#include <cstdint>

#include "models/algorithms/schedule.h"
#include "models/heightmap/pyramid.h"
#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"
#include "models/traversal/arithmetic.h"
#include "models/traversal/geometry.h"

// The traversal's value: what one ray does, step by step, without time. `start` is what ray_setup computes,
// `visit` what traverse computes for one node; both the functional run and the cycle model call them, so a hit
// is computed in one place.
//
// Every exact algorithm is this code under another schedule. A node is skipped only when its bound proves that
// it holds no hit, where the ray is follows from the time alone, and the leaf's answer is a function of ray and
// cell: so every schedule returns the same hit, bit for bit.

namespace cuesta {

enum class Visit : uint8_t { kContinue, kHit, kMiss };

/// What is the same for all rays of a run.
template <class A, class G>
struct Walk {
  typename A::Format format;
  MapShape map;
  AxisMap x, y;
  Schedule schedule;
  int32_t root_bound;  ///< the pyramid's root: the map's maximum

  Walk(const MapShape& shape, const NumberFormat& number, const Schedule& rules, int32_t root_maximum)
      : format(A::format(shape, number)),
        map(shape),
        x{shape.width, int64_t{1} << shape.root_level, shape.root_level},
        y{shape.height, int64_t{1} << shape.root_level, shape.root_level},
        schedule(rules),
        root_bound(root_maximum) {}
};

/// A ray on its way: what a context of the traverse unit holds.
template <class A, class G>
struct RayState {
  using Time = typename A::Time;
  typename A::PlaneTime x, y, z;
  G gx, gy;
  Time t_cur, t_start, t_max;
  Time t_root;           ///< rising: when the ray passes the map's maximum
  int32_t level;         ///< of the node to visit next
  int32_t down;          ///< levels per descent: the schedule's, 1 after the first crossing
  int32_t last_crossed;  ///< level of the previous step if that was a crossing, else -1
  uint32_t steps;
  int64_t end_x = 0, end_y = 0;  ///< kSpan, kDownCommon: the leaf cell where the ray must have ended
  bool rising;
  HitFace face;    ///< after a hit
  Time t_hit = 0;  ///< after a hit
};

namespace traversal_detail {

/// Left the map, past t_max, or rising above everything: checked before each visit, costs no step.
template <class A, class G>
Visit before_visit(const Walk<A, G>& walk, const RayState<A, G>& ray) {
  if (ray.t_cur >= ray.t_max) return Visit::kMiss;
  if (ray.rising && ray.t_root <= ray.t_cur) return Visit::kMiss;
  if (walk.map.address_mode == AddressMode::kBorder &&
      (ray.gx.outside(walk.x, ray.level) || ray.gy.outside(walk.y, ray.level))) {
    return Visit::kMiss;
  }
  return Visit::kContinue;
}

/// The leaf cell where the ray must have ended: it steers which nodes are looked at, never the hit.
template <class A, class G>
void set_end_cell(const Walk<A, G>& walk, RayState<A, G>& ray, const MachineRay& input, int64_t origin_x,
                  int64_t origin_y, int64_t cell_x, int64_t cell_y) {
  using Time = typename A::Time;
  const MapShape& map = walk.map;
  Time t_end = ray.t_max;
  if (input.dz < 0) t_end = std::min(t_end, A::at(ray.z, 0));
  if (ray.rising) t_end = std::min(t_end, ray.t_root);
  t_end = std::max(t_end, ray.t_start);
  const bool border = map.address_mode == AddressMode::kBorder;
  auto end_cell = [&](const auto& line, int64_t origin, int64_t d, int64_t start, const AxisMap& axis) {
    if (d == 0) return start;
    const bool unlimited = A::is_infinite(t_end, walk.format);
    if (border && (unlimited || A::at(line, axis.size) <= t_end)) return axis.size - 1;
    if (unlimited) return start + axis.padded;  // another tile
    return A::cell_at(line, origin, d, t_end, walk.format);
  };
  ray.end_x = end_cell(ray.x, origin_x, input.dx < 0 ? -input.dx : input.dx, cell_x, walk.x);
  ray.end_y = end_cell(ray.y, origin_y, input.dy < 0 ? -input.dy : input.dy, cell_y, walk.y);
}

/// The ray, just gone down one level at time `t`, goes on down while the child it is in holds the end cell.
template <class A, class G>
void descend_to_common(const Walk<A, G>& walk, RayState<A, G>& ray, typename A::Time t) {
  while (ray.level > walk.schedule.stop_level) {
    G x = ray.gx, y = ray.gy;
    x.descend(A::at(ray.x, x.middle_plane(walk.x, ray.level)) <= t);
    y.descend(A::at(ray.y, y.middle_plane(walk.y, ray.level)) <= t);
    if (!x.holds(walk.x, ray.level - 1, ray.end_x) || !y.holds(walk.y, ray.level - 1, ray.end_y)) return;
    ray.gx = x;
    ray.gy = y;
    --ray.level;
  }
}

}  // namespace traversal_detail

/// ray_setup: clips to slab and map, makes the three plane times, finds the start cell and level. kMiss: dead at
/// set-up, 0 steps.
template <class A, class G>
Visit start(const Walk<A, G>& walk, const MachineRay& input, RayState<A, G>& ray) {
  using Time = typename A::Time;
  const int f = walk.format.number.fraction_bits;
  ray.steps = 0;
  ray.last_crossed = -1;
  ray.down = walk.schedule.down;
  ray.face = HitFace::kNone;
  if (input.dead) return Visit::kMiss;
  const bool flip_x = input.dx < 0, flip_y = input.dy < 0;
  const int64_t dx = flip_x ? -input.dx : input.dx, dy = flip_y ? -input.dy : input.dy;
  const int64_t x0 = flip_x ? (walk.x.size << f) - input.x0 : input.x0;
  const int64_t y0 = flip_y ? (walk.y.size << f) - input.y0 : input.y0;
  ray.x = A::plane_time(x0, dx, walk.format);
  ray.y = A::plane_time(y0, dy, walk.format);
  ray.z = A::height_time(input.z0, input.dz, walk.format);
  ray.rising = input.dz > 0;
  ray.t_max = A::limit(input, walk.format);
  ray.t_root = A::at(ray.z, walk.root_bound);

  Time t_start = 0;
  if (input.dz < 0) t_start = std::max(t_start, A::at(ray.z, walk.map.full_scale()));
  if (walk.map.address_mode == AddressMode::kBorder) {
    t_start = std::max(t_start, std::max(A::at(ray.x, 0), A::at(ray.y, 0)));
    if (!(t_start < std::min(A::at(ray.x, walk.x.size), A::at(ray.y, walk.y.size)))) return Visit::kMiss;
    if (input.dz < 0 && !(t_start <= A::at(ray.z, 0))) return Visit::kMiss;
  }
  ray.t_start = ray.t_cur = t_start;
  if (t_start >= ray.t_max || (ray.rising && ray.t_root <= t_start)) return Visit::kMiss;

  const int64_t cell_x = A::cell_at(ray.x, x0, dx, t_start, walk.format);
  const int64_t cell_y = A::cell_at(ray.y, y0, dy, t_start, walk.format);
  ray.level = walk.map.root_level;
  if (walk.schedule.start == StartRule::kLeaf) ray.level = walk.schedule.stop_level;
  const bool span = walk.schedule.start == StartRule::kSpan;
  if (span || walk.schedule.down == kDownCommon) {
    traversal_detail::set_end_cell(walk, ray, input, x0, y0, cell_x, cell_y);
  }
  if (span) {
    ray.level = std::max({walk.schedule.stop_level, G::common_level(walk.x, cell_x, ray.end_x, flip_x),
                          G::common_level(walk.y, cell_y, ray.end_y, flip_y)});
  }
  ray.gx.start(walk.x, cell_x, flip_x);
  ray.gy.start(walk.y, cell_y, flip_y);
  ray.gx.go_to_level(ray.level);
  ray.gy.go_to_level(ray.level);
  return Visit::kContinue;
}

namespace traversal_detail {

/// The leaf's answer: a function of ray and cell, never of t_cur. True: `t_hit` and `face` are set.
template <class A, class G>
bool leaf_is_hit(const Walk<A, G>& walk, RayState<A, G>& ray, typename A::Time t_z, typename A::Time t_out) {
  using Time = typename A::Time;
  const Time in_x = A::at(ray.x, ray.gx.enter_plane(walk.x, ray.level));
  const Time in_y = A::at(ray.y, ray.gy.enter_plane(walk.y, ray.level));
  const Time later = std::max(in_x, in_y);
  const Time t_in = std::max(ray.t_start, later);
  const Time t_hit = ray.rising ? t_in : std::max(t_in, t_z);
  if (!(t_hit < std::min(t_out, ray.t_max)) || (ray.rising && !(t_in < t_z))) return false;
  ray.t_hit = t_hit;
  if (!ray.rising && t_z >= t_in) {
    ray.face = HitFace::kTop;
  } else if (later >= ray.t_start) {
    ray.face = in_x >= in_y ? HitFace::kWallX : HitFace::kWallY;
  } else {
    ray.face = HitFace::kInside;
  }
  return true;
}

/// The neighbour that the ray has just crossed into, tested with the bound of the node it came from.
template <class A, class G>
bool neighbour_is_skipped(const Walk<A, G>& walk, const RayState<A, G>& ray, typename A::Time t_out,
                          typename A::Time t_z) {
  const auto next_out = std::min(A::at(ray.x, ray.gx.exit_plane(walk.x, ray.level)),
                                 A::at(ray.y, ray.gy.exit_plane(walk.y, ray.level)));
  return ray.rising | !(std::max(t_out, t_z) < next_out);
}

/// Whether a ray that has crossed on `ray.level` goes up; gx, gy are the new indices.
template <class A, class G>
bool goes_up(const Walk<A, G>& walk, const RayState<A, G>& ray, bool cross_x, bool cross_y,
             typename A::Time t_out, typename A::Time t_z) {
  const bool even_x = ray.gx.index_is_even(), even_y = ray.gy.index_is_even();
  const bool even_axis = (cross_x & even_x) | (cross_y & even_y);
  switch (walk.schedule.up) {
    case UpRule::kNever:
      return false;
    case UpRule::kAlways:
      return true;
    case UpRule::kInterval:
      return ray.level % 2 == 0;
    case UpRule::kEvenAxis:
      return even_axis;
    case UpRule::kBothEven:
      return even_x & even_y;
    case UpRule::kSelective:
      return neighbour_is_skipped(walk, ray, t_out, t_z);
    case UpRule::kSelectiveEven:
      return even_axis & neighbour_is_skipped(walk, ray, t_out, t_z);
    case UpRule::kCoherent:
      return ray.last_crossed == ray.level;
  }
  return false;
}

}  // namespace traversal_detail

/// One step: the ray, standing before node (ray.level, ray.gx, ray.gy), learns the node's bound and hits, descends or
/// crosses. A leaf answers by `leaf_is_hit(t_z, t_out)`: when the ray reaches the bound, when it leaves the leaf; true:
/// `t_hit` and `face` are set.
/// Crossing or descending is as good as random to a branch predictor: both are computed and one is selected.
template <class A, class G, class LeafIsHit>
inline Visit visit_with(const Walk<A, G>& walk, RayState<A, G>& ray, int64_t bound, LeafIsHit&& leaf_is_hit) {
  using Time = typename A::Time;
  const int level = ray.level;
  const int stop_level = walk.schedule.stop_level;
  ++ray.steps;
  const Time t_x = A::at(ray.x, ray.gx.exit_plane(walk.x, level));
  const Time t_y = A::at(ray.y, ray.gy.exit_plane(walk.y, level));
  const Time t_out = std::min(t_x, t_y);
  const Time t_z = A::at(ray.z, bound);
  const bool leaf = level == stop_level;
  if (leaf & (ray.rising | (t_z < t_out))) {
    if (leaf_is_hit(t_z, t_out)) return Visit::kHit;
  }
  const Time reached = ray.rising ? ray.t_cur : std::max(ray.t_cur, t_z);
  const bool skip = leaf | (ray.rising ? t_z <= ray.t_cur : !(reached < t_out));

  // Every axis whose plane lies at t_out advances (a corner is crossed diagonally).
  const bool cross_x = skip & (t_x == t_out), cross_y = skip & (t_y == t_out);
  const bool upper_x = A::at(ray.x, ray.gx.middle_plane(walk.x, level)) <= reached;
  const bool upper_y = A::at(ray.y, ray.gy.middle_plane(walk.y, level)) <= reached;
  ray.gx.move(walk.x, level, skip, cross_x, upper_x);
  ray.gy.move(walk.y, level, skip, cross_y, upper_y);
  ray.t_cur = skip ? t_out : reached;

  const bool up = (skip & (level < walk.map.root_level)) &
                  traversal_detail::goes_up(walk, ray, cross_x, cross_y, t_out, t_z);
  ray.gx.ascend(up);
  ray.gy.ascend(up);
  ray.level = level + static_cast<int>(up) - static_cast<int>(!skip);
  ray.last_crossed = skip ? level : -1;
  if (traversal_detail::before_visit(walk, ray) == Visit::kMiss) return Visit::kMiss;

  if (ray.down > 1) {
    if (skip) {
      ray.down = 1;
    } else if (ray.down == kDownCommon) {
      traversal_detail::descend_to_common(walk, ray, reached);
    } else {
      for (int left = std::min(ray.down, level - stop_level) - 1; left > 0; --left) {
        ray.gx.descend(A::at(ray.x, ray.gx.middle_plane(walk.x, ray.level)) <= reached);
        ray.gy.descend(A::at(ray.y, ray.gy.middle_plane(walk.y, ray.level)) <= reached);
        --ray.level;
      }
    }
  }
  return Visit::kContinue;
}

/// The same where leaves are constant texels and `bound`, at the stop level, is the texel.
template <class A, class G>
inline Visit visit(const Walk<A, G>& walk, RayState<A, G>& ray, int64_t bound) {
  using Time = typename A::Time;
  return visit_with(walk, ray, bound, [&](Time t_z, Time t_out) {
    return traversal_detail::leaf_is_hit(walk, ray, t_z, t_out);
  });
}

/// The record of a ray that has ended with `end`.
template <class A, class G>
HitRecord hit_record(const Walk<A, G>& walk, const RayState<A, G>& ray, uint64_t id, Visit end) {
  HitRecord record;
  record.ray_id = id;
  record.steps = ray.steps;
  if (end != Visit::kHit) return record;
  record.status = HitStatus::kHit;
  record.face = ray.face;
  record.stop_level = static_cast<uint8_t>(ray.level);
  record.i = static_cast<int32_t>(ray.gx.real_index(walk.x, ray.level));
  record.j = static_cast<int32_t>(ray.gy.real_index(walk.y, ray.level));
  record.t = A::bits(ray.t_hit);
  return record;
}

/// Traverses one ray to its end. `fetch(level, i, j)` gives the bound of a node (i, j: fetch indices).
template <class A, class G, class Fetch>
HitRecord traverse_ray(const Walk<A, G>& walk, const MachineRay& input, Fetch&& fetch) {
  RayState<A, G> ray;
  Visit state = start(walk, input, ray);
  while (state == Visit::kContinue) {
    state =
        visit(walk, ray,
              fetch(ray.level, ray.gx.fetch_index(walk.x, ray.level), ray.gy.fetch_index(walk.y, ray.level)));
  }
  return hit_record(walk, ray, input.id, state);
}

/// Calls `body.template operator()<A, G>()` with the arithmetic and the geometry that fit.
template <class Body>
decltype(auto) with_traversal_types(Arithmetic arithmetic, const MapShape& map, Body&& body) {
  auto with_geometry = [&]<class A>() -> decltype(auto) {
    if (map.address_mode == AddressMode::kMirror) return body.template operator()<A, MirrorAxis>();
    if (map.address_mode == AddressMode::kClamp) return body.template operator()<A, ClampAxis>();
    return map.is_square_power_of_two() ? body.template operator()<A, PlainAxis>()
                                        : body.template operator()<A, TiledAxis>();
  };
  switch (arithmetic) {
    case Arithmetic::kFloat:
      return with_geometry.template operator()<FloatArithmetic>();
    case Arithmetic::kDouble:
      return with_geometry.template operator()<DoubleArithmetic>();
    case Arithmetic::kFixed:
      break;
  }
  return with_geometry.template operator()<FixedArithmetic>();
}

}  // namespace cuesta
