#include "models/common/elementary.h"
#include "traces/ray_set_makers.h"

namespace cuesta {
namespace {

/// One ray in eight ends somewhere, most before the slab does.
void end_some(Random& random, TracedRay& ray) {
  if (random.chance(0.125)) ray.t_max = random.unit() * 2;
}

}  // namespace

void make_random_ray(Random& random, const RaySetPlace& place, int, TracedRay& ray) {
  double square = 0;
  while (!(square > 1e-6 && square <= 1)) {  // a point of the ball: all directions alike
    square = 0;
    for (double& value : ray.direction) {
      value = uniform(random, -1, 1);
      square += value * value;
    }
  }
  start_in_slab(random, place, ray);
  end_some(random, ray);
}

void make_stratified_ray(Random& random, const RaySetPlace& place, int ray_class, TracedRay& ray) {
  struct Range {
    double low, high;
  };
  static constexpr Range kDegrees[] = {{0, 30}, {30, 60}, {60, 80}, {80, 89}, {89, 89.99}};
  static constexpr double kDepths[] = {0.05, 0.35, 1};
  const double azimuth = elementary::radians(uniform(random, 0, 360));
  const double depth = kDepths[random.below(3)];
  double sine = 1, height = 0;
  if (ray_class != 5) {
    const Range range = kDegrees[ray_class < 5 ? ray_class : ray_class - 6];
    const double angle = elementary::radians(uniform(random, range.low, range.high));
    sine = elementary::sin(angle);
    height = (ray_class < 5 ? -1 : 1) * elementary::cos(angle) / depth;
  }
  ray.direction[0] = sine * elementary::cos(azimuth);
  ray.direction[1] = sine * elementary::sin(azimuth);
  ray.direction[2] = height;
  start_in_slab(random, place, ray);
  end_some(random, ray);
}

}  // namespace cuesta
