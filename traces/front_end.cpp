#include "traces/front_end.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "models/common/error.h"
#include "models/common/words.h"
#include "traces/camera.h"
#include "traces/ray_files.h"
#include "traces/slab.h"

namespace cuesta {
namespace {

Crop checked(const std::optional<Crop>& crop, int width, int height) {
  if (!crop) return {0, 0, width, height};
  // In 64 bits: a crop may state any numbers.
  if (crop->x < 0 || crop->y < 0 || crop->width < 1 || crop->height < 1 ||
      int64_t{crop->x} + crop->width > width || int64_t{crop->y} + crop->height > height) {
    throw usage_error("The crop of " + std::to_string(crop->width) + " x " + std::to_string(crop->height) +
                      " pixels at (" + std::to_string(crop->x) + ", " + std::to_string(crop->y) +
                      ") does not lie inside the frame of " + std::to_string(width) + " x " +
                      std::to_string(height) + " pixels.");
  }
  return *crop;
}

/// How world units become tile units, and a pixel's number a direction in them.
struct Pixels {
  Pixels(const Camera& camera, const Scene& scene, const double (&scale)[3]) {
    const double step = 2 * camera.half_width / scene.width;
    const double left = -camera.half_width;
    const double top = camera.half_width * scene.height / scene.width;
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = camera.position[axis] * scale[axis];
      corner[axis] = (camera.forward[axis] + left * camera.right[axis] + top * camera.up[axis]) * scale[axis];
      right[axis] = step * camera.right[axis] * scale[axis];
      down[axis] = -step * camera.up[axis] * scale[axis];
    }
  }
  void direction(int x, int y, double (&direction)[3]) const {
    for (int axis = 0; axis < 3; ++axis) {
      direction[axis] = corner[axis] + (x + 0.5) * right[axis] + (y + 0.5) * down[axis];
    }
  }
  double origin[3], corner[3];
  double right[3], down[3];  ///< of the direction, per pixel
};

/// How u and v, where the ray meets the plane z = 1 (from inside the slab: z = 0), change per pixel to the right and
/// down: the derivative of origin + s * direction with s = (z - origin_z) / direction_z. Zero for rays that never
/// meet it.
void set_gradient(const Pixels& pixels, const double (&direction)[3], float (&gradient)[4]) {
  if (direction[2] >= 0) return;
  const double plane = pixels.origin[2] >= 1 ? 1 : 0;
  const double s = (plane - pixels.origin[2]) / direction[2];
  const auto derivative = [&](const double(&change)[3], int axis) {
    const double value = s * (change[axis] - direction[axis] * (change[2] / direction[2]));
    constexpr double kMost = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -kMost, kMost));
  };
  gradient[0] = derivative(pixels.right, 0);
  gradient[1] = derivative(pixels.right, 1);
  gradient[2] = derivative(pixels.down, 0);
  gradient[3] = derivative(pixels.down, 1);
}

RayTrace cropped(RayTrace trace, const std::optional<Crop>& crop) {
  if (!crop) return trace;
  const Crop area = checked(crop, trace.width, trace.height);
  std::erase_if(trace.rays, [&](const TracedRay& ray) {
    return static_cast<int>(ray.pixel_x) < area.x || static_cast<int>(ray.pixel_x) >= area.x + area.width ||
           static_cast<int>(ray.pixel_y) < area.y || static_cast<int>(ray.pixel_y) >= area.y + area.height;
  });
  return trace;
}

}  // namespace

Crop parse_crop(const std::string& text) {
  int numbers[4] = {0, 0, 0, 0};
  const char* next = text.data();
  const char* end = next + text.size();
  bool good = true;
  for (int k = 0; good && k < 4; ++k) {
    const auto [after, error] = std::from_chars(next, end, numbers[k]);
    good = error == std::errc() && numbers[k] >= (k < 2 ? 0 : 1) &&
           (k < 3 ? after != end && *after == ',' : after == end);
    next = after + 1;
  }
  if (!good) {
    throw usage_error(
        "The crop is `" + printable(text) +
        "`; accepted: x,y,width,height in whole pixels, such as 100,50,64,64, with x and y >= 0, width "
        "and height >= 1.");
  }
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

uint64_t most_rays(const Scene& scene, const std::optional<Crop>& crop) {
  if (!scene.rays_file.empty()) return 0;
  if (!scene.ray_set.kind.empty()) return scene.ray_set.count;
  const auto product = [](int a, int b) { return static_cast<uint64_t>(a) * static_cast<uint64_t>(b); };
  const uint64_t pixels = product(scene.width, scene.height);
  return crop ? std::min(pixels, product(crop->width, crop->height)) : pixels;
}

RayTrace make_rays(const Scene& scene, const MapShape& map, const std::optional<Crop>& crop,
                   const RayWatch& watch) {
  if (!scene.rays_file.empty()) return cropped(read_ray_file(scene.rays_file, watch), crop);
  if (!scene.ray_set.kind.empty()) return cropped(make_ray_set(scene.ray_set, map, watch), crop);
  const double tile_height = static_cast<double>(map.height) / map.width;
  const double scale[3] = {1, 1 / tile_height, 1 / scene.depth};
  const Camera camera = make_camera(scene, tile_height);
  if (camera.position[2] < 0) {
    throw usage_error(scene.origin + ": the camera is below the slab's floor, at z = " +
                      shortest_text(camera.position[2]) + "; accepted: z >= 0.");
  }
  const Pixels pixels(camera, scene, scale);
  const Slab slab{static_cast<double>(scene.tiles[0]), static_cast<double>(scene.tiles[1]),
                  scene.address_mode != AddressMode::kBorder, 1.0 / 128 / map.width, 1.0 / 128 / map.height};
  const Crop area = checked(crop, scene.width, scene.height);
  RayTrace trace{scene.width, scene.height, {}};
  for (int y = area.y; y < area.y + area.height; ++y) {
    keep_watch(watch, trace.rays.size());
    for (int x = area.x; x < area.x + area.width; ++x) {
      TracedRay ray;
      std::copy(std::begin(pixels.origin), std::end(pixels.origin), ray.origin);
      pixels.direction(x, y, ray.direction);
      if (!slab.enter(ray)) continue;
      ray.id = static_cast<uint64_t>(y) * static_cast<uint64_t>(scene.width) + static_cast<uint64_t>(x);
      ray.pixel_x = static_cast<uint32_t>(x);
      ray.pixel_y = static_cast<uint32_t>(y);
      set_gradient(pixels, ray.direction, ray.gradient);
      trace.rays.push_back(ray);
    }
  }
  return trace;
}

}  // namespace cuesta
