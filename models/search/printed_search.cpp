#include "models/search/printed_search.h"

namespace cuesta {

PrintedRay make_printed_ray(const MachineRay& input, const MapShape& map, const NumberFormat& format) {
  const double unit = 1.0 / static_cast<double>(int64_t{1} << format.fraction_bits);
  const auto full = static_cast<double>(map.full_scale());
  const double down = -static_cast<double>(input.dz);
  const double rise = full - static_cast<double>(input.z0) * unit;  // back to the top plane, in height LSBs
  const auto x = static_cast<double>(input.dx) / down, y = static_cast<double>(input.dy) / down;
  const auto texture = [](double texels, int size) { return static_cast<float>(texels / size); };
  PrintedRay ray;
  ray.from = {texture(static_cast<double>(input.x0) * unit - x * rise, map.width),
              texture(static_cast<double>(input.y0) * unit - y * rise, map.height), 0};
  ray.along = {texture(x * full, map.width), texture(y * full, map.height), 1};
  ray.start = static_cast<float>(rise / full);
  return ray;
}

}  // namespace cuesta
