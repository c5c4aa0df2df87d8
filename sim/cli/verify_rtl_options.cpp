#include "sim/cli/verify_rtl_options.h"

#include <filesystem>
#include <utility>

#include "models/common/error.h"
#include "models/common/words.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta {

void VerifyRtlOptions::declare(Options& options) {
  options.add("scene", scene,
              "Scene file or name: its rays on the machine of --arch. Without one (and without "
              "--heightmap): random machines with random rays");
  options.add("--unit", unit, "What is hardware: hmt_top (ray_setup, traverse and height_l1) or traverse")
      .with_default();
  seconds_option = options.add("--seconds", seconds, "Random machines: so long")
                       .range(int64_t{1}, int64_t{1000000})
                       .with_default();
  count_option =
      options.add("--ray-count", ray_count, "Random machines: until so many rays, in the place of --seconds")
          .range(int64_t{1}, int64_t{1000000000000});
  seed_option =
      options.add("--seed", seed, "Random machines: seed of the first; the next has the next").with_default();
  sets_option = options.add("--sets", sets,
                            "Random machines: only of these compiled sets, joined by commas; default: all");
  workers_option = options
                       .add("--workers", workers,
                            "Random machines that run at a time; what is found does not depend on it")
                       .range(1, 256)
                       .with_default();
  options.add("--rays", run.rays_file,
              "Rays from a .rays or .csv file, over the scene's heights (default's without one)");
  options.add("--heightmap", run.heightmap, "Heights from an image, as `cuesta run` takes them");
  algorithm_option =
      options
          .add("--algorithm", algorithm, "With a scene: one out of `cuesta list algorithms`, or a schedule")
          .with_default();
  architecture_option =
      options.add("--arch", architecture, "With a scene: preset or architecture file").with_default();
  options.add("--set", run.settings,
              "With a scene: one value of the architecture: height_l1.ways=4; may be repeated");
  options.add("--size", run.size, "With a scene: pixels: 256 or 640x480");
  options.add("--crop", run.crop, "With a scene: only the pixels x,y,width,height of the frame");
  options.add("--stalls", stalls,
              "With a scene: SEED:p,p,p,p,p,p,p,p, chances of a stall per mille at the ports " +
                  joined(kPortNames) + "; setup only with --unit traverse");
  options.add("--memory", memory,
              "With a scene: SEED:LEAST,MOST,GAP: rays come up to GAP cycles apart, memory answers "
              "after LEAST to MOST cycles, in any order");
  register_seed_option = options
                             .add("--register-seed", register_seed,
                                  "With a scene: what registers without a reset begin with; 0: zeros")
                             .range(0, 1 << 30);
  options.add("-o,--output", run.folder,
              "New folder for the smallest failing case; default: the next free results/verify-rtl-NNN");
}

void VerifyRtlOptions::refuse_existing_folder() const {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_type type = fs::symlink_status(run.folder, ignored).type();
  if (type == fs::file_type::none || type == fs::file_type::not_found) return;
  if (type == fs::file_type::directory && fs::is_empty(run.folder, ignored)) return;
  throw usage_error("-o " + printable(run.folder, 200) +
                    " exists and stays as it is; accepted is the name of a new folder or an empty one.");
}

void VerifyRtlOptions::refuse_unused() const {
  const std::pair<const char*, bool> of_random[] = {{"--seconds", seconds_option.count() > 0},
                                                    {"--ray-count", count_option.count() > 0},
                                                    {"--seed", seed_option.count() > 0},
                                                    {"--sets", sets_option.count() > 0},
                                                    {"--workers", workers_option.count() > 0}};
  const std::pair<const char*, bool> of_own[] = {{"--algorithm", algorithm_option.count() > 0},
                                                 {"--arch", architecture_option.count() > 0},
                                                 {"--set", !run.settings.empty()},
                                                 {"--size", !run.size.empty()},
                                                 {"--crop", !run.crop.empty()},
                                                 {"--stalls", !stalls.empty()},
                                                 {"--memory", !memory.empty()},
                                                 {"--register-seed", register_seed_option.count() > 0}};
  if (seconds_option.count() > 0 && count_option.count() > 0) {
    throw usage_error("--seconds and --ray-count both say when to stop; accepted is one of the two.");
  }
  for (const auto& [option, given] : of_random) {
    if (own() && given)
      throw usage_error(std::string(option) +
                        " is about random machines, and a scene is given; accepted is one of the two.");
  }
  for (const auto& [option, given] : of_own) {
    if (!own() && given)
      throw usage_error(
          std::string(option) +
          " is about a scene's rays, and no scene is given; accepted is a scene's name or file before it.");
  }
}

}  // namespace cuesta
