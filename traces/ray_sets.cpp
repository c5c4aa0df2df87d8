#include "traces/ray_sets.h"

#include <algorithm>

#include "models/common/elementary.h"
#include "models/common/error.h"
#include "models/common/random.h"
#include "traces/slab.h"

namespace cuesta {
namespace {

RayTrace grid_for(uint64_t count) {
  if (count > kMostPixels) {
    throw usage_error("A ray set of " + std::to_string(count) +
                      " rays was asked for; accepted: at most 2^28.");
  }
  const int width = static_cast<int>(std::clamp<uint64_t>(count, 1, 1024));
  RayTrace trace{width, static_cast<int>(std::max<uint64_t>((count + 1023) / 1024, 1)), {}};
  trace.rays.reserve(count);
  return trace;
}

void number(TracedRay& ray, uint64_t k, int width) {
  ray.id = k;
  ray.pixel_x = static_cast<uint32_t>(k % static_cast<uint64_t>(width));
  ray.pixel_y = static_cast<uint32_t>(k / static_cast<uint64_t>(width));
}

double between(Random& random, double low, double high) { return low + (high - low) * random.unit(); }

void set_direction(Random& random, int angle_class, TracedRay& ray) {
  struct Range {
    double low, high;
  };
  static constexpr Range kDegrees[] = {{0, 30}, {30, 60}, {60, 80}, {80, 89}, {89, 89.99}};
  static constexpr double kDepths[] = {0.05, 0.35, 1};
  const double azimuth = elementary::radians(between(random, 0, 360));
  const double depth = kDepths[random.below(3)];
  double sine = 1, height = 0;
  if (angle_class != 5) {
    const Range range = kDegrees[angle_class < 5 ? angle_class : angle_class - 5];
    const double angle = elementary::radians(between(random, range.low, range.high));
    sine = elementary::sin(angle);
    height = (angle_class < 5 ? -1 : 1) * elementary::cos(angle) / depth;
  }
  ray.direction[0] = sine * elementary::cos(azimuth);
  ray.direction[1] = sine * elementary::sin(azimuth);
  ray.direction[2] = height;
}

/// The ray passes through a random point of the tile's slab; one in four starts there, the others where they enter:
/// on top, on a side, or rising, on the floor. Descending rays start on top where sides mean nothing: not in border mode.
void set_origin(Random& random, AddressMode mode, TracedRay& ray) {
  for (double& value : ray.origin) value = between(random, 0.001, 0.999);
  const bool inside = random.chance(0.25);
  if (!inside && mode != AddressMode::kBorder && ray.direction[2] < 0) {
    ray.origin[2] = 1;
  } else if (!inside) {
    double largest = 0;
    for (double value : ray.direction) largest = std::max({largest, value, -value});
    for (int axis = 0; axis < 3; ++axis) ray.origin[axis] -= 2 / largest * ray.direction[axis];
    Slab{1, 1, false, 0, 0}.enter(ray);
  }
  if (mode == AddressMode::kBorder) return;
  for (int axis = 0; axis < 2; ++axis) ray.origin[axis] += static_cast<double>(random.between(-4, 3));
}

}  // namespace

RayTrace random_rays(const MapShape& map, uint64_t seed, uint64_t count) {
  RayTrace trace = grid_for(count);
  Random random(seed);
  for (uint64_t k = 0; k < count; ++k) {
    TracedRay ray;
    number(ray, k, trace.width);
    set_direction(random, static_cast<int>(k % 10), ray);
    set_origin(random, map.address_mode, ray);
    if (random.chance(0.125)) ray.t_max = random.unit() * 2;
    trace.rays.push_back(ray);
  }
  return trace;
}

RayTrace lattice_rays(const MapShape& map, uint64_t seed, uint64_t count) {
  RayTrace trace = grid_for(count);
  Random random(seed);
  const int64_t size[3] = {map.width, map.height, map.full_scale()};
  for (uint64_t k = 0; k < count; ++k) {
    TracedRay ray;
    number(ray, k, trace.width);
    // Directions in texels and height steps: zero in one component of two, else a small whole number, now and then
    // a power of two, so that rays run along axes, diagonals and through corners.
    int64_t step[3] = {0, 0, 0};
    while (step[0] == 0 && step[1] == 0 && step[2] == 0) {
      for (int64_t& value : step) {
        if (random.chance(0.4)) continue;
        value = random.chance(0.3) ? int64_t{1} << random.below(6) : random.between(1, 3);
        if (random.chance(0.5)) value = -value;
      }
      if (step[2] > 0 && random.chance(0.6)) step[2] = -step[2];
    }
    // Planes in halves, so that texel middles are among them.
    int64_t twice[3];
    for (int axis = 0; axis < 2; ++axis) {
      const uint64_t where = random.below(8);
      twice[axis] = where == 0   ? 0
                    : where == 1 ? 2 * size[axis]
                    : where == 2 ? random.between(0, 2 * size[axis])
                                 : 2 * random.between(0, size[axis]);
      const bool outside = where == 3;
      if (outside || map.address_mode != AddressMode::kBorder)
        twice[axis] += 2 * size[axis] * random.between(-1, 1);
    }
    twice[2] = random.chance(0.5) ? 2 * size[2] : 2 * random.between(0, size[2]);
    for (int axis = 0; axis < 3; ++axis) {
      const double unit = static_cast<double>(size[axis]);
      ray.origin[axis] = static_cast<double>(twice[axis]) / (2 * unit);
      ray.direction[axis] = static_cast<double>(step[axis]) / unit;
    }
    if (random.chance(0.25)) ray.t_max = static_cast<double>(random.between(0, 64));
    trace.rays.push_back(ray);
  }
  return trace;
}

}  // namespace cuesta
