#pragma once

#include <cstdint>
#include <span>
#include <string_view>

// One target per reader of what users bring. A target takes any bytes; what leaves it is a finding: a crash, a
// sanitizer's report, or any exception, since a target catches cuesta::Error, the one answer to bad input.
namespace cuesta::fuzz {

using Bytes = std::span<const uint8_t>;

void scene(Bytes bytes);         ///< a scene file, and a few rays of it
void architecture(Bytes bytes);  ///< an architecture file; lines after one that reads `--set` are settings
void rays(Bytes bytes);          ///< a .rays file, as it is and with its checksums put right
void csv(Bytes bytes);           ///< the text form of a ray trace
void image(Bytes bytes);         ///< a picture of heights; the file's ending is chosen by the first bytes

struct Target {
  std::string_view name;  ///< of its folder in tests/fuzz/corpus too
  void (*run)(Bytes);
};

inline constexpr Target kTargets[] = {
    {"scene", scene}, {"architecture", architecture}, {"rays", rays}, {"csv", csv}, {"image", image}};

}  // namespace cuesta::fuzz
