#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "models/units/architecture.h"

namespace cuesta {

/// A machine that the program carries with it: the text of sim/configs/<name>.toml.
struct Preset {
  std::string_view name;
  std::string_view toml;
};

/// Sorted by name.
std::span<const Preset> presets();

/// A machine with the origin of each of its values.
struct ResolvedArchitecture {
  Architecture architecture;         ///< `name`: the preset's, or the file's without folder and ending
  std::vector<std::string> origins;  ///< as long as parameters(): "preset mobile", "fast.toml:4", "--set"
  std::vector<std::string> files;    ///< that were read, in order
  std::vector<std::string> unused;   ///< sections and keys that a file gives and this run does not use

  /// A value that neither file nor setting gives; `path` is a parameter's, `value` in its range.
  void set(std::string_view path, int64_t value, const std::string& origin);
  /// TOML with every value, its origin, and what this run does not use as comments: reads back as the same machine.
  std::string toml(bool with_time) const;
};

/// Builds a machine from a preset's name or a file (anything that ends in .toml or holds a slash; it may start
/// from another with `base = "mobile"` or `base = "other.toml"`, relative to itself) and settings
/// "height_l1.ways=4", which come last. A file without a base starts from the defaults of parameters().
/// Throws usage_error for unknown names, wrong types and ranges, contradictions, and a setting that a run
/// of this kind (`with_time`: cycle fidelity) does not use.
ResolvedArchitecture resolve_architecture(const std::string& preset_or_file,
                                          std::span<const std::string> settings, bool with_time);

/// "key=value" in two. Throws usage_error.
std::pair<std::string, std::string> split_setting(const std::string& setting);

}  // namespace cuesta
