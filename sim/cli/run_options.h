#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "sim/cli/command.h"
#include "sim/config/architecture_file.h"
#include "sim/machine/machine.h"
#include "sim/session/job.h"

namespace cuesta {

enum class Host : uint8_t { kDirect, kSystemC };

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

/// Throws usage_error for names that are not known, for known ones that this program cannot run yet, and for a host
/// that does not go with the fidelity.
Fidelity parse_fidelity(const std::string& name);
Host parse_host(const std::string& name, Fidelity fidelity);

/// Throws usage_error for angles, depths, sizes and crops out of range.
SceneChanges scene_changes(const RunOptions& options);

/// Names to algorithms, in order; names may be joined by commas. "all" or nothing: every published exact one; "parts":
/// yun2013's parts, each alone; "searches": every approximate one but those as printed, which are "printed"; "all+parts", "all+searches" ...; else as
/// parse_algorithm. Throws usage_error for an unknown or repeated
/// one.
std::vector<Algorithm> parse_algorithms(const std::vector<std::string>& names);

/// Names or files to machines, in order; joined by commas as well. Throws usage_error as resolve_architecture does,
/// and for two of one name.
std::vector<ResolvedArchitecture> parse_architectures(const std::vector<std::string>& names,
                                                      const std::vector<std::string>& settings,
                                                      Fidelity fidelity);

/// Throws usage_error where a search cannot go: into hardware, into the systemc host, under a [traverse] section that
/// speaks of a schedule.
void check_searches(const std::vector<Algorithm>& algorithms,
                    const std::vector<ResolvedArchitecture>& machines, Host host);

/// The scene to use: `named`, or the built-in `default` where only a height map is given. Throws usage_error.
std::string scene_or_default(const std::string& named, const RunOptions& options);

/// "a,b", "c" -> a, b, c. Throws usage_error for a name that is empty; `option` ("--arch") is for its sentence.
std::vector<std::string> split_at_commas(const std::vector<std::string>& texts, const char* option);

}  // namespace cuesta
