#pragma once

#include <span>

#include "models/oracle/oracle.h"
#include "models/oracle/traced_ray.h"

namespace cuesta {

/// Finds what a descending ray hits on a repeating square map whose side is a power of two, exactly: as
/// oracle_leaf_walk, but nodes that the ray provably passes above are skipped. `levels`: views of the max
/// pyramid, leaves first.
OracleHit<BigInt> exact_skipping_walk(const ExactRay<BigInt>& ray, std::span<const OracleMap> levels);

}  // namespace cuesta
