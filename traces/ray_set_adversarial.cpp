#include <algorithm>

#include "traces/ray_set_makers.h"

namespace cuesta {
namespace {

/// In the order of the names in ray_sets.cpp.
enum HardCase { kAxis, kCorner, kEdge, kGrazing, kHorizontal, kRising, kDown, kSide, kInside, kFar };

double sign(Random& random) { return random.chance(0.5) ? 1 : -1; }

/// Between 10^-high and 10^-low, decades alike; by division alone, so that every host gives the same bits.
double power_of_tenth(Random& random, int low, int high) {
  double value = uniform(random, 1, 10) / 10;
  for (int64_t k = random.between(low, high - 1); k > 0; --k) value /= 10;
  return value;
}

/// A whole texel plane, or (one in four) a texel's middle, of the tile, in tile units.
double plane(Random& random, int64_t texels) {
  const bool middle = random.chance(0.25);
  return static_cast<double>(2 * random.between(0, texels - 1) + (middle ? 1 : 0)) /
         static_cast<double>(2 * texels);
}

/// A whole height, full scale now and then.
double whole_height(Random& random, const MapShape& map) {
  if (random.chance(0.2)) return 1;
  return static_cast<double>(random.between(0, map.full_scale())) / static_cast<double>(map.full_scale());
}

void set_direction(TracedRay& ray, double u, double v, double z) {
  ray.direction[0] = u;
  ray.direction[1] = v;
  ray.direction[2] = z;
}

/// `slope` in heights of the slab per tile of the longer one of u and v.
void set_slope(Random& random, double slope, TracedRay& ray) {
  const double along = sign(random), across = uniform(random, -1, 1);
  if (random.chance(0.5)) {
    set_direction(ray, along, across, slope);
  } else {
    set_direction(ray, across, along, slope);
  }
}

void along_one_axis(Random& random, double slope, TracedRay& ray) {
  const double along = sign(random);
  set_direction(ray, 0, 0, slope);
  ray.direction[random.below(2)] = along;
}

/// Through corners: the start is one, the direction a small whole number of texels and heights.
void aim_at_corners(Random& random, const MapShape& map, TracedRay& ray) {
  const double size[3] = {static_cast<double>(map.width), static_cast<double>(map.height),
                          static_cast<double>(map.full_scale())};
  const int64_t most = random.chance(0.5) ? 1 : 4;  // half of them along the diagonal
  for (int axis = 0; axis < 2; ++axis) {
    ray.origin[axis] =
        static_cast<double>(random.between(0, static_cast<int64_t>(size[axis]) - 1)) / size[axis];
    ray.direction[axis] = sign(random) * static_cast<double>(random.between(1, most)) / size[axis];
  }
  ray.direction[2] = -static_cast<double>(random.between(0, 8)) / size[2];
}

/// Onto a side of the tile, or up to a tile before it, below the top, looking in.
void start_at_side(Random& random, const RaySetPlace& place, TracedRay& ray) {
  const size_t axis = random.below(2);
  const bool low = random.chance(0.5);
  const double before = place.tiles > 1 && random.chance(0.5) ? random.unit() : 0;
  ray.origin[axis] = low ? -before : 1 + before;
  ray.origin[1 - axis] = random.unit();
  set_slope(random, sign(random) * random.unit(), ray);
  ray.direction[axis] = low ? 1 : -1;
}

/// As many tiles as the machine's coordinates hold, along one axis and flat enough to cross them all.
void cross_most_tiles(Random& random, const RaySetPlace& place, TracedRay& ray) {
  const double most = static_cast<double>(place.tiles - 1);
  const bool border = place.map.address_mode == AddressMode::kBorder;
  const size_t axis = random.below(2);
  const double way = sign(random);
  const double slope = 1 / static_cast<double>(2 * place.tiles);
  set_direction(ray, 0, 0, -slope * random.unit());
  ray.direction[axis] = way;
  ray.direction[1 - axis] =
      random.chance(0.5) ? 0 : uniform(random, -1, 1) / static_cast<double>(place.tiles);
  // Against the border the map is met from afar; where it repeats, rays start at both ends and in between.
  const double start = border || random.chance(0.5) ? most : uniform(random, -most, most);
  ray.origin[axis] = -way * start + (start < most ? random.unit() : 0);
  ray.origin[1 - axis] = random.unit();
}

}  // namespace

void make_adversarial_ray(Random& random, const RaySetPlace& place, int ray_class, TracedRay& ray) {
  const MapShape& map = place.map;
  const bool on_planes = random.chance(0.5);
  ray.origin[0] = on_planes ? plane(random, map.width) : random.unit();
  ray.origin[1] = on_planes ? plane(random, map.height) : random.unit();
  ray.origin[2] = whole_height(random, map);
  switch (static_cast<HardCase>(ray_class)) {
    case kAxis:
      along_one_axis(random, -4 * random.unit(), ray);
      break;
    case kCorner:
      aim_at_corners(random, map, ray);
      break;
    case kEdge:
      along_one_axis(random, -random.unit(), ray);
      for (int axis = 0; axis < 2; ++axis) {
        const int64_t texels = axis == 0 ? map.width : map.height;
        if (ray.direction[axis] != 0) continue;
        ray.origin[axis] = static_cast<double>(random.between(0, texels - 1)) / static_cast<double>(texels);
      }
      break;
    case kGrazing:
      set_slope(random, -power_of_tenth(random, 2, 6), ray);
      break;
    case kHorizontal:
      set_slope(random, 0, ray);
      break;
    case kRising:
      set_slope(random, random.chance(0.5) ? 4 * random.unit() : power_of_tenth(random, 0, 6), ray);
      break;
    case kDown:
      set_direction(ray, 0, 0, -uniform(random, 0.5, 2));
      ray.origin[2] = random.chance(0.5) ? 1 : ray.origin[2];
      break;
    case kSide:
      start_at_side(random, place, ray);
      break;
    case kInside:
      set_slope(random, -4 * random.unit(), ray);
      ray.origin[2] = random.unit();
      if (random.chance(0.5)) ray.t_max = random.unit();
      break;
    case kFar:
      cross_most_tiles(random, place, ray);
      break;
  }
  if (ray.direction[0] == 0 && ray.direction[1] == 0 && ray.direction[2] == 0) ray.direction[2] = -1;
}

}  // namespace cuesta
