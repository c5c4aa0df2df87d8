#include "sim/session/job.h"

#include <unistd.h>

#include <filesystem>

#include "models/common/digest.h"
#include "models/common/error.h"
#include "models/rays/hit.h"
#include "sim/config/on_architecture.h"
#include "traces/heightmaps/height_source_text.h"
#include "traces/scene_heights.h"
#include "traces/scene_library.h"

namespace cuesta {
namespace {

namespace fs = std::filesystem;

std::string sha256_of_text(const std::string& text) {
  Digest digest;
  digest.bytes(std::as_bytes(std::span(text)));
  return digest.hex();
}

void use_heightmap(const std::string& heightmap, Scene& scene) {
  scene.image = parse_height_source(heightmap);
  scene.generated = {};
  scene.name = fs::path(scene.image.path).stem().string();
}

void apply_changes(const SceneChanges& changes, Scene& scene) {
  if (!changes.heightmap.empty()) use_heightmap(changes.heightmap, scene);
  if (!changes.rays_file.empty()) {
    scene.rays_file = changes.rays_file;
    scene.ray_set = {};
  }
  const bool camera = changes.angle_degrees || changes.size;
  if (camera && !(scene.rays_file.empty() && scene.ray_set.kind.empty())) {
    const std::string given = !changes.size            ? "--angle says"
                              : !changes.angle_degrees ? "--size says"
                                                       : "--angle and --size say";
    throw usage_error(given + " how the camera makes rays, and the rays come from " +
                      (scene.rays_file.empty() ? "the set " + scene.ray_set.kind : scene.rays_file) +
                      "; accepted is one of the two.");
  }
  if (changes.angle_degrees) {
    if (!scene.camera.by_angle) {
      throw usage_error("--angle turns a camera that is given by its angle, and " + scene.origin +
                        " gives its camera by position.");
    }
    scene.camera.angle_degrees = *changes.angle_degrees;
  }
  if (changes.depth) scene.depth = *changes.depth;
  if (changes.surface) {
    scene.surface = *changes.surface;
    scene.surface_place = "--surface ";
  }
  check_surface_kind(scene);
  if (changes.size) {
    scene.width = changes.size->first;
    scene.height = changes.size->second;
    const std::string fault =
        fault_of_grid(static_cast<uint64_t>(scene.width), static_cast<uint64_t>(scene.height));
    if (!fault.empty()) throw usage_error("--size makes " + fault + ".");
  }
}

HeightGrid load_grid(Job& job, const SizeCheck& before) {
  const Scene& scene = job.scene;
  LoadedHeights loaded = heights_of(scene, before);
  if (!scene.generated.kind.empty()) {
    job.heights_statement =
        "generated " + scene.generated.kind + ", seed " + std::to_string(scene.generated.seed);
  } else {
    job.inputs.push_back({"heightmap", scene.image.path, sha256_of_file(scene.image.path)});
    job.heights_statement = scene.image.path + ", channel " + loaded.statement.channel;
    if (scene.image.invert) job.heights_statement += ", depth turned over";
    if (loaded.statement.nodata_cells > 0) {
      job.heights_statement +=
          ", " + std::to_string(loaded.statement.nodata_cells) + " cells without data at 0";
    }
  }
  HeightGrid grid = std::move(loaded.grid);
  job.heights_statement += ": " + std::to_string(grid.width) + " x " + std::to_string(grid.height) +
                           " texels, " + std::to_string(grid.bits) + " bits";
  return grid;
}

struct MemoryNeed {
  uint64_t rays = 0, pixels = 0;
  int map_width = 0, map_height = 0;  ///< 0: not known yet
};

/// What cannot fit is refused in a sentence, before the system ends the program without one.
void check_memory(const MemoryNeed& need) {
  constexpr uint64_t kPerRay =
      sizeof(TracedRay) + sizeof(MachineRay) + sizeof(HitRecord) + 96;  // 96: times, owner
  constexpr uint64_t kPerPixel = 32;                                    // planes
  const bool with_map = need.map_width > 0;
  const uint64_t map_bytes =
      with_map ? sizeof(uint16_t) * pyramid_storage(need.map_width, need.map_height) : 0;
  const uint64_t needed = need.rays * kPerRay + need.pixels * kPerPixel + map_bytes;
  const uint64_t there =
      static_cast<uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
  if (needed <= there) return;
  constexpr uint64_t kGiB = uint64_t{1} << 30;
  const std::string map = with_map ? " and the pyramid of a map of " + std::to_string(need.map_width) +
                                         " x " + std::to_string(need.map_height) + " texels"
                                   : "";
  throw Error(ExitCode::kResource, std::to_string(need.rays) + " rays over " + std::to_string(need.pixels) +
                                       " pixels" + map + " need about " + std::to_string(needed / kGiB + 1) +
                                       " GiB of memory, and this host has " + std::to_string(there / kGiB) +
                                       "; a smaller --size or a --crop needs less.");
}

}  // namespace

Scene changed_scene(const std::string& scene_name_or_path, const SceneChanges& changes) {
  Scene scene = find_scene(scene_name_or_path);
  apply_changes(changes, scene);
  return scene;
}

Job prepare_job(const std::string& scene_name_or_path, const SceneChanges& changes, const RayWatch& watch) {
  Job job;
  job.scene = changed_scene(scene_name_or_path, changes);
  const Scene& scene = job.scene;
  job.inputs.push_back({"scene", scene.origin, sha256_of_text(scene.text)});
  MemoryNeed need;
  if (scene.rays_file.empty()) {
    need.rays = most_rays(scene, changes.crop);
    need.pixels = most_rays(scene);
    check_memory(need);
  }

  job.pyramid = build_max_pyramid(load_grid(job, [&](int map_width, int map_height) {
    need.map_width = map_width;
    need.map_height = map_height;
    check_memory(need);
  }));
  job.map = {job.pyramid.width(0), job.pyramid.height(0), job.pyramid.root_level(),
             job.pyramid.bits(),   scene.address_mode,    scene.surface};
  if (scene.surface == Surface::kBilinear) {
    job.pyramid = build_four_corner_pyramid(std::move(job.pyramid), scene.address_mode == AddressMode::kWrap);
    job.heights_statement += ", bilinear between their middles";
  }

  job.trace = make_rays(scene, job.map, changes.crop, watch);
  if (!scene.rays_file.empty()) {
    job.inputs.push_back({"rays", scene.rays_file, sha256_of_file(scene.rays_file)});
    need.rays = job.trace.rays.size();
    need.pixels = static_cast<uint64_t>(job.trace.width) * static_cast<uint64_t>(job.trace.height);
    check_memory(need);
  }
  if (job.trace.rays.empty()) {
    throw input_error(scene.rays_file.empty()
                          ? "No ray of scene " + scene.name +
                                " meets the surface: nothing to run; turn the camera, or widen the crop."
                          : "The file of rays " + scene.rays_file + " holds none: nothing to run.");
  }
  job.pixel_of_ray.reserve(job.trace.rays.size());
  for (const TracedRay& ray : job.trace.rays) {
    job.pixel_of_ray.push_back(ray.pixel_y * static_cast<uint32_t>(job.trace.width) + ray.pixel_x);
  }
  return job;
}

Job watched_job(const std::string& scene_name_or_path, const SceneChanges& changes, Observer& observer) {
  Stage stage(observer, "making rays", "rays", 0);
  return prepare_job(scene_name_or_path, changes, [&](uint64_t finished) { return stage.update(finished); });
}

std::vector<MachineRay> machine_rays(const Job& job, const NumberFormat& format) {
  std::vector<MachineRay> rays;
  rays.reserve(job.trace.rays.size());
  for (const TracedRay& ray : job.trace.rays) rays.push_back(quantise(ray, job.map, format));
  return rays;
}

Workload workload_of(const Job& job, const Architecture& architecture, std::span<const MachineRay> rays,
                     const Algorithm& algorithm, const SearchMap* map) {
  Workload work;
  work.pyramid = &job.pyramid;
  work.map = job.map;
  set_numbers(work, architecture);
  work.rays = rays;
  work.pixel_of_ray = job.pixel_of_ray;
  work.width = job.trace.width;
  work.height = job.trace.height;
  work.schedule = algorithm.schedule;
  work.search = algorithm.search;
  work.search_map = map;
  work.depth = job.scene.depth;
  return work;
}

}  // namespace cuesta
