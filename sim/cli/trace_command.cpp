#include <cstdio>
#include <filesystem>

#include "models/rays/map_shape.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"
#include "sim/session/output_file.h"
#include "traces/front_end.h"
#include "traces/ray_files.h"
#include "traces/scene_heights.h"
#include "traces/scene_library.h"

namespace cuesta {
namespace {

class TraceCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("scene", scene_, "Scene file, or the name of a built-in scene").required();
    options.add("-o,--output", output_, "File to write: .rays, or .csv for text").required();
    options.add("--crop", crop_, "Only the pixels x,y,width,height; ids stay those of the whole frame");
    options.add_flag("--force", force_, "Replace a file of that name");
  }

  ExitCode run(const Session& session) override {
    check_ray_file_name(output_);
    refuse_existing(output_, force_);
    std::optional<Crop> crop;
    if (!crop_.empty()) crop = parse_crop(crop_);
    const Scene scene = find_scene(scene_);
    check_surface_kind(scene);
    const HeightGrid grid = heights_of(scene).grid;
    const MapShape map = map_shape(grid.width, grid.height, grid.bits, scene.address_mode);
    const RayTrace trace = make_rays(scene, map, crop, watched(session, "making", most_rays(scene, crop)));
    write_ray_file(output_, trace, watched(session, "writing", trace.rays.size()));
    if (!session.quiet) {
      std::fprintf(stderr, "%s: %zu rays for a frame of %d x %d pixels, %ju bytes.\n", output_.c_str(),
                   trace.rays.size(), trace.width, trace.height,
                   static_cast<uintmax_t>(std::filesystem::file_size(output_)));
    }
    return ExitCode::kOk;
  }

 private:
  std::string scene_, output_, crop_;
  bool force_ = false;
};

}  // namespace

std::unique_ptr<Command> make_trace_command() { return make_command<TraceCommand>(); }

}  // namespace cuesta
