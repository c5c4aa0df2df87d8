#pragma once

#include <span>
#include <string>
#include <string_view>

#include "traces/scene.h"

namespace cuesta {

/// A scene of the folder traces/scenes, part of the program.
struct BuiltInScene {
  std::string_view name;
  std::string_view text;  ///< TOML
};

/// Sorted by name.
std::span<const BuiltInScene> built_in_scenes();

/// A built-in scene by its name, else the scene file of that path. Throws usage_error where there is neither, naming
/// the built-in scenes, and for a faulty scene.
Scene find_scene(const std::string& name_or_path);

}  // namespace cuesta
