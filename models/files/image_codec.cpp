#include "models/files/image_codec.h"

#include <dlfcn.h>

#include <filesystem>
#include <string>

#include "models/common/error.h"
#include "models/files/module_path.h"

#ifdef CUESTA_SANITIZED
static bool module_is_loaded = false;

/// LeakSanitizer asks for this at the program's end. It fails, one time in about a hundred, over the threads of
/// libraries that came after the program's start: a program is checked for leaks unless it has loaded the module. It is
/// weak, because a test that links OpenImageIO, so that it is there from the start, says otherwise.
extern "C" [[gnu::weak]] int __lsan_is_turned_off() { return module_is_loaded; }
#endif

namespace cuesta {
namespace {

constexpr const char* kModule = "cuesta_images.so";

[[noreturn]] void refuse(const std::string& reason) {
  throw Error(ExitCode::kResource, "Images cannot be read or written: " + reason + ".");
}

const ImageCodec& load() {
  const std::filesystem::path path = module_path(kModule);
  if (path.empty()) {
    refuse(std::string("there is no ") + kModule + " beside " + program_path().string() +
           ", where the build puts it");
  }
  void* module = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);  // never closed: OpenImageIO keeps threads
  if (module == nullptr) refuse(dlerror());
#ifdef CUESTA_SANITIZED
  module_is_loaded = true;
#endif
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
