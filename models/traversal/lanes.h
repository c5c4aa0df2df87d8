#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "models/heightmap/pyramid.h"
#include "models/traversal/step_lines.h"
#include "models/traversal/traversal.h"

namespace cuesta {

/// Whether `traverse_lanes` can do this walk on this processor: fixed point, a square power of two that wraps or ends
/// at its border, texels fetched one by one, downs of 1 to 3 levels, slopes below 2^31, AVX-512.
bool lanes_can(const Walk<FixedArithmetic, PlainAxis>& walk);

/// The same walk, rays and records as `traverse_ray`, bit for bit, 16 rays at a time in the lanes of AVX-512
/// registers. Ray k of the call is rays[order[k]], or rays[k] with an empty order; hits[k] is its record.
/// `recorder` may be nullptr; its layout must not be kMorton.
void traverse_lanes(const Walk<FixedArithmetic, PlainAxis>& walk, const Pyramid& pyramid,
                    std::span<const MachineRay> rays, std::span<const uint32_t> order,
                    std::span<HitRecord> hits, const LineRecorder* recorder);

}  // namespace cuesta
