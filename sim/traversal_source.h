#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "models/heightmap/texel_layout.h"
#include "models/traversal/step_source.h"
#include "sim/machine.h"

namespace cuesta {

/// The steps of a workload's rays, traversed batch by batch; `order` is the machine's order. The references must
/// outlive the source.
std::unique_ptr<StepSource> make_traversal_source(const Workload& work, const Architecture& architecture,
                                                  const TexelLayout& layout, std::span<const uint32_t> order);

}  // namespace cuesta
