#include "traces/scene_library.h"

#include <filesystem>
#include <vector>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {

Scene find_scene(const std::string& name_or_path) {
  std::vector<std::string_view> names;
  for (const BuiltInScene& built_in : built_in_scenes()) {
    if (built_in.name == name_or_path) {
      const std::string name(built_in.name);
      Scene scene = parse_scene(std::string(built_in.text), "built-in scene " + name, "");
      scene.name = name;
      return scene;
    }
    names.push_back(built_in.name);
  }
  std::error_code failure;
  const bool path_like = name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
  if (path_like || std::filesystem::exists(name_or_path, failure)) return load_scene(name_or_path);
  throw usage_error("There is no built-in scene and no file `" + printable(name_or_path) +
                    "`; accepted: the path of a scene file, or one of " + joined(names) +
                    (did_you_mean(name_or_path, names).empty() ? "." : did_you_mean(name_or_path, names)));
}

}  // namespace cuesta
