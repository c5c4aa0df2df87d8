#pragma once

#include <string>
#include <vector>

#include "models/algorithms/schedule.h"
#include "sim/session/machines.h"

namespace cuesta {

/// "a,b", "c" -> a, b, c. Throws usage_error for a name that is empty; `option` ("--arch") is for its sentence.
std::vector<std::string> split_at_commas(const std::vector<std::string>& texts, const char* option);

/// Reads names of algorithms, in order; they may be joined by commas. "all" or nothing stands for every published
/// exact one, "parts" for yun2013's parts, each alone, "searches" for every approximate one but those as printed,
/// which are "printed"; "all+parts", "all+searches" ... for several; else as parse_algorithm. Throws usage_error for
/// an unknown or repeated one.
std::vector<Algorithm> parse_algorithms(const std::vector<std::string>& names);

/// Reads names or files of machines, in order; joined by commas as well. Throws usage_error as resolve_machines does.
std::vector<ResolvedArchitecture> parse_architectures(const std::vector<std::string>& names,
                                                      const std::vector<std::string>& settings,
                                                      Fidelity fidelity);

}  // namespace cuesta
