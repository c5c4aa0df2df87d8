#include "tests/hard_cases/metamorphic.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "models/common/error.h"
#include "models/heightmap/pyramid.h"
#include "models/oracle/checked_walks.h"
#include "models/oracle/random_cases.h"
#include "models/rays/map_shape.h"
#include "models/search/search_map.h"
#include "models/traversal/traversal.h"

namespace cuesta {
namespace {

/// A map of another size, filled by `of(i, j)`; the ray is kept.
template <class Of>
Instance with_map(const Instance& from, int width, int height, Of&& of) {
  Instance made = from;
  made.grid = {width, height, from.grid.bits, {}};
  made.grid.texels.resize(static_cast<size_t>(width) * static_cast<size_t>(height));
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) made.grid.at(i, j) = of(i, j);
  }
  made.shape = map_shape(width, height, from.shape.bits, from.shape.address_mode, from.shape.surface);
  return made;
}

/// A ray that does not move along an axis and runs on one of its planes belongs to the cell behind it once mirrored.
bool runs_on_a_plane(int64_t origin, int64_t d, int fraction_bits) {
  return d == 0 && (origin & ((int64_t{1} << fraction_bits) - 1)) == 0;
}

HitFace other_wall(HitFace face) {
  return face == HitFace::kWallX ? HitFace::kWallY : face == HitFace::kWallY ? HitFace::kWallX : face;
}

using Move = std::optional<Moved>;

Move mirror(const Instance& from, const HitRecord& found, Arithmetic, uint64_t) {
  const int w = from.grid.width, f = from.format.fraction_bits;
  if (runs_on_a_plane(from.ray.x0, from.ray.dx, f)) return {};
  Moved to{with_map(from, w, from.grid.height, [&](int i, int j) { return from.grid.at(w - 1 - i, j); }),
           found};
  to.instance.ray.x0 = (int64_t{w} << f) - from.ray.x0;
  to.instance.ray.dx = -from.ray.dx;
  if (found.status == HitStatus::kHit) to.expected.i = w - 1 - found.i;
  return to;
}

Move transpose(const Instance& from, const HitRecord& found, Arithmetic, uint64_t) {
  Moved to{
      with_map(from, from.grid.height, from.grid.width, [&](int i, int j) { return from.grid.at(j, i); }),
      found};
  std::swap(to.instance.ray.x0, to.instance.ray.y0);
  std::swap(to.instance.ray.dx, to.instance.ray.dy);
  std::swap(to.expected.i, to.expected.j);
  to.expected.face = other_wall(found.face);
  return to;
}

Move rotate(const Instance& from, const HitRecord& found, Arithmetic arithmetic, uint64_t seed) {
  const Move turned = transpose(from, found, arithmetic, seed);
  return mirror(turned->instance, turned->expected, arithmetic, seed);
}

/// By whole texels, the map and the ray together.
Move shift(const Instance& from, const HitRecord& found, Arithmetic arithmetic, uint64_t seed) {
  if (from.shape.address_mode != AddressMode::kWrap) return {};
  const int w = from.grid.width, h = from.grid.height, f = from.format.fraction_bits;
  const int a = 1 + static_cast<int>(seed % 3), b = static_cast<int>(seed / 3 % 3);
  Moved to{with_map(from, w, h,
                    [&](int i, int j) {
                      return from.grid.at(stored_index(i - a, w, AddressMode::kWrap),
                                          stored_index(j - b, h, AddressMode::kWrap));
                    }),
           found};
  MachineRay& ray = to.instance.ray;
  ray.x0 += int64_t{a} << f;
  ray.y0 += int64_t{b} << f;
  // The machine's own range; and for float, origins without rounding on both sides.
  const int64_t most = int64_t{1} << (from.shape.root_level + from.format.tile_bits + f);
  const int64_t whole = arithmetic == Arithmetic::kFloat ? int64_t{1} << 22 : most;
  for (const int64_t place : {ray.x0, ray.y0, from.ray.x0, from.ray.y0}) {
    if (std::abs(place) >= std::min(most, whole)) return {};
  }
  if (found.status == HitStatus::kHit) {
    to.expected.i += a;
    to.expected.j += b;
  }
  return to;
}

/// One bit more of height: every height, the ray's and its speed twice as much.
Move scale_heights(const Instance& from, const HitRecord& found, Arithmetic arithmetic, uint64_t) {
  MachineRay ray = from.ray;
  if (from.grid.bits == 16 || std::abs(ray.dz) >= int64_t{1} << (from.format.direction_bits - 1)) return {};
  // In float the smaller of two roundings of the origin may not be the larger's half.
  if (arithmetic == Arithmetic::kFloat && ray.z0 >= int64_t{1} << 23) return {};
  Moved to{with_map(from, from.grid.width, from.grid.height,
                    [&](int i, int j) { return static_cast<uint16_t>(2 * from.grid.at(i, j)); }),
           found};
  ++to.instance.grid.bits;
  ++to.instance.shape.bits;
  ray.z0 *= 2;
  ray.dz *= 2;
  to.instance.ray = ray;
  return to;
}

