#include "models/files/module_path.h"

#include <sys/stat.h>

#include <system_error>

namespace cuesta {
namespace {

constexpr const char* kTopOfABuild = "CMakeCache.txt";
constexpr int kFoldersAbove = 4;

bool same_owner(const std::filesystem::path& a, const std::filesystem::path& b) {
  struct stat of_a, of_b;
  return stat(a.c_str(), &of_a) == 0 && stat(b.c_str(), &of_b) == 0 && of_a.st_uid == of_b.st_uid;
}

}  // namespace

std::filesystem::path program_path() {
  std::error_code fault;
  return std::filesystem::read_symlink("/proc/self/exe", fault);
}

std::filesystem::path module_path(const std::string& name) {
  std::error_code fault;
  const std::filesystem::path program = program_path();
  std::filesystem::path folder = program.parent_path();
  if (std::filesystem::exists(folder / name, fault)) return folder / name;
  for (int k = 0; k < kFoldersAbove; ++k) {
    folder = folder.parent_path();
    if (!std::filesystem::exists(folder / kTopOfABuild, fault)) continue;
    if (same_owner(folder / name, program)) return folder / name;
  }
  return {};
}

}  // namespace cuesta
