#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/cli/options.h"
#include "sim/cli/run_options.h"

namespace cuesta {

/// The options of `verify rtl`, some of which are about random machines and some about a user's own rays.
struct VerifyRtlOptions {
  std::string scene, unit = "hmt_top", algorithm = "yun2013", architecture = "mobile", stalls, memory;
  std::vector<std::string> sets;
  RunOptions run;  ///< of it: heights, rays, settings, size, crop and the folder
  int64_t seconds = 20;
  uint64_t ray_count = 0;
  uint64_t seed = 1;
  int workers = 1;
  int register_seed = 0;
  Option seconds_option, count_option, seed_option, sets_option, workers_option, algorithm_option,
      architecture_option, register_seed_option;

  void declare(Options& options);
  /// Says whether a user's own rays are meant, and no random machines.
  bool own() const { return !scene.empty() || !run.heightmap.empty() || !run.rays_file.empty(); }
  /// Throws usage_error for an option that such a run does not use.
  void refuse_unused() const;
  /// Throws usage_error where -o names what is there: nothing here replaces an older folder, as `cuesta run` does
  /// when it is told to.
  void refuse_existing_folder() const;
};

}  // namespace cuesta
