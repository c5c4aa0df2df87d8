#pragma once

// The bodies of oracle.h's templates, from the reference's definitions alone: closed-form divisions where the
// traversal descends, real-frame spans where it counts offsets.

#include "models/oracle/oracle.h"

namespace cuesta {

/// t_start, or nothing for a ray that misses at set-up.
template <class Int>
std::optional<ExactTime<Int>> oracle_start(const ExactRay<Int>& ray, const MapShape& shape) {
  if (ray.dead) return std::nullopt;
  ExactTime<Int> start{Int(0), Int(1)};
  if (ray.z.sign < 0) start = later(start, ray.z.reaches(shape.full_scale()));
  if (shape.address_mode == AddressMode::kBorder) {
    start = later(start, later(ray.x.plane(0), ray.y.plane(0)));
    if (start >= earlier(ray.x.plane(shape.width), ray.y.plane(shape.height))) return std::nullopt;
    if (ray.z.sign < 0 && start > ray.z.reaches(0)) return std::nullopt;
  }
  if (start >= ray.t_max) return std::nullopt;
  return start;
}

/// What one constant cell answers, asked by itself. i, j and face are filled in when it is hit.
template <class Int>
OracleHit<Int> oracle_ask_cell(const ExactRay<Int>& ray, const OracleMap& map, const ExactTime<Int>& t_start,
                               const OracleSpan& u, const OracleSpan& v) {
  const ExactTime<Int> lower_x = ray.x.plane(u.lower), lower_y = ray.y.plane(v.lower);
  const ExactTime<Int> t_in = later(t_start, later(lower_x, lower_y));
  const ExactTime<Int> t_out = earlier(ray.x.plane(u.upper), ray.y.plane(v.upper));
  OracleHit<Int> answer;
  if (t_in >= t_out || t_in >= ray.t_max) return answer;
  const ExactTime<Int> surface =
      ray.z.reaches(map.values[static_cast<size_t>(v.stored) * map.width + u.stored]);
  bool top = false;
  answer.t = t_in;
  if (ray.z.sign > 0) {
    answer.hit = t_in < surface;
  } else {
    top = surface >= t_in;
    answer.t = later(t_in, surface);
    answer.hit = answer.t < t_out && answer.t < ray.t_max;
  }
  if (!answer.hit) return answer;
  answer.i = u.index;
  answer.j = v.index;
  answer.face = top                                 ? HitFace::kTop
                : later(lower_x, lower_y) < t_start ? HitFace::kInside
                : lower_x >= lower_y                ? HitFace::kWallX
                                                    : HitFace::kWallY;
  return answer;
}

/// From when on a walk need not go on: t_max, or a rising ray above every height.
template <class Int>
ExactTime<Int> oracle_end(const ExactRay<Int>& ray, const OracleMap& map) {
  return ray.z.sign > 0 ? earlier(ray.t_max, ray.z.reaches(map.highest)) : ray.t_max;
}

template <class Int>
OracleHit<Int> oracle_leaf_walk(const ExactRay<Int>& ray, const OracleMap& map) {
  OracleHit<Int> answer;
  const auto start = oracle_start(ray, map.shape);
  if (!start) return answer;
  const bool border = map.shape.address_mode == AddressMode::kBorder;
  const ExactTime<Int> end = oracle_end(ray, map);
  ExactTime<Int> now = *start;
  int64_t k = ray.x.cell_at(now), l = ray.y.cell_at(now);
  uint64_t visits = 0;
  while (now < end && !(border && (k >= map.shape.width || l >= map.shape.height))) {
    const OracleSpan u = oracle_span(k, ray.x.sign < 0, map.shape.width, map.level, map.shape.address_mode);
    const OracleSpan v = oracle_span(l, ray.y.sign < 0, map.shape.height, map.level, map.shape.address_mode);
    ++visits;
    answer = oracle_ask_cell(ray, map, *start, u, v);
    if (answer.hit) break;
    const ExactTime<Int> t_x = ray.x.plane(u.upper), t_y = ray.y.plane(v.upper);
    now = earlier(t_x, t_y);
    if (t_x == now) k = u.upper;
    if (t_y == now) l = v.upper;
  }
  answer.visits = visits;
  return answer;
}

template <class Int>
std::optional<OracleHit<Int>> oracle_brute_force(const ExactRay<Int>& ray, const OracleMap& map,
                                                 int64_t cell_limit) {
  OracleHit<Int> best;
  const auto start = oracle_start(ray, map.shape);
  if (!start) return best;
  const int w = map.shape.width, h = map.shape.height;
  int64_t k0 = 0, k1 = w - 1, l0 = 0, l1 = h - 1;
  if (map.shape.address_mode != AddressMode::kBorder) {  // clamp: whole widths of the map, like tiles
    ExactTime<Int> end = oracle_end(ray, map);
    if (ray.z.sign < 0) end = earlier(end, ray.z.reaches(0));
    end = later(end, *start);
    k0 = floor_divide<int64_t>(ray.x.cell_at(*start), w) * w;
    l0 = floor_divide<int64_t>(ray.y.cell_at(*start), h) * h;
    k1 = floor_divide<int64_t>(ray.x.cell_at(end), w) * w + w - 1;
    l1 = floor_divide<int64_t>(ray.y.cell_at(end), h) * h + h - 1;
  }
  if (k1 - k0 >= cell_limit || l1 - l0 >= cell_limit || (k1 - k0 + 1) * (l1 - l0 + 1) > cell_limit) {
    return std::nullopt;
  }
  OracleSpan u, v;
  for (int64_t l = l0; l <= l1; l = v.upper) {
    v = oracle_span(l, ray.y.sign < 0, h, map.level, map.shape.address_mode);
    for (int64_t k = k0; k <= k1; k = u.upper) {
      u = oracle_span(k, ray.x.sign < 0, w, map.level, map.shape.address_mode);
      const OracleHit<Int> answer = oracle_ask_cell(ray, map, *start, u, v);
      if (answer.hit && (!best.hit || answer.t < best.t)) best = answer;
    }
  }
  return best;
}

}  // namespace cuesta
