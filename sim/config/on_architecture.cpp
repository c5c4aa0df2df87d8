#include "sim/config/on_architecture.h"

#include <algorithm>
#include <string>

#include "models/common/error.h"

namespace cuesta {

NumberFormat number_format(const TraverseParameters& traverse, const MapShape& map) {
  NumberFormat format;
  format.fraction_bits = traverse.fraction_bits;
  format.direction_bits = traverse.direction_bits;
  format.mantissa_bits = traverse.mantissa_bits == 0 ? map.bits + 4 : traverse.mantissa_bits;
  format.tile_bits = traverse.tile_bits;
  // Products carry two bits more than a time; hit records hold a cell's index in 32 bits.
  if (time_bits(map, format) > 60 || map.root_level + format.tile_bits > 29) {
    throw usage_error("traverse.fraction_bits = " + std::to_string(format.fraction_bits) +
                      ", mantissa_bits = " + std::to_string(format.mantissa_bits) +
                      " and tile_bits = " + std::to_string(format.tile_bits) + " make times of " +
                      std::to_string(time_bits(map, format)) + " bits and cell indices of " +
                      std::to_string(map.root_level + format.tile_bits) +
                      " bits on this map; at most 60 and 29 are accepted.");
  }
  if (map.surface == Surface::kBilinear && traverse.arithmetic == Arithmetic::kFixed) {
    throw usage_error(
        "The scene's surface is bilinear and traverse.arithmetic is fixed, the hardware's, which has no "
        "bilinear "
        "leaf; accepted with it are float, double: --set traverse.arithmetic=float.");
  }
  if (map.surface == Surface::kBilinear && format.fraction_bits == 0) {
    throw usage_error(
        "The scene's surface is bilinear and traverse.fraction_bits = 0 cannot hold the half texel by which "
        "its "
        "patches are shifted; accepted with it are 1 to 12.");
  }
  return format;
}

Algorithm algorithm_on(const Algorithm& algorithm, const TraverseParameters& traverse) {
  if (algorithm.search) {
    if (traverse.start || traverse.down || traverse.up || traverse.stop_level || traverse.fetch) {
      throw usage_error(
          "The architecture's [traverse] section sets parts of a schedule (start, down, up, "
          "stop_level or fetch), and " +
          algorithm.id + " is a search, which has none; accepted with it are exact algorithms.");
    }
    return algorithm;
  }
  Schedule schedule = algorithm.schedule;
  schedule.start = traverse.start.value_or(schedule.start);
  schedule.down = traverse.down.value_or(schedule.down);
  schedule.up = traverse.up.value_or(schedule.up);
  schedule.stop_level = traverse.stop_level.value_or(schedule.stop_level);
  schedule.fetch = traverse.fetch.value_or(schedule.fetch);
  return schedule == algorithm.schedule ? algorithm : parse_algorithm(name_of(schedule));
}

std::vector<Algorithm> distinct_on(const Architecture& architecture, std::span<const Algorithm> algorithms) {
  std::vector<Algorithm> distinct;
  for (const Algorithm& algorithm : algorithms) {
    Algorithm here = algorithm_on(algorithm, architecture.traverse);
    const bool known = std::any_of(distinct.begin(), distinct.end(),
                                   [&](const Algorithm& other) { return other.id == here.id; });
    if (!known) distinct.push_back(std::move(here));
  }
  return distinct;
}

void set_numbers(Workload& work, const Architecture& architecture) {
  work.arithmetic = architecture.traverse.arithmetic;
  work.format = number_format(architecture.traverse, work.map);
}

}  // namespace cuesta
