#include "sim/verify/lockstep/random_architecture.h"

#include <algorithm>

#include "models/heightmap/texel_layout.h"

namespace cuesta {
namespace {

/// Small values often, now and then up to `high`.
int skewed(Random& random, int low, int high) {
  const int64_t top = random.chance(0.5)   ? std::min(high, low + 2)
                      : random.chance(0.7) ? std::min(high, low + 15)
                                           : high;
  return static_cast<int>(random.between(low, top));
}
int power(Random& random, int low_exponent, int high_exponent) {
  return 1 << random.between(low_exponent, high_exponent);
}

}  // namespace

Architecture random_architecture(Random& random) {
  Architecture a;
  a.machine.pipelines = static_cast<int>(random.between(1, 4));
  a.machine.no_progress_cycles = 100'000'000;
  a.ray_dispatch.order = static_cast<DispatchOrder>(random.below(4));
  a.ray_dispatch.assign = static_cast<DispatchAssign>(random.below(2));
  a.ray_dispatch.tile_size = power(random, 0, 3);
  a.ray_dispatch.queue_depth = skewed(random, 1, 12);
  a.ray_dispatch.latency_cycles = skewed(random, 1, 30);
  a.ray_dispatch.credit_latency_cycles = skewed(random, 1, 30);
  a.ray_setup.latency_cycles = skewed(random, 1, 40);
  a.ray_setup.interval_cycles = skewed(random, 1, 12);
  a.ray_setup.queue_depth = skewed(random, 1, 12);
  a.traverse.arithmetic = random.chance(0.6) ? Arithmetic::kFixed : static_cast<Arithmetic>(random.below(3));
  a.traverse.stages = skewed(random, 1, 20);
  a.traverse.contexts = a.traverse.stages + skewed(random, 0, 40);
  a.height_l1.line_bytes = power(random, 4, 7);
  a.height_l1.ways = random.chance(0.4) ? 1 : static_cast<int>(random.between(1, 6));
  const int sets = power(random, 0, 4);
  a.height_l1.size_bytes = a.height_l1.line_bytes * a.height_l1.ways * sets;
  a.height_l1.mshrs = random.chance(0.05) ? 64 : skewed(random, 1, 20);
  a.hit_queue.depth = skewed(random, 1, 12);
  a.result_writer.burst_bytes = power(random, 5, 8);
  a.result_writer.outstanding = skewed(random, 1, 8);
  a.dram.channels = power(random, 0, 2);
  a.dram.banks = power(random, 0, 3);
  a.dram.row_bytes = power(random, 8, 11);
  a.dram.bus_bytes = power(random, 0, 5);
  a.dram.tRCD = skewed(random, 1, 20);
  a.dram.tRP = skewed(random, 1, 20);
  a.dram.tCL = skewed(random, 1, 20);
  a.dram.tRAS = a.dram.tRCD + skewed(random, 0, 40);
  a.dram.clock_num = random.chance(0.3) ? 1 : static_cast<int>(random.between(1, 12));
  a.dram.clock_den = random.chance(0.3) ? a.dram.clock_num : static_cast<int>(random.between(1, 6));
  a.dram.request_latency_cycles = skewed(random, 1, 25);
  a.dram.response_latency_cycles = skewed(random, 1, 25);
  a.texels.layout = static_cast<TexelLayoutKind>(random.below(kTexelLayouts.size()));
  return a;
}

PortStalls random_stalls(Random& random) {
  PortStalls stalls;
  stalls.seed = random.next();
  for (uint16_t& chance : stalls.per_mille) {
    if (random.chance(0.4)) continue;
    chance = static_cast<uint16_t>(random.chance(0.1) ? random.between(850, 980) : random.between(1, 600));
  }
  return stalls;
}

}  // namespace cuesta
