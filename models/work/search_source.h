#pragma once

#include <memory>
#include <vector>

#include "models/work/step_source.h"
#include "models/work/workload.h"

namespace cuesta {

/// The steps of a workload's approximate search, ray by ray: the lines that each step's samples lie in, and its slots of
/// arithmetic. `order` is the machine's order. The references must outlive the source.
std::unique_ptr<StepSource> make_search_source(const Workload& work, const Architecture& architecture,
                                               const std::vector<uint32_t>& order);

/// The hits of a workload's search and what its rays read. `report` is called now and then with rays done; false ends.
uint64_t search_all(const Workload& work, const Architecture& architecture, const Progress& progress,
                    std::vector<HitRecord>& hits, FetchCounts& fetches);

}  // namespace cuesta
