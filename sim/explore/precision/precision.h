#pragma once

#include <span>

#include "models/oracle/oracle.h"
#include "models/oracle/traced_ray.h"
#include "sim/explore/study/study.h"

namespace cuesta {

/// How far from the truth does each format of numbers put a hit, and how narrow may one be?
StudyData precision_plan(bool quick);
std::unique_ptr<StudyBench> make_precision_bench(const StudyData& plan,
                                                 std::span<const uint16_t> size_and_bits);

/// What a descending ray finds on a repeating square map whose side is a power of two, exactly: as oracle_leaf_walk,
/// but nodes that the ray provably passes above are skipped. `levels`: views of the max pyramid, leaves first.
OracleHit<BigInt> exact_skipping_walk(const ExactRay<BigInt>& ray, std::span<const OracleMap> levels);

/// The largest value of ten bits after the leading one (IEEE half precision) that is nearest to `height`, ties to even;
/// where that lies above `full_scale`, the largest below it. Heights as fractions of 2^B: the scale takes no part.
int64_t in_half_precision(int64_t height, int64_t full_scale);

}  // namespace cuesta
