#include <string_view>

#include "sim/hardware/rtl_set.h"
#include "sim/hardware/sources_key.h"

/// What the program looks up in the module: its sets. It is false for a program that is built from other sources: the
/// classes between them may differ, or the hardware may be older than its sources.
extern "C" [[gnu::visibility("default")]] bool cuesta_hardware_sets(
    const char* key, std::span<const cuesta::rtl::RtlSet>& sets) {
  if (std::string_view(key) != cuesta::rtl::kSourcesKey) return false;
  sets = cuesta::rtl::rtl_sets();
  return true;
}
