#pragma once

#include <string>
#include <vector>

#include "models/units/architecture.h"
#include "models/work/workload.h"
#include "sim/hardware/rtl_set.h"

namespace cuesta::rtl {

/// Whether some unit of the machine is hardware.
inline bool has_rtl(const Architecture& architecture) {
  return architecture.units.hmt_top == Implementation::kRtl ||
         architecture.units.traverse == Implementation::kRtl;
}

/// A key in which a machine is not what a set is compiled for: "traverse.contexts is 48, compiled is 32".
std::vector<std::string> differences(const RtlSet& set, const Architecture& architecture,
                                     const MapShape& map);

/// Says why rtl_sets() is empty and what would mend that, as a part of a sentence.
std::string why_there_is_no_set();

/// The compiled set that the machine is, on this work. Throws usage_error: for what no RTL can do, the key; for sizes
/// outside every set, the key, the nearest set and the option that compiles others.
const RtlSet& choose_set(const Architecture& architecture, const Workload& work);

}  // namespace cuesta::rtl
