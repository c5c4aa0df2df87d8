#pragma once

#include <memory>
#include <vector>

#include "models/heightmap/texel_layout.h"
#include "models/work/step_source.h"
#include "models/work/workload.h"

// Workloads on bilinear surfaces (Workload::map.surface). A visit of a node above the leaves reads its texel, or its
// siblings, as over texels. A visit of a leaf reads the samples at the patch's corners, which lie at level 0 of the
// image: one fetch of four, of two or one where the map's edge is repeated; their highest is the leaf's bound, so that no
// bound of a leaf is stored. With FetchRule::kQuad the samples take the place of the kept siblings. (Our rules.)

namespace cuesta {

/// As trace_all of functional_run.cpp: traverses the rays in order; how many were done when `progress` said stop, or all.
uint64_t trace_bilinear(const Workload& work, Arithmetic arithmetic, const NumberFormat& format,
                        const Progress& progress, std::vector<HitRecord>& hits, FetchCounts& fetches);

/// As make_traversal_source.
std::unique_ptr<StepSource> make_bilinear_source(const Workload& work, const Architecture& architecture,
                                                 const TexelLayout& layout,
                                                 const std::vector<uint32_t>& order);

}  // namespace cuesta
