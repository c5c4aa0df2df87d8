#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "sim/hardware/rtl_set.h"
#include "sim/verify/lockstep/difference.h"
#include "sim/verify/lockstep/lockstep_case.h"
#include "sim/verify/lockstep/random_rtl_case.h"

namespace cuesta {

/// What is hardware on the second side.
enum class HardwareUnit : uint8_t { kHmtTop, kTraverse };

/// Gives a unit's name: "hmt_top", "traverse".
std::string_view name_of(HardwareUnit unit);
/// Reads such a name. Throws usage_error for any other.
HardwareUnit parse_hardware_unit(const std::string& name);

/// The model, and the machine with Verilated hardware in the place of the unit.
std::array<LockstepSide, 2> rtl_sides(HardwareUnit unit);

/// What a compiled set can be.
RtlStructure structure_of(const rtl::RtlParameters& parameters, HardwareUnit unit);

/// The compiled sets of these names; no name: all. Throws usage_error for a name of which this program holds no set,
/// and for a program without any.
std::vector<rtl::RtlSet> compiled_sets(const std::vector<std::string>& names);

/// Runs the side alone around the first difference and writes the waves of that pipeline's hardware into `file` (FST):
/// from 64 cycles before it to 16 behind. False, and no file: the side has no hardware.
bool leave_waves(const LockstepCase& one, const LockstepSide& side, const Difference& first,
                 const std::string& file);

}  // namespace cuesta
