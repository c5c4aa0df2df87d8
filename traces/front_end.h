#pragma once

#include <optional>
#include <string>

#include "traces/ray_trace.h"
#include "traces/scene.h"

namespace cuesta {

/// A rectangle of pixels of the whole frame.
struct Crop {
  int x = 0, y = 0, width = 0, height = 0;
};

/// From "x,y,width,height". Throws usage_error for any other text, and for a rectangle without pixels.
Crop parse_crop(const std::string& text);

/// The rays of a scene over a map: one through the middle of each pixel whose
/// ray meets the slab, in the order of the pixels; its id is pixel_y * width + pixel_x. A ray starts where it
/// enters the slab over the plane: on z = 1, on a side, or at the camera inside; there its t is 0. Its t_max
/// ends it 1/128 texel before the plane's far edge, so that the machine's rounding never shows it the tile beyond; in
/// border mode the machine ends it. With a crop the rays and ids are those of the whole frame inside
/// the crop. A scene with a ray file or a ray set gives those rays.
/// Throws usage_error for a crop outside the frame or a camera below the slab's floor, input_error for a ray file,
/// Error(kIncomplete) when `watch` says stop.
RayTrace make_rays(const Scene& scene, const MapShape& map, const std::optional<Crop>& crop = {},
                   const RayWatch& watch = {});

/// How many rays a scene asks for, at most; 0 for a ray file, which says it itself.
uint64_t most_rays(const Scene& scene, const std::optional<Crop>& crop = {});

}  // namespace cuesta
