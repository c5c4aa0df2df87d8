#include "traces/ray_sets.h"

#include <algorithm>

#include "models/common/error.h"
#include "models/common/words.h"
#include "traces/ray_set_makers.h"
#include "traces/slab.h"

namespace cuesta {
namespace {

constexpr int kMostTileBits = 20;
constexpr uint64_t kGridWidth = 1024;
constexpr uint64_t kRaysBetweenWatches = 4096;

constexpr std::string_view kOne[] = {"all"};
constexpr std::string_view kAngles[] = {"descending, 0 to 30 degrees",     "descending, 30 to 60 degrees",
                                        "descending, 60 to 80 degrees",    "descending, 80 to 89 degrees",
                                        "descending, 89 to 89.99 degrees", "horizontal",
                                        "rising, 0 to 30 degrees",         "rising, 30 to 60 degrees",
                                        "rising, 60 to 80 degrees",        "rising, 80 to 89 degrees"};
// In the order of the enum in ray_set_adversarial.cpp.
constexpr std::string_view kHardCases[] = {
    "along an axis", "through corners", "along edges", "grazing to a slope of 1e-6", "horizontal", "rising",
    "straight down", "from the side",   "from inside", "over the most tiles"};

struct Row {
  RaySetKind kind;
  void (*make)(Random&, const RaySetPlace&, int, TracedRay&);
};

constexpr Row kRows[] = {
    {{"random", "Directions over the whole sphere of tile units, starts all over the slab.", kOne},
     make_random_ray},
    {{"stratified",
      "As many rays in each range of the angle to the surface's normal, over slabs of depth 0.05, 0.35 and "
      "1.",
      kAngles},
     make_stratified_ray},
    {{"lattice",
      "Starts on texel planes, middles, corners and whole heights; directions of small whole numbers: the "
      "ties.",
      kOne},
     make_lattice_ray},
    {{"adversarial", "As many rays of each hard case.", kHardCases}, make_adversarial_ray},
};

const Row& row_of(const RaySet& set) {
  std::vector<std::string_view> names;
  for (const Row& row : kRows) {
    if (row.kind.name == set.kind) return row;
    names.push_back(row.kind.name);
  }
  const std::string near = did_you_mean(set.kind, names);
  throw usage_error("There is no ray set `" + printable(set.kind) + "`; accepted are " + joined(names) +
                    (near.empty() ? "." : near));
}

/// The far edge of the last tile is no coordinate of the machine.
void keep_inside(int64_t tiles, TracedRay& ray) {
  const double most = static_cast<double>(tiles) - 0x1p-20;
  for (int axis = 0; axis < 2; ++axis) ray.origin[axis] = std::clamp(ray.origin[axis], -most, most);
}

}  // namespace

std::span<const RaySetKind> ray_set_kinds() {
  static const std::vector<RaySetKind> kinds = [] {
    std::vector<RaySetKind> all;
    for (const Row& row : kRows) all.push_back(row.kind);
    return all;
  }();
  return kinds;
}

void check_ray_set(const RaySet& set) {
  row_of(set);
  if (set.count < 1 || set.count > kMostPixels) {
    throw usage_error("A ray set of " + std::to_string(set.count) +
                      " rays was asked for; accepted are 1 to 2^28.");
  }
  if (set.tile_bits < 0 || set.tile_bits > kMostTileBits) {
    throw usage_error("A ray set for " + std::to_string(set.tile_bits) +
                      " tile bits was asked for; accepted are 0 to " + std::to_string(kMostTileBits) + ".");
  }
}

RayTrace make_ray_set(const RaySet& set, const MapShape& map, const RayWatch& watch) {
  check_ray_set(set);
  const Row& row = row_of(set);
  const RaySetPlace place{map, int64_t{1} << set.tile_bits};
  RayTrace trace{static_cast<int>(std::min(set.count, kGridWidth)),
                 static_cast<int>((set.count + kGridWidth - 1) / kGridWidth),
                 {}};
  trace.rays.reserve(set.count);
  Random random(set.seed);
  for (uint64_t k = 0; k < set.count; ++k) {
    TracedRay ray;
    ray.id = k;
    ray.pixel_x = static_cast<uint32_t>(k % kGridWidth);
    ray.pixel_y = static_cast<uint32_t>(k / kGridWidth);
    row.make(random, place, static_cast<int>(k % row.kind.classes.size()), ray);
    keep_inside(place.tiles, ray);
    trace.rays.push_back(ray);
    if ((k + 1) % kRaysBetweenWatches == 0) keep_watch(watch, k + 1);
  }
  return trace;
}

void start_in_slab(Random& random, const RaySetPlace& place, TracedRay& ray) {
  const bool repeats = place.map.address_mode != AddressMode::kBorder;
  for (double& value : ray.origin) value = uniform(random, 0.001, 0.999);
  const bool inside = random.chance(0.25);
  if (!inside && repeats && ray.direction[2] < 0) {
    ray.origin[2] = 1;
  } else if (!inside) {
    double largest = 0;
    for (double value : ray.direction) largest = std::max({largest, value, -value});
    for (int axis = 0; axis < 3; ++axis) ray.origin[axis] -= 2 / largest * ray.direction[axis];
    Slab{1, 1, false, 0, 0}.enter(ray);
  }
  if (!repeats) return;
  const int64_t most = std::min<int64_t>(place.tiles, 4);
  for (int axis = 0; axis < 2; ++axis) {
    ray.origin[axis] += static_cast<double>(random.between(-most, most - 1));
  }
}

}  // namespace cuesta
