#pragma once

#include <string>

#include "reports/result.h"

namespace cuesta {

/// Long form, one row per run and number: scene, algorithm, architecture, fidelity, kind, name, value, unit.
/// `kind` is counter (per instance, as in result.json), derived, or ratio. RFC 4180, LF line ends.
std::string result_csv(const Result& result);

/// Wide form, one row per run: names, rays, then one column per counter (summed over pipelines), derived
/// quantity and ratio that any run has; an empty cell where a run has not counted it.
std::string summary_csv(const Result& result);

}  // namespace cuesta
