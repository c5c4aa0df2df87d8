#pragma once

#include <cstdint>

namespace cuesta::rtl {

// The register map of rtl/hmt_top.sv, as rtl/common/hmt_registers.svh has it: tied_constants.h holds one against the
// other.

inline constexpr int kRegisterMode = 0, kRegisterTimeEnd = 1, kRegisterRootBound = 2, kRegisterLevelBase = 16,
                     kRegisterCounter = 32;
/// The lowest bits of the mode register's fields.
struct ModeField {
  static constexpr int kRootLevel = 0, kBorder = 4, kStart = 5, kDown = 7, kUp = 9, kStopLevel = 12,
                       kMorton = 16;
};

/// Puts a value into a field of the mode register.
template <class Value>
constexpr uint64_t in_field(int lowest_bit, Value value) {
  return static_cast<uint64_t>(value) << lowest_bit;
}

}  // namespace cuesta::rtl
