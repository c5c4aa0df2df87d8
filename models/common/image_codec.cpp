#include "models/common/image_codec.h"

#include <dlfcn.h>

#include <filesystem>

#include "models/common/error.h"

namespace cuesta {
namespace {

constexpr const char* kModule = "cuesta_images.so";
constexpr int kFoldersAbove = 4;  // of a build tree

[[noreturn]] void refuse(const std::string& reason) {
  throw Error(ExitCode::kResource, "Images cannot be read or written: " + reason + ".");
}

std::filesystem::path module_path() {
  std::error_code fault;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", fault);
  std::filesystem::path folder = program.parent_path();
  for (int k = 0; k <= kFoldersAbove && !folder.empty(); ++k, folder = folder.parent_path()) {
    if (std::filesystem::exists(folder / kModule, fault)) return folder / kModule;
  }
  refuse(std::string("there is no ") + kModule + " beside " + program.string() + ", where the build puts it");
}

const ImageCodec& load() {
  const std::filesystem::path path = module_path();
  void* module = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);  // never closed: OpenImageIO keeps threads
  if (module == nullptr) refuse(dlerror());
  using Function = const ImageCodec* (*)();
  const auto codec = reinterpret_cast<Function>(dlsym(module, "cuesta_image_codec"));
  if (codec == nullptr) refuse(path.string() + " is of another version; the build makes both");
  return *codec();
}

}  // namespace

const ImageCodec& image_codec() {
  static const ImageCodec& codec = load();
  return codec;
}

void require_image_codec() { module_path(); }

}  // namespace cuesta
