#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/cli/options.h"
#include "sim/session/job.h"

namespace cuesta {

/// Options that `run` and `compare` share.
struct RunOptions {
  std::string fidelity = "cycle";
  std::string host = "direct";
  std::vector<std::string> settings;
  std::string heightmap, rays_file, crop, size, surface;
  std::optional<double> angle_degrees, depth;
  std::string folder;  ///< -o; empty: the next free one below results/
  bool json = false;
  bool force = false;

  void declare(Options& options);
};

/// Throws usage_error for angles, depths, sizes and crops out of range.
SceneChanges scene_changes(const RunOptions& options);

/// The scene to use: `named`, or the built-in `default` where only a height map is given. Throws usage_error.
std::string scene_or_default(const std::string& named, const RunOptions& options);

}  // namespace cuesta
