#pragma once

#include <filesystem>
#include <string>

#include "sim/verify/lockstep/lockstep_case.h"

namespace cuesta {

/// Writes a case so that the program reads it back as the same: scene.toml with heights.png and rays.rays, and
/// architecture.toml. Returns the arguments that name them and everything that no file holds: "FOLDER/scene.toml
/// --arch ... --algorithm ... --stalls ...". `folder` must be there; `named` is what the arguments call it.
/// Throws what the writers of images and rays throw.
std::string write_case(const LockstepCase& one, const std::filesystem::path& folder,
                       const std::filesystem::path& named);

/// Reads what text_of writes. Throws usage_error naming `option`.
PortStalls parse_stalls(const std::string& text, const std::string& option);
MemoryTiming parse_memory_timing(const std::string& text, const std::string& option);

}  // namespace cuesta
