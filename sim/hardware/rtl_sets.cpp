#include <dlfcn.h>

#include <filesystem>
#include <string>

#include "models/common/error.h"
#include "models/files/module_path.h"
#include "sim/hardware/rtl_set.h"
#ifdef CUESTA_HARDWARE_MODULE
#include "sim/hardware/sources_key.h"
#endif

namespace cuesta::rtl {

#ifdef CUESTA_HARDWARE_MODULE

namespace {

[[noreturn]] void refuse(const std::string& reason) {
  throw Error(ExitCode::kResource, "The Verilated hardware cannot be loaded: " + reason + ".");
}

std::span<const RtlSet> load() {
  const std::filesystem::path path = module_path(CUESTA_HARDWARE_MODULE ".so");
  std::error_code fault;
  if (!std::filesystem::exists(path, fault)) return {};
  void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);  // never closed: machines hold its objects
  if (module == nullptr) refuse(dlerror());
  using Function = bool (*)(const char* key, std::span<const RtlSet>& sets);
  const auto function = reinterpret_cast<Function>(dlsym(module, CUESTA_HARDWARE_MODULE));
  std::span<const RtlSet> sets;
  if (function == nullptr || !function(kSourcesKey, sets)) {
    refuse(path.string() +
           " is built from other sources than the program; accepted is one of the same: `cmake --build "
           "--preset release` builds both");
  }
  return sets;
}

}  // namespace

std::span<const RtlSet> rtl_sets() {
  static const std::span<const RtlSet> sets = load();
  return sets;
}

#else

std::span<const RtlSet> rtl_sets() { return {}; }

#endif

}  // namespace cuesta::rtl