/// The texels that the ray can ask, from its start to its hit, or to its end where it has none.
std::set<std::pair<int, int>> path_of(const Instance& instance, Arithmetic arithmetic) {
  std::set<std::pair<int, int>> path;
  const int64_t limit = most_steps(instance.shape, instance.format);
  with_traversal_types(arithmetic, instance.shape, [&]<class A, class G>() {
    // Full scale as the map's maximum: where a raised texel would let a rising ray go on.
    const Walk<A, G> walk(instance.shape, instance.format, {StartRule::kLeaf, 1, UpRule::kNever},
                          static_cast<int32_t>(instance.grid.full_scale()));
    RayState<A, G> ray;
    Visit now = start(walk, instance.ray, ray);
    while (now == Visit::kContinue && int64_t{ray.steps} <= limit) {
      const int i = static_cast<int>(ray.gx.fetch_index(walk.x, 0)),
                j = static_cast<int>(ray.gy.fetch_index(walk.y, 0));
      path.insert({i, j});
      now = visit(walk, ray, instance.grid.at(i, j));
    }
  });
  return path;
}

Move raise_off_the_path(const Instance& from, const HitRecord& found, Arithmetic arithmetic, uint64_t seed) {
  const auto path = path_of(from, arithmetic);
  std::vector<std::pair<int, int>> others;
  for (int j = 0; j < from.grid.height; ++j) {
    for (int i = 0; i < from.grid.width; ++i) {
      if (!path.contains({i, j})) others.emplace_back(i, j);
    }
  }
  if (others.empty()) return {};
  Moved to{from, found};
  const auto [i, j] = others[seed % others.size()];
  to.instance.grid.at(i, j) = static_cast<uint16_t>(from.grid.full_scale());
  return to;
}

/// The map beside itself, twice each way, or in mirror mode beside its mirror images: then wrapped.
Move tile(const Instance& from, const HitRecord& found, Arithmetic, uint64_t) {
  const AddressMode mode = from.shape.address_mode;
  if (mode != AddressMode::kWrap && mode != AddressMode::kMirror) return {};
  const int w = from.grid.width, h = from.grid.height;
  Moved to{with_map(from, 2 * w, 2 * h,
                    [&](int i, int j) {
                      return from.grid.at(stored_index(i, w, mode), stored_index(j, h, mode));
                    }),
           found};
  to.instance.shape.address_mode = AddressMode::kWrap;
  return to;
}

/// A ray that ends at its hit has none; one unit of time later it has it.
Move end_at_the_hit(const Instance& from, const HitRecord& found, Arithmetic arithmetic, uint64_t seed) {
  if (arithmetic != Arithmetic::kFixed || found.status != HitStatus::kHit) return {};
  const bool just_after = seed % 2 != 0;
  Moved to{from, just_after ? found : HitRecord{}};
  to.instance.ray.t_max = found.t + (just_after ? 1 : 0);
  return to;
}

constexpr Relation kRelations[] = {
    {"mirror", "fixed, float and double, but for rays on a plane that they never leave", mirror, false,
     false},
    {"transpose", "fixed, float and double", transpose, true, true},
    {"rotate by 90 degrees", "fixed, float and double, but for rays on a plane that they never leave", rotate,
     false, true},
    {"shift by texels", "fixed and double; float where origins have 22 bits", shift, false, false},
    {"double the heights", "fixed and double; float where heights have 23 bits", scale_heights, false, false},
    {"raise a texel off the path", "fixed, float and double", raise_off_the_path, false, false},
    {"tile", "fixed, float and double", tile, false, false},
    {"end at the hit", "fixed", end_at_the_hit, false, false},
};

/// With the ray kept within the numbers of a changed map.
bool fits(const Instance& instance) {
  const int f = instance.format.fraction_bits;
  const int64_t most = int64_t{1} << (instance.shape.root_level + instance.format.tile_bits + f);
  return std::abs(instance.ray.x0) < most && std::abs(instance.ray.y0) < most;
}

}  // namespace

std::span<const Relation> relations() { return kRelations; }

