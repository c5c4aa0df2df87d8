#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "models/heightmap/texel_layout.h"
#include "models/work/step_source.h"
#include "models/work/workload.h"

namespace cuesta {

/// The steps of a workload's rays, traversed batch by batch; `order` is the machine's order. The references must
/// outlive the source; rays may be added behind them (`set_rays`).
std::unique_ptr<StepSource> make_traversal_source(const Workload& work, const Architecture& architecture,
                                                  const TexelLayout& layout,
                                                  const std::vector<uint32_t>& order);

}  // namespace cuesta
