#pragma once

#include <string>
#include <vector>

#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// Something that two machines do not have in common.
struct Difference {
  Cycle cycle = 0;
  std::string unit;       ///< "traverse[0]"
  std::string field;      ///< of a port, a counter or a fill: "hit.t", "slots_step", "contexts"
  std::string values[2];  ///< decoded and in hex
  std::string ray;        ///< the one concerned, decoded; empty where it is not known
};

/// "traverse[1].hits" in unit and field. A unit without an index is the machine's only one.
Difference difference_of(const std::string& path, Cycle cycle);

/// A whole number in decimal and hex.
std::string decoded(int64_t value);

/// In the order of cycles, and within one along the data's way, ports before counters: what causes stands before
/// what follows.
void sort_by_cause(std::vector<Difference>& differences);

/// The first difference, and at most `most` - 1 further ones of its cycle. `names`: of the two machines.
std::string report(const std::vector<Difference>& differences, const std::string (&names)[2],
                   size_t most = 12);

}  // namespace cuesta
