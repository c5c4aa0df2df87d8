#include "models/files/image_codec.h"

#include <dlfcn.h>
#include <sys/stat.h>

#include <filesystem>

#include "models/common/error.h"

namespace cuesta {
namespace {

constexpr const char* kModule = "cuesta_images.so";
constexpr const char* kTopOfABuild = "CMakeCache.txt";
constexpr int kFoldersAbove = 4;

[[noreturn]] void refuse(const std::string& reason) {
  throw Error(ExitCode::kResource, "Images cannot be read or written: " + reason + ".");
}

bool same_owner(const std::filesystem::path& a, const std::filesystem::path& b) {
  struct stat of_a, of_b;
  return stat(a.c_str(), &of_a) == 0 && stat(b.c_str(), &of_b) == 0 && of_a.st_uid == of_b.st_uid;
}

std::filesystem::path module_path() {
  std::error_code fault;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", fault);
  std::filesystem::path folder = program.parent_path();
  if (std::filesystem::exists(folder / kModule, fault)) return folder / kModule;
  for (int k = 0; k < kFoldersAbove; ++k) {
    folder = folder.parent_path();
    if (!std::filesystem::exists(folder / kTopOfABuild, fault)) continue;
    if (same_owner(folder / kModule, program)) return folder / kModule;
  }
  refuse(std::string("there is no ") + kModule + " beside " + program.string() + ", where the build puts it");
}

const ImageCodec& load() {
  const std::filesystem::path path = module_path();
  void* module = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);  // never closed: OpenImageIO keeps threads
  if (module == nullptr) refuse(dlerror());
  using Function = const ImageCodec* (*)(int version);
  const auto function = reinterpret_cast<Function>(dlsym(module, "cuesta_image_codec"));
  const ImageCodec* codec = function == nullptr ? nullptr : function(kImageCodecVersion);
  if (codec == nullptr) refuse(path.string() + " is of another version; the build makes both");
  return *codec;
}

}  // namespace

const ImageCodec& image_codec() {
  static const ImageCodec& codec = load();
  return codec;
}

}  // namespace cuesta
