#include "tests/twins/random_machine.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "models/common/error.h"
#include "models/common/random.h"
#include "models/oracle/random_cases.h"
#include "sim/config/on_architecture.h"
#include "sim/config/parameters.h"
#include "sim/verify/lockstep/random_architecture.h"

namespace cuesta::twins {
namespace {

Schedule random_schedule(Random& random, int root_level) {
  Schedule schedule = algorithms()[random.below(algorithms().size())].schedule;
  if (random.chance(0.5)) {
    schedule.start = static_cast<StartRule>(random.below(std::size(kStartNames)));
    schedule.down = kDownValues[random.below(std::size(kDownValues))];
    schedule.up = static_cast<UpRule>(random.below(std::size(kUpNames)));
  }
  if (random.chance(0.2)) schedule.stop_level = static_cast<int>(random.between(0, root_level));
  if (random.chance(0.5)) schedule.fetch = FetchRule::kQuad;
  return schedule;
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
  set_numbers(work, architecture);
  work.rays = rays;
  work.pixel_of_ray = pixels;
  work.width = width;
  work.height = height;
  work.schedule = schedule;
  work.search = search;
  work.search_map = search_map.get();
  work.depth = depth;
  return work;
}

/// Of a small number of steps, so that rays end.
Search random_search(Random& random, const MapShape& map) {
  size_t rows = search_rows().size();
  const bool printable = map.is_square_power_of_two() && map.address_mode == AddressMode::kWrap;
  if (!printable) rows = static_cast<size_t>(SearchKind::kKi2007Printed);
  Search search = search_rows()[random.below(rows)].search;
  if (is_printed(search.kind)) {
    search.steps = static_cast<int>(random.between(1, 40));
    search.delta = static_cast<int>(random.between(0, 1000));
    search.linear = search.kind == SearchKind::kKi2007Printed && random.chance(0.5);
    search.slope = random.chance(0.5);
    return search;
  }
  if (search.steps > 0) search.steps = static_cast<int>(random.between(1, 40));
  if (search.least_steps > 0) search.least_steps = static_cast<int>(random.between(1, search.steps));
  if (row_of(search).refines) search.refinements = static_cast<int>(random.between(0, 8));
  if (random.chance(0.4)) search.filter = SearchFilter::kBilinear;
  return search;
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
  if (machine.schedule.stop_level == 0 && random.chance(0.3)) {
    machine.search = random_search(random, machine.map);
    machine.depth = 0.01 * static_cast<double>(random.between(1, 100));
    machine.searched = std::make_shared<Pyramid>(machine.pyramid);
    machine.search_map =
        std::make_shared<SearchMap>(*machine.search, *machine.searched, machine.map.address_mode);
  }
  return machine;
}

std::string describe(const RandomMachine& machine) {
  std::ostringstream text;
  text << "seed " << machine.seed << ": "
       << (machine.search ? name_of(*machine.search) : name_of(machine.schedule)) << ", map "
       << machine.map.width << " x " << machine.map.height << ", " << machine.map.bits << " bits, "
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
