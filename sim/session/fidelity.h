#pragma once

#include <string>
#include <string_view>

#include "sim/machine/machine.h"

namespace cuesta {

/// Gives a fidelity's name, as options and results write it: functional, transaction, cycle, rtl.
std::string_view name_of(Fidelity fidelity);

/// Reads such a name. Throws usage_error for any other.
Fidelity parse_fidelity(const std::string& name);

/// Says whether a fidelity runs the machine cycle by cycle, which waves and hosts need.
bool runs_every_cycle(Fidelity fidelity);

}  // namespace cuesta
