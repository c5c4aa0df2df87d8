#include <cstdio>

#include "models/common/words.h"
#include "models/rays/map_shape.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"
#include "sim/session/output_file.h"
#include "traces/ray_files.h"
#include "traces/ray_sets.h"
#include "traces/scene_heights.h"
#include "traces/scene_library.h"

namespace cuesta {
namespace {

class RaysMakeCommand : public Command {
 public:
  void declare(Options& options) override {
    std::string kinds = "What rays:";
    for (const RaySetKind& kind : ray_set_kinds()) {
      kinds += "\n" + std::string(kind.name) + ": " + std::string(kind.meaning);
      if (kind.classes.size() < 2) continue;
      kinds += " Ray k is of class k modulo " + std::to_string(kind.classes.size()) + ": " +
               joined(kind.classes) + ".";
    }
    options.add("kind", set_.kind, kinds).required();
    options.add("-o,--output", output_, "File to write: .rays, or .csv for text").required();
    options.add("--count", set_.count, "Rays: 1 to 2^28").with_default();
    options.add("--seed", set_.seed, "Another seed, other rays").with_default();
    options
        .add("--tile-bits", set_.tile_bits,
             "traverse.tile_bits of the machine that shall take them: no ray starts beyond 2^tile-bits tiles")
        .with_default();
    Option of_scene = options.add("--map-of", scene_, "For the map and address mode of this scene");
    for (const Option option : {
             options.add("--width", width_, "For a map of so many texels in u").with_default(),
             options.add("--height", height_, "For a map of so many texels in v").with_default(),
             options.add("--bits", bits_, "For heights of so many bits").with_default(),
             options.add("--address-mode", address_mode_, "For a map so continued, as in a scene")
                 .with_default(),
         }) {
      of_scene.excludes(option);
    }
    options.add_flag("--force", force_, "Replace a file of that name");
  }

  ExitCode run(const Session& session) override {
    check_ray_set(set_);
    check_ray_file_name(output_);
    refuse_existing(output_, force_);
    const RayTrace trace = make_ray_set(set_, map(), watched(session, "making", set_.count));
    write_ray_file(output_, trace, watched(session, "writing", set_.count));
    if (!session.quiet) {
      std::fprintf(stderr, "%s: %zu rays in a grid of %d x %d.\n", output_.c_str(), trace.rays.size(),
                   trace.width, trace.height);
    }
    return ExitCode::kOk;
  }

 private:
  MapShape map() const {
    if (!scene_.empty()) {
      const Scene scene = find_scene(scene_);
      const HeightGrid grid = heights_of(scene).grid;
      return map_shape(grid.width, grid.height, grid.bits, scene.address_mode);
    }
    // A scene says what is accepted.
    const std::string text = "[heightmap]\ngenerate = { kind = \"flat\", width = " + std::to_string(width_) +
                             ", height = " + std::to_string(height_) + ", bits = " + std::to_string(bits_) +
                             " }\naddress_mode = \"" + address_mode_ + "\"\n";
    const Scene scene = parse_scene(text, "--width, --height, --bits, --address-mode", "");
    return map_shape(width_, height_, bits_, scene.address_mode);
  }

  RaySet set_;
  std::string output_, scene_;
  std::string address_mode_ = "wrap";
  int width_ = 256, height_ = 256, bits_ = 8;
  bool force_ = false;
};

}  // namespace

std::unique_ptr<Command> make_rays_make_command() { return make_command<RaysMakeCommand>(); }

}  // namespace cuesta
