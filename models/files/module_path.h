#pragma once

#include <filesystem>
#include <string>

// Parts of the program that are loaded when they are first needed are modules: shared libraries in the folder of the
// program, or in the top folder of the build tree that the program belongs to.

namespace cuesta {

/// The file of the program that runs.
std::filesystem::path program_path();

/// Where the module with the file name `name` is: beside the program; for other programs of a build tree in the tree's
/// top, where it has the program's owner. An empty path says that it is in neither.
std::filesystem::path module_path(const std::string& name);

}  // namespace cuesta
