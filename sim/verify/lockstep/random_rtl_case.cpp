#include "sim/verify/lockstep/random_rtl_case.h"

#include <algorithm>

#include "models/common/error.h"
#include "models/oracle/random_cases.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/machine.h"
#include "sim/verify/lockstep/random_architecture.h"

namespace cuesta {
namespace {

constexpr int kFrame = 20;  ///< pixels on a side

/// Small maps and such as do not fit into a cache; large ones cost more to make than their rays to trace.
int random_level(Random& random, int max_level) {
  if (random.chance(0.5)) return static_cast<int>(random.between(0, std::min(6, max_level)));
  const int most = random.chance(0.9) ? 9 : random.chance(0.95) ? 10 : 12;
  return static_cast<int>(random.between(std::min(7, max_level), std::min(most, max_level)));
}

RandomMap random_square_map(Random& random, const RtlStructure& structure,
                            const TraverseParameters& traverse) {
  RandomMap map;
  map.kind = "square";
  const int level = random_level(random, structure.max_level), side = 1 << level;
  map.shape = {side, side, level,
               static_cast<int>(random.between(structure.height_bits > 8 ? 9 : 1, structure.height_bits)),
               random.chance(0.5) ? AddressMode::kWrap : AddressMode::kBorder};
  map.format = number_format(traverse, map.shape);
  map.grid = {side, side, map.shape.bits, {}};
  map.grid.texels.resize(static_cast<size_t>(side) * static_cast<size_t>(side));
  const bool rough = random.chance(0.4);
  const int64_t full = map.shape.full_scale(), step = 1 + full / 64;
  int64_t height = random.between(0, full);
  for (uint16_t& texel : map.grid.texels) {
    height =
        rough ? random.between(0, full) : std::clamp<int64_t>(height + random.between(-step, step), 0, full);
    texel = static_cast<uint16_t>(height);
  }
  return map;
}

/// Single rays, or bundles of parallel ones as a camera makes them; all fit the machine's numbers.
std::vector<TracedRay> random_rays(Random& random, const RandomMap& map, int most_rays) {
  const auto count = static_cast<size_t>(random.between(1, most_rays));
  const bool bundled = random.chance(0.5), pixel_by_pixel = random.chance(0.5);
  std::vector<TracedRay> rays;
  TracedRay first;
  for (uint64_t id = 0; rays.size() < count; ++id) {
    TracedRay ray = random_ray(random, map, id);
    if (id % 64 == 0 || !bundled) first = ray;
    ray = first;
    ray.id = id;
    if (id % 64 != 0 && bundled && ray.fixed_axis == FixedAxis::kNone) {
      ray.origin[0] += static_cast<double>(id % 8) * 0x1p-8;
      ray.origin[1] += static_cast<double>(id / 8 % 8) * 0x1p-8;
    }
    try {
      (void)quantise(ray, map.shape, map.format);
    } catch (const Error&) {
      first = random_ray(random, map, id);
      continue;  // outside the tiles
    }
    const uint64_t pixel = pixel_by_pixel ? rays.size() % (kFrame * kFrame) : random.below(kFrame * kFrame);
    ray.pixel_x = static_cast<uint32_t>(pixel % kFrame);
    ray.pixel_y = static_cast<uint32_t>(pixel / kFrame);
    rays.push_back(ray);
  }
  return rays;
}

MemoryTiming random_memory(Random& random, const DramParameters& dram) {
  const int window = dram.request_latency_cycles + dram.response_latency_cycles;
  MemoryTiming timing;
  timing.seed = random.next();
  timing.least_cycles = static_cast<int>(random.between(window, random.chance(0.7) ? window + 20 : 400));
  timing.most_cycles = static_cast<int>(random.between(timing.least_cycles, 400));
  timing.most_gap_cycles = random.chance(0.4) ? 0 : static_cast<int>(random.between(1, 40));
  return timing;
}

}  // namespace

LockstepCase random_rtl_case(const RtlStructure& structure, uint64_t seed, int most_rays) {
  Random random(Random::mix(seed ^ 0x6C6F636B73746570ull));
  LockstepCase one;
  one.seed = seed;
  Architecture& a = one.machine.architecture;
  a = random_architecture(random);
  a.name = "random";
  a.machine.pipelines = static_cast<int>(random.between(1, 2));
  a.machine.no_progress_cycles = 200'000;
  a.ray_setup = structure.architecture.ray_setup;
  a.traverse = structure.architecture.traverse;
  a.height_l1 = structure.architecture.height_l1;
  a.texels.layout = random.chance(0.5) ? TexelLayoutKind::kRowMajor : TexelLayoutKind::kMorton;
  if (random.chance(0.67)) one.machine.stalls = random_stalls(random);
  if (structure.setup_inside) one.machine.stalls.per_mille[static_cast<int>(Port::kSetup)] = 0;
  if (random.chance(0.5)) one.machine.memory = random_memory(random, a.dram);

  one.machine.register_seed = static_cast<int>(random.between(1, 1 << 30));

  const RandomMap map = random_square_map(random, structure, a.traverse);
  one.address_mode = map.shape.address_mode;
  Schedule& schedule = one.machine.schedule;
  schedule.start = static_cast<StartRule>(random.below(3));
  schedule.down = static_cast<int>(random.between(1, 3));
  schedule.up = static_cast<UpRule>(random.below(8));
  if (random.chance(0.3)) schedule.stop_level = static_cast<int>(random.between(0, map.shape.root_level));
  one.pyramid = std::make_shared<Pyramid>(build_max_pyramid(map.grid));
  one.width = one.height = kFrame;
  one.rays = random_rays(random, map, most_rays);
  return one;
}

}  // namespace cuesta
