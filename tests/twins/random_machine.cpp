#include "tests/twins/random_machine.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "models/common/error.h"
#include "models/common/random.h"
#include "models/oracle/random_cases.h"
#include "sim/config/parameters.h"

namespace cuesta::twins {
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

Schedule random_schedule(Random& random, int root_level) {
  Schedule schedule = algorithms()[random.below(algorithms().size())].schedule;
  if (random.chance(0.5)) {
    schedule.start = static_cast<StartRule>(random.below(start_names().size()));
    schedule.down = down_values()[random.below(down_values().size())];
    schedule.up = static_cast<UpRule>(random.below(up_names().size()));
  }
  if (random.chance(0.2)) schedule.stop_level = static_cast<int>(random.between(0, root_level));
  if (random.chance(0.5)) schedule.fetch = FetchRule::kQuad;
  return schedule;
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

/// A bundle of parallel rays over neighbouring points: what a camera makes.
TracedRay bundle_ray(const TracedRay& first, uint64_t id, uint64_t number) {
  TracedRay ray = first;
  ray.id = id;
  if (ray.fixed_axis == FixedAxis::kNone) {
    ray.origin[0] += static_cast<double>(number % 8) * 0x1p-8;
    ray.origin[1] += static_cast<double>(number / 8 % 8) * 0x1p-8;
  }
  return ray;
}

}  // namespace

Workload RandomMachine::work() const {
  Workload work;
  work.pyramid = &pyramid;
  work.map = map;
  work.rays = rays;
  work.pixel_of_ray = pixels;
  work.width = width;
  work.height = height;
  work.schedule = schedule;
  return work;
}

RandomMachine random_machine(uint64_t seed, int most_rays) {
  Random random(seed);
  RandomMachine machine;
  machine.seed = seed;
  machine.architecture = random_architecture(random);
  machine.stalled = random.chance(0.7);
  if (machine.stalled) machine.stalls = random_stalls(random);

  const bool any_map = random.chance(0.2);
  RandomMap map = random_map(random.next(), 64);
  while (!any_map && (map.grid.width < 9 || map.grid.height < 9)) map = random_map(random.next(), 64);
  if (!any_map && random.chance(0.6)) map.shape.address_mode = AddressMode::kWrap;
  map.format.tile_bits = std::min(map.format.tile_bits, 4);
  machine.schedule = random_schedule(random, map.shape.root_level);
  machine.pyramid = build_stopped_pyramid(build_max_pyramid(map.grid), machine.schedule.stop_level);
  machine.map = map.shape;
  TraverseParameters& traverse = machine.architecture.traverse;
  traverse.fraction_bits = map.format.fraction_bits;
  traverse.direction_bits = map.format.direction_bits;
  traverse.mantissa_bits = map.format.mantissa_bits;
  traverse.tile_bits = map.format.tile_bits;

  machine.width = static_cast<int>(random.between(1, 20));
  machine.height = static_cast<int>(random.between(1, 20));
  const auto pixels = static_cast<uint64_t>(machine.width) * static_cast<uint64_t>(machine.height);
  const bool pixel_by_pixel = random.chance(0.5), bundled = random.chance(0.5);
  const int64_t most = random.chance(0.03) ? 12 * most_rays : most_rays;
  const int64_t count = random.chance(0.02) ? 0 : random.between(1, most);
  const uint64_t first_id = random.next() >> 1;
  TracedRay first;
  for (uint64_t k = 0; static_cast<int64_t>(k) < count;) {
    TracedRay ray = random_ray(random, map, first_id + k);
    if (k % 64 == 0) first = ray;
    if (bundled && k % 64 != 0) ray = bundle_ray(first, first_id + k, k % 64);
    try {
      const MachineRay quantised = quantise(ray, map.shape, map.format);
      if (quantised.dead && random.chance(0.9)) continue;
      machine.rays.push_back(quantised);
    } catch (const Error&) {
      if (bundled) first = ray = random_ray(random, map, first_id + k);
      continue;  // outside the tiles
    }
    if (random.chance(0.02)) machine.rays.back().dead = true;
    machine.pixels.push_back(static_cast<uint32_t>(pixel_by_pixel ? k % pixels : random.below(pixels)));
    ++k;
  }
  return machine;
}

std::string describe(const RandomMachine& machine) {
  std::ostringstream text;
  text << "seed " << machine.seed << ": " << name_of(machine.schedule) << ", map " << machine.map.width
       << " x " << machine.map.height << ", " << machine.map.bits << " bits, "
       << name_of(machine.map.address_mode) << ", " << machine.rays.size() << " rays on " << machine.width
       << " x " << machine.height << " pixels\nstalls per mille:";
  if (machine.stalled) {
    for (const uint16_t chance : machine.stalls.per_mille) text << ' ' << chance;
  } else {
    text << " none";
  }
  for (const Parameter& parameter : parameters()) {
    text << '\n' << parameter.path << " = " << parameter.text(parameter.get(machine.architecture));
  }
  return text.str() + "\n";
}

}  // namespace cuesta::twins
