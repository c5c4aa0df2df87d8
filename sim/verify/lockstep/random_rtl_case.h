#pragma once

#include <cstdint>

#include "sim/verify/lockstep/lockstep_case.h"

namespace cuesta {

/// What Verilated hardware can be: everything else about a machine is free.
struct RtlStructure {
  Architecture architecture;  ///< ray_setup, traverse and height_l1 count
  int max_level = 10;         ///< maps of up to 2^max_level texels on a side
  int height_bits = 8;        ///< heights of up to 8 bits, or of 9 to so many
  bool setup_inside =
      true;  ///< the port between ray_setup and traverse is inside the hardware: it knows no stalls
};

/// A random workload on a random machine of this structure; everything follows from the seed: a square map, half of
/// them of at most 64 texels on a side, mostly of at most 512, now and then up to 4096; schedule, stop level, address
/// mode, layout, queues, dram;
/// 1 or 2 pipelines; stalls on all ports in two of three; memory outside, with answers in random order, in half;
/// 1 to `most_rays` rays.
LockstepCase random_rtl_case(const RtlStructure& structure, uint64_t seed, int most_rays = 400);

}  // namespace cuesta
