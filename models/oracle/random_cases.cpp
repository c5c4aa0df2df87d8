#include "models/oracle/random_cases.h"

#include <algorithm>
#include <bit>
#include <cstdio>

#include "models/rays/map_shape.h"

namespace cuesta {
namespace {

enum class MapKind { kFlat, kNoise, kChecker, kSpikes, kSteps, kFractal, kNearlyFull, kCount };

constexpr std::string_view kMapKinds[] = {"flat",  "noise",   "checker",    "spikes",
                                          "steps", "fractal", "nearly full"};

int random_side(Random& random, int max_side) {
  const int side = static_cast<int>(random.between(1, max_side));
  switch (random.below(5)) {
    case 0:
      return 1;
    case 1:
      return static_cast<int>(std::bit_floor(static_cast<unsigned>(side)));
    case 2:
      return std::min(max_side, static_cast<int>(std::bit_floor(static_cast<unsigned>(side))) + 1);
    default:
      return side;
  }
}

/// Sum of hashed lattice values at halving distances, 0 to 1.
double fractal_height(uint64_t seed, int i, int j) {
  double sum = 0, weight = 0.5;
  for (int shift = 4; shift >= 0; --shift, weight *= 0.5) {
    const uint64_t cell = seed + static_cast<uint64_t>(i >> shift) * 0x9E3779B97F4A7C15ull +
                          static_cast<uint64_t>(j >> shift) * 0xC2B2AE3D27D4EB4Full +
                          static_cast<uint64_t>(shift);
    sum += weight * static_cast<double>(Random::mix(cell) >> 11) * 0x1p-53;
  }
  return sum;
}

void fill(Random& random, MapKind kind, HeightGrid& grid) {
  const auto full = static_cast<int64_t>(grid.full_scale());
  const int64_t low = random.between(0, full), high = random.chance(0.3) ? full : random.between(low, full);
  const uint64_t seed = random.next();
  const double rarity = random.chance(0.5) ? 0.02 : 0.2;
  for (int j = 0; j < grid.height; ++j) {
    for (int i = 0; i < grid.width; ++i) {
      int64_t value = low;
      switch (kind) {
        case MapKind::kNoise:
          value = random.between(low, high);
          break;
        case MapKind::kChecker:
          value = ((i ^ j) & 1) != 0 ? high : low;
          break;
        case MapKind::kSpikes:
          value = random.chance(rarity) ? high : low;
          break;
        case MapKind::kSteps:
          value = std::min(full, low + (high - low) * (i / 3 + j / 2) / 8);
          break;
        case MapKind::kFractal:
          value = static_cast<int64_t>(fractal_height(seed, i, j) * static_cast<double>(full));
          break;
        case MapKind::kNearlyFull:
          value = random.between(std::max<int64_t>(0, full - 2), full);
          break;
        default:
          break;
      }
      grid.at(i, j) = static_cast<uint16_t>(value);
    }
  }
}

/// A coordinate along an axis of `size` texels, by preference on a plane or between two.
double random_position(Random& random, double size, int fraction_bits, double spread) {
  const double low = -spread * size;
  const double position = low + random.unit() * (1 + 2 * spread) * size;
  const auto whole = static_cast<double>(static_cast<int64_t>(position));
  const double grid = static_cast<double>(int64_t{1} << fraction_bits);
  switch (random.below(5)) {
    case 0:
      return whole;
    case 1:
      return whole + 0.5;
    case 2:
      return static_cast<double>(static_cast<int64_t>(position * grid)) / grid;
    case 3:
      return random.chance(0.5) ? 0.0 : size;
    default:
      return position;
  }
}

/// A component of a direction in texels: zero, small and whole, tiny, or anything.
double random_component(Random& random) {
  const double sign = random.chance(0.5) ? -1 : 1;
  switch (random.below(6)) {
    case 0:
      return 0;
    case 1:
      return sign;
    case 2:
      return sign * static_cast<double>(random.between(1, 8));
    case 3:
      return sign * random.unit() * 0x1p-20;
    default:
      return sign * random.unit();
  }
}

/// Origin and direction in texels and height LSBs.
struct Placed {
  double origin[3];
  double direction[3];
};

/// Planes and heights are crossed at whole ratios, often together: from a whole or half place near some texel's
/// height, a few texels and LSBs at a time.
Placed whole_ray(Random& random, const RandomMap& map) {
  const HeightGrid& grid = map.grid;
  const auto full = static_cast<int64_t>(grid.full_scale());
  const int64_t height = grid.texels[random.below(grid.texels.size())];
  const double rise = static_cast<double>(int64_t{1} << random.between(0, grid.bits / 2));
  const auto half = [&](int64_t least, int64_t most) {
    return static_cast<double>(random.between(least, most)) / 2;
  };
  Placed ray;
  ray.origin[0] = half(0, 2 * grid.width);
  ray.origin[1] = half(0, 2 * grid.height);
  ray.origin[2] = static_cast<double>(std::clamp<int64_t>(height + random.between(-3, 6), 0, full));
  ray.direction[0] = static_cast<double>(random.between(-3, 3));
  ray.direction[1] = random.chance(0.2) ? ray.direction[0] : static_cast<double>(random.between(-3, 3));
  ray.direction[2] = static_cast<double>(random.between(-3, 2)) * rise;
  if (ray.direction[2] < 0 && random.chance(0.5)) {  // from higher up on the same line
    const auto up = static_cast<double>(random.between(1, 6));
    if (ray.origin[2] - up * ray.direction[2] <= static_cast<double>(full)) {
      for (int axis = 0; axis < 3; ++axis) ray.origin[axis] -= up * ray.direction[axis];
    }
  }
  return ray;
}

/// Anything, with favourite places.
Placed free_ray(Random& random, const RandomMap& map, const double (&size)[3]) {
  const int f = map.format.fraction_bits;
  const double spread = map.shape.address_mode == AddressMode::kBorder && random.chance(0.5) ? 0.9 : 0;
  Placed ray;
  ray.origin[0] = random_position(random, size[0], f, spread);
  ray.origin[1] = random_position(random, size[1], f, spread);
  ray.origin[2] = random_position(random, size[2], f, 0);
  ray.direction[0] = random_component(random);
  ray.direction[1] = random_component(random);
  const double steep = random.chance(0.5) ? 1 : size[2];
  const uint64_t slope = random.below(8);
  if (slope == 0) {
    ray.direction[2] = 0;
  } else if (slope == 1) {  // rises from below the heights
    ray.direction[2] = random.unit() * steep / 16;
    ray.origin[2] *= random.unit();
  } else {
    const double down = random_component(random) * (slope < 5 ? steep / 16 : steep);
    ray.direction[2] = down < 0 ? down : -down;
    if (random.chance(0.5)) ray.origin[2] = size[2];
    if (random.chance(0.1)) ray.origin[2] += random.unit() * size[2];
  }
  return ray;
}

NumberFormat random_format(Random& random, int bits) {
  NumberFormat format;
  format.mantissa_bits = std::min(24, bits + 4);
  if (random.chance(0.5)) return format;
  format.fraction_bits = static_cast<int>(random.between(0, 12));
  format.direction_bits = static_cast<int>(random.between(8, 32));
  format.mantissa_bits = static_cast<int>(random.between(2, 24));
  format.tile_bits = static_cast<int>(random.between(0, 6));
  return format;
}

}  // namespace

RandomMap random_map(uint64_t seed, int max_side) {
  Random random(seed);
  RandomMap map;
  map.seed = seed;
  map.grid.width = random_side(random, max_side);
  map.grid.height = random.chance(0.3) ? map.grid.width : random_side(random, max_side);
  map.grid.bits =
      random.chance(0.6) ? (random.chance(0.5) ? 8 : 16) : static_cast<int>(random.between(1, 16));
  map.grid.texels.resize(static_cast<size_t>(map.grid.width) * static_cast<size_t>(map.grid.height));
  const auto kind = static_cast<MapKind>(random.below(static_cast<uint64_t>(MapKind::kCount)));
  map.kind = kMapKinds[static_cast<size_t>(kind)];
  fill(random, kind, map.grid);
  const auto mode = static_cast<AddressMode>(random.below(4));
  map.shape = map_shape(map.grid.width, map.grid.height, map.grid.bits, mode);
  map.format = random_format(random, map.grid.bits);
  return map;
}

TracedRay random_ray(Random& random, const RandomMap& map, uint64_t id) {
  const double size[3] = {static_cast<double>(map.grid.width), static_cast<double>(map.grid.height),
                          static_cast<double>(map.grid.full_scale())};
  TracedRay ray;
  ray.id = id;
  Placed placed = random.chance(0.4) ? whole_ray(random, map) : free_ray(random, map, size);
  if (placed.direction[0] == 0 && placed.direction[1] == 0 && placed.direction[2] == 0)
    placed.direction[2] = -1;
  if (random.chance(0.3)) {
    ray.t_max = static_cast<double>(random.between(1, 16)) * (random.chance(0.5) ? 1 : 0.37);
  }
  if (random.chance(0.2)) {  // a secondary ray, as if from a wall or a top
    ray.kind = RayKind::kShadow;
    const uint64_t axis = random.below(3);
    ray.fixed_axis = static_cast<FixedAxis>(axis + 1);
    ray.fixed_coordinate = static_cast<int32_t>(random.below(static_cast<uint64_t>(size[axis]) + 1));
    placed.origin[axis] = ray.fixed_coordinate;
    placed.origin[2] = std::min(placed.origin[2], size[2]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    ray.origin[axis] = placed.origin[axis] / size[axis];
    ray.direction[axis] = placed.direction[axis] / size[axis];
  }
  return ray;
}

std::string describe(const RandomMap& map) {
  char text[256];
  std::snprintf(text, sizeof text, "map seed %llu: %s, %d x %d, %d bits, %s; f %d, D %d, M %d, w2 %d",
                static_cast<unsigned long long>(map.seed), std::string(map.kind).c_str(), map.grid.width,
                map.grid.height, map.grid.bits, std::string(name_of(map.shape.address_mode)).c_str(),
                map.format.fraction_bits, map.format.direction_bits, map.format.mantissa_bits,
                map.format.tile_bits);
  return text;
}

std::string describe(const TracedRay& ray) {
  char text[512];
  std::snprintf(
      text, sizeof text,
      "ray %llu: origin (%.17g, %.17g, %.17g), direction (%.17g, %.17g, %.17g), t %.17g to %.17g, kind %d, "
      "fixed axis %d at %d",
      static_cast<unsigned long long>(ray.id), ray.origin[0], ray.origin[1], ray.origin[2], ray.direction[0],
      ray.direction[1], ray.direction[2], ray.t_min, ray.t_max, static_cast<int>(ray.kind),
      static_cast<int>(ray.fixed_axis), ray.fixed_coordinate);
  return text;
}

std::string describe(const MachineRay& ray) {
  char text[256];
  std::snprintf(text, sizeof text, "x0 %lld, y0 %lld, z0 %lld, dx %lld, dy %lld, dz %lld, t_max %lld, q %d%s",
                static_cast<long long>(ray.x0), static_cast<long long>(ray.y0),
                static_cast<long long>(ray.z0), static_cast<long long>(ray.dx),
                static_cast<long long>(ray.dy), static_cast<long long>(ray.dz),
                static_cast<long long>(ray.t_max), ray.exponent, ray.dead ? ", dead" : "");
  return text;
}

}  // namespace cuesta