HitRecord walk(const Instance& instance, Arithmetic arithmetic, const Schedule& schedule) {
  const Pyramid pyramid = build_max_pyramid(instance.grid);
  const int64_t limit = most_steps(instance.shape, instance.format);
  return with_traversal_types(arithmetic, instance.shape, [&]<class A, class G>() {
    const Walk<A, G> walk(instance.shape, instance.format, schedule, pyramid.highest());
    RayState<A, G> ray;
    Visit now = start(walk, instance.ray, ray);
    while (now == Visit::kContinue) {
      const int i = static_cast<int>(ray.gx.fetch_index(walk.x, ray.level));
      const int j = static_cast<int>(ray.gy.fetch_index(walk.y, ray.level));
      now = visit(walk, ray, pyramid.at(ray.level, i, j));
      if (int64_t{ray.steps} > limit) {
        HitRecord record;
        record.status = HitStatus::kDidNotFinish;
        return record;
      }
    }
    return hit_record(walk, ray, instance.ray.id, now);
  });
}

bool agree(const Relation& relation, const HitRecord& expected, const HitRecord& found) {
  if (same_answer(expected, found)) return true;
  HitRecord in_the_corner = expected;
  in_the_corner.face = HitFace::kWallX;
  return relation.swaps_axes && expected.face == HitFace::kWallY && same_answer(in_the_corner, found);
}

std::optional<Instance> random_instance(Random& random, int max_side) {
  const RandomMap map = random_map(random.next(), max_side);
  const TracedRay ray = random_ray(random, map, 1);
  try {
    return Instance{map.grid, map.shape, map.format, quantise(ray, map.shape, map.format)};
  } catch (const Error&) {  // beyond this format's tiles
    return {};
  }
}

Instance shrink(const Instance& failing, const std::function<bool(const Instance&)>& fails) {
  Instance least = failing;
  bool smaller = true;
  const auto attempt = [&](Instance candidate) {
    const int64_t t_end = (int64_t{1} << time_bits(candidate.shape, candidate.format)) - 1;
    candidate.ray.t_max = std::min(candidate.ray.t_max, t_end);
    if (!fits(candidate) || !fails(candidate)) return false;
    least = std::move(candidate);
    smaller = true;
    return true;
  };
  while (smaller) {
    smaller = false;
    for (const bool along_x : {true, false}) {
      const int w = least.grid.width, h = least.grid.height, side = along_x ? w : h;
      for (const int to : {side / 2, side - 1}) {
        if (to < 1) continue;
        const auto same = [&](int i, int j) { return least.grid.at(i, j); };
        if (attempt(with_map(least, along_x ? to : w, along_x ? h : to, same))) break;
      }
    }
    for (size_t k = 0; k < least.grid.texels.size(); ++k) {
      const auto full = static_cast<uint16_t>(least.grid.full_scale());
      const uint16_t now = least.grid.texels[k];
      for (const uint16_t to : {uint16_t{0}, full, static_cast<uint16_t>(now / 2)}) {
        if (now == to || now == 0 || (now == full && to != 0)) continue;
        Instance candidate = least;
        candidate.grid.texels[k] = to;
        if (attempt(candidate)) break;
      }
    }
    const auto ray_with = [&](int64_t MachineRay::*part, int64_t value) {
      if (least.ray.*part == value) return;
      Instance candidate = least;
      candidate.ray.*part = value;
      attempt(candidate);
    };
    const int64_t largest = int64_t{1} << (least.format.direction_bits - 1);
    for (const auto part : {&MachineRay::dx, &MachineRay::dy, &MachineRay::dz}) {
      const int64_t now = least.ray.*part;
      if (now == 0 || std::abs(now) == largest) continue;
      const int64_t sign = now < 0 ? -1 : 1;
      if (std::abs(now) > largest) {  // the largest component keeps its top bit
        ray_with(part, sign * largest);
      } else {
        ray_with(part, 0);
        if (least.ray.*part != 0 && std::abs(now) != largest / 2) ray_with(part, sign * (largest / 2));
      }
    }
    for (const auto part : {&MachineRay::x0, &MachineRay::y0, &MachineRay::z0}) {
      const int64_t now = least.ray.*part;
      if (now == 0) continue;
      ray_with(part, 0);
      if (least.ray.*part == now)
        ray_with(part, now >> least.format.fraction_bits << least.format.fraction_bits);
    }
  }
  return least;
}

std::string describe(const Instance& instance) {
  const HeightGrid& grid = instance.grid;
  std::string text = std::to_string(grid.width) + " x " + std::to_string(grid.height) + ", " +
                     std::to_string(grid.bits) + " bits, " +
                     std::string(name_of(instance.shape.address_mode)) + "; f " +
                     std::to_string(instance.format.fraction_bits) + ", D " +
                     std::to_string(instance.format.direction_bits) + ", M " +
                     std::to_string(instance.format.mantissa_bits) + ", w2 " +
                     std::to_string(instance.format.tile_bits) + "\n  " + describe(instance.ray);
  for (int j = 0; j < std::min(grid.height, 16); ++j) {
    text += "\n ";
    for (int i = 0; i < std::min(grid.width, 16); ++i) text += " " + std::to_string(grid.at(i, j));
  }
  return text;
}

}  // namespace cuesta
