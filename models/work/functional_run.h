#pragma once

#include "models/work/outcome.h"
#include "models/work/workload.h"

namespace cuesta {

/// Finds hits, steps and what is fetched, without time.
Outcome run_functional(const Workload& work, const Progress& progress = {});

}  // namespace cuesta
