#include "sim/explore/adversary/adversary_case.h"

#include <algorithm>

namespace cuesta {
namespace {

/// Draws a coordinate of a tile: anywhere, on a plane, in a texel's middle.
double any_place(Random& random, int texels) {
  const auto index = static_cast<double>(random.below(static_cast<uint64_t>(texels)));
  switch (random.below(4)) {
    case 0:
      return index / texels;
    case 1:
      return (index + 0.5) / texels;
    default:
      return random.unit();
  }
}

/// Draws how far a ray moves along an axis: not at all, as far as it may, by whole texels, or by anything.
double any_reach(Random& random, int texels, double reach) {
  switch (random.below(6)) {
    case 0:
      return 0;
    case 1:
      return random.chance(0.5) ? reach : -reach;
    case 2: {  // whole texels
      const auto most = static_cast<int64_t>(reach * texels);
      return static_cast<double>(random.between(-most, most)) / texels;
    }
    default:
      return (2 * random.unit() - 1) * reach;
  }
}

FallingRay any_ray(Random& random, const AdversaryBounds& bounds) {
  return {any_place(random, bounds.width), any_place(random, bounds.height),
          any_reach(random, bounds.width, bounds.reach), any_reach(random, bounds.height, bounds.reach)};
}

/// Draws a height: full scale, the floor, near `near`, just it, or anything.
uint16_t any_height(Random& random, const HeightGrid& grid, uint16_t near) {
  const auto full = static_cast<int64_t>(grid.full_scale());
  switch (random.below(5)) {
    case 0:
      return static_cast<uint16_t>(full);
    case 1:
      return 0;
    case 2:
      return static_cast<uint16_t>(std::clamp<int64_t>(near + random.between(-3, 3), 0, full));
    case 3:
      return near;
    default:
      return static_cast<uint16_t>(random.between(0, full));
  }
}

int any_index(Random& random, int size) {
  return static_cast<int>(random.below(static_cast<uint64_t>(size)));
}

/// Changes a block of texels: to one height, up or down, or to what stands elsewhere.
void change_block(Random& random, HeightGrid& grid) {
  const int longest = std::max(1, std::max(grid.width, grid.height) / (random.chance(0.5) ? 8 : 2));
  const bool row = random.chance(0.2), column = !row && random.chance(0.2);
  const int wide = column ? 1 : 1 + any_index(random, std::min(grid.width, longest));
  const int high = row ? 1 : 1 + any_index(random, std::min(grid.height, longest));
  const int i0 = any_index(random, grid.width), j0 = any_index(random, grid.height);
  const int from_i = any_index(random, grid.width), from_j = any_index(random, grid.height);
  const auto full = static_cast<int64_t>(grid.full_scale());
  const uint64_t how = random.below(3);
  const uint16_t height = any_height(random, grid, grid.at(i0, j0));
  const int64_t moved = random.between(-full / 4 - 1, full / 4 + 1);
  const HeightGrid before = grid;
  for (int b = 0; b < high; ++b) {
    for (int a = 0; a < wide; ++a) {
      uint16_t& texel = grid.at((i0 + a) % grid.width, (j0 + b) % grid.height);
      texel = how == 0   ? height
              : how == 1 ? static_cast<uint16_t>(std::clamp<int64_t>(texel + moved, 0, full))
                         : before.at((from_i + a) % grid.width, (from_j + b) % grid.height);
    }
  }
}

/// Brings a place into the tile: [0, 1).
double wrapped(double place) {
  const double whole = static_cast<double>(static_cast<int64_t>(place)) - (place < 0 ? 1 : 0);
  const double inside = place - whole;
  return inside < 1 ? inside : 0;
}

/// Changes one ray: makes it anew, copies another one, or moves its entry or its end.
void change_ray(Random& random, std::vector<FallingRay>& rays, const AdversaryBounds& bounds) {
  FallingRay& ray = rays[random.below(rays.size())];
  const uint64_t how = random.below(5);
  if (how == 0) {
    ray = any_ray(random, bounds);
    return;
  }
  if (how == 1) ray = rays[random.below(rays.size())];
  const double little = random.chance(0.5) ? 1.0 / bounds.width : 0x1p-10;
  const auto nudge = [&](double value) { return value + (2 * random.unit() - 1) * little; };
  const auto clipped = [&](double value) { return std::clamp(value, -bounds.reach, bounds.reach); };
  if (how == 2) {
    ray.u = random.chance(0.5) ? any_place(random, bounds.width) : wrapped(nudge(ray.u));
  } else if (how == 3) {
    ray.v = random.chance(0.5) ? any_place(random, bounds.height) : wrapped(nudge(ray.v));
  } else {
    ray.du = random.chance(0.2) ? any_reach(random, bounds.width, bounds.reach) : clipped(nudge(ray.du));
    ray.dv = random.chance(0.2) ? any_reach(random, bounds.height, bounds.reach) : clipped(nudge(ray.dv));
  }
}

/// Fills a map: flat, noise, spikes, pits, checker or steps.
void fill(Random& random, HeightGrid& grid) {
  const auto full = static_cast<int64_t>(grid.full_scale());
  const uint64_t kind = random.below(6);
  const int64_t low = random.between(0, full / 2),
                high = random.chance(0.5) ? full : random.between(low, full);
  const double rarity = random.chance(0.5) ? 0.03 : 0.2;
  const int64_t wide = random.between(1, 6);
  for (int j = 0; j < grid.height; ++j) {
    for (int i = 0; i < grid.width; ++i) {
      int64_t value = low;
      if (kind == 1) value = random.between(low, high);
      if (kind == 2) value = random.chance(rarity) ? high : low;
      if (kind == 3) value = random.chance(rarity) ? low : high;
      if (kind == 4) value = (i / wide + j / wide) % 2 != 0 ? high : low;
      if (kind == 5) value = low + (high - low) * (i / wide + j / wide) / (grid.width + grid.height);
      grid.at(i, j) = static_cast<uint16_t>(value);
    }
  }
}

}  // namespace

std::vector<TracedRay> AdversaryCase::traced() const {
  std::vector<TracedRay> list;
  list.reserve(rays.size());
  for (const FallingRay& ray : rays) {
    TracedRay traced;
    traced.id = list.size();
    traced.pixel_x = static_cast<uint32_t>(list.size());
    traced.origin[0] = ray.u;
    traced.origin[1] = ray.v;
    traced.origin[2] = 1;
    traced.direction[0] = ray.du;
    traced.direction[1] = ray.dv;
    traced.direction[2] = -1;
    list.push_back(traced);
  }
  return list;
}

AdversaryCase random_adversary_case(Random& random, const AdversaryBounds& bounds) {
  AdversaryCase made;
  made.grid = {bounds.width, bounds.height, bounds.bits, {}};
  made.grid.texels.resize(static_cast<size_t>(bounds.width) * static_cast<size_t>(bounds.height));
  fill(random, made.grid);
  for (int k = 0; k < bounds.rays; ++k) made.rays.push_back(any_ray(random, bounds));
  return made;
}

AdversaryCase changed(Random& random, const AdversaryCase& from, const AdversaryBounds& bounds) {
  AdversaryCase made = from;
  for (int64_t changes = random.between(1, 3); changes > 0; --changes) {
    switch (random.below(5)) {
      case 0:
      case 1:
        change_ray(random, made.rays, bounds);
        break;
      case 2:
        change_block(random, made.grid);
        break;
      default: {
        uint16_t& texel =
            made.grid.at(any_index(random, made.grid.width), any_index(random, made.grid.height));
        texel = any_height(random, made.grid, texel);
      }
    }
  }
  return made;
}

AdversaryCase crossed(Random& random, const AdversaryCase& a, const AdversaryCase& b) {
  AdversaryCase made = a;
  for (size_t k = 0; k < made.rays.size(); ++k) {
    if (random.chance(0.5)) made.rays[k] = b.rays[k];
  }
  return made;
}

}  // namespace cuesta
