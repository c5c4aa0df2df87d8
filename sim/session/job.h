#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "models/heightmap/pyramid.h"
#include "models/rays/machine_ray.h"
#include "models/units/architecture.h"
#include "models/work/workload.h"
#include "reports/result.h"
#include "sim/machine/machine.h"
#include "sim/session/progress.h"
#include "traces/front_end.h"
#include "traces/ray_trace.h"
#include "traces/scene.h"

namespace cuesta {

/// What a command line changes of a scene.
struct SceneChanges {
  std::string heightmap;  ///< an image, or image:channel; empty: the scene's own heights
  std::string rays_file;  ///< empty: the scene's own rays
  std::optional<double> angle_degrees;
  std::optional<double> depth;
  std::optional<Surface> surface;
  std::optional<std::pair<int, int>> size;  ///< pixels
  std::optional<Crop> crop;
};

/// A scene made ready for any machine: heights, pyramid, rays as traced. Its rays are the same for every algorithm
/// and architecture that is held against another.
struct Job {
  Scene scene;
  MapShape map;
  Pyramid pyramid;  ///< max; of a bilinear surface the four-corner pyramid
  RayTrace trace;
  std::vector<uint32_t> pixel_of_ray;  ///< y * width + x
  std::vector<Input> inputs;           ///< files that were read
  std::string heights_statement;       ///< one line: where the heights come from, size, bits
};

/// Finds a scene by name or path and changes it; reads no image and no rays. Throws usage_error.
Scene changed_scene(const std::string& scene_name_or_path, const SceneChanges& changes);

/// Changes a scene and makes it ready. Throws usage_error for the scene and for changes
/// that contradict it, input_error for images and ray files, Error(kResource) when it would not fit into memory,
/// Error(kIncomplete) when `watch` stops the making of rays.
Job prepare_job(const std::string& scene_name_or_path, const SceneChanges& changes,
                const RayWatch& watch = {});

/// Prepares a job as above with `observer` hearing of the making of rays.
Job watched_job(const std::string& scene_name_or_path, const SceneChanges& changes, Observer& observer);

/// A job's rays as they enter a machine with numbers of that format.
std::vector<MachineRay> machine_rays(const Job& job, const NumberFormat& format);

/// Makes the work of an algorithm over a job, in the architecture's numbers: `rays` of machine_rays; `map` what a
/// search reads, nullptr for a schedule. All of them must outlive the workload.
Workload workload_of(const Job& job, const Architecture& architecture, std::span<const MachineRay> rays,
                     const Algorithm& algorithm, const SearchMap* map = nullptr);

}  // namespace cuesta
