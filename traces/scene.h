#pragma once

#include <cstdint>
#include <string>

#include "models/rays/machine_ray.h"
#include "traces/heightmaps/image_reader.h"
#include "traces/ray_sets.h"

namespace cuesta {

/// Arguments of `generate`; see models/heightmap/generator.h.
struct GeneratedHeights {
  std::string kind;           ///< empty: the heights come from an image
  int width = 0, height = 0;  ///< texels; 0: the kind's own
  int bits = 0;               ///< 0: the kind's own
  uint64_t seed = 1;
};

/// In world units: 1 is the width of a tile. x runs along u, y along v, z up from the slab's floor.
struct CameraSettings {
  bool by_angle = true;       ///< else by position and look_at
  double angle_degrees = 60;  ///< between the view and the surface's normal: 0 front, 88 grazing
  double turn_degrees = 0;    ///< of the camera around the normal; 0: u to the right
  double distance = 0;        ///< from the middle of the plane; 0: the plane's width fills a front view
  double position[3] = {0, 0, 0};
  double look_at[3] = {0, 0, 0};
  double fov_degrees = 45;  ///< over the picture's width
};

/// What is looked at, from where, in how many pixels.
struct Scene {
  std::string name;         ///< the file's name without folder and ending, unless it states one
  std::string description;  ///< one line; may be empty
  std::string origin;       ///< path of the file, or "built-in scene NAME"
  std::string text;         ///< the TOML as read
  HeightSource image;       ///< when `generated.kind` is empty; its path is already resolved
  GeneratedHeights generated;
  AddressMode address_mode = AddressMode::kWrap;
  Surface surface = Surface::kTexel;
  std::string surface_place;  ///< what says so, where a message begins: file, line and key, or the option
  double depth = 0.1;         ///< thickness of the slab in widths of a tile
  int tiles[2] = {1, 1};      ///< that the plane spans along u and v; 1, 1 in border mode
  CameraSettings camera;
  int width = 512, height = 512;  ///< pixels
  std::string rays_file;          ///< .rays or .csv in the place of camera and image; may be empty
  RaySet ray_set;                 ///< likewise; no kind: none. One of camera, file and set
};

/// Throws usage_error for a bilinear surface over a mirrored map. Not part of the reading, since a command line may
/// still change the surface.
void check_surface_kind(const Scene& scene);

/// Reads a scene file; check_surface_kind is the caller's. Throws usage_error with file, line, key, what was found and
/// what is accepted.
Scene load_scene(const std::string& path);

/// The same from a text; `origin` names it in messages, relative paths in it start at `folder`.
Scene parse_scene(const std::string& text, const std::string& origin, const std::string& folder);

}  // namespace cuesta
