#pragma once

#include <span>
#include <string_view>

namespace cuesta {

/// A library that the program links, with its version when the build was configured.
struct LinkedLibrary {
  std::string_view name;
  std::string_view version;
};

/// What this program was built from and with: for manifests and `--version`. No value depends on the time of day,
/// the host, or the folder of the build.
struct BuildInfo {
  std::string_view version;  ///< "0.1.0"
  std::string_view
      commit;  ///< as of the last build, with "-dirty" for uncommitted changes; "unknown" outside a clone
  std::string_view compiler;  ///< "GNU 12.2.0"
  std::string_view flags;     ///< of the build type and of the whole tree: "-O3 -ffp-contract=off"
  std::span<const LinkedLibrary> libraries;  ///< sorted by name
};

const BuildInfo& build_info();

}  // namespace cuesta
