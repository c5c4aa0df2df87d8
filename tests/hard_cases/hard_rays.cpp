#include <array>
#include <limits>

#include "models/oracle/random_cases.h"
#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/rays_in_texels.h"

namespace cuesta {
namespace {

constexpr std::array<std::array<double, 2>, 4> kAxes = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
constexpr std::array<std::array<double, 2>, 4> kDiagonals = {{{1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};

void axis(Rays& r) {
  for (const auto& [x, y] : kAxes) {
    r.pick();
    for (const double slope : {-r.full(), -r.full() / 16, -1.0}) {
      r.add({r.i() + 0.5, r.j() + 0.5, r.full()}, {x, y, slope});
      r.add({r.i() + 0.3, r.j() + 0.7, r.top() + 1}, {x, y, slope / 8});
    }
  }
}

void diagonal(Rays& r) {
  for (const auto& [x, y] : kDiagonals) {
    r.pick();
    for (const double slope : {-r.full() / 4, -3.0, -0.5}) {
      r.add({r.i(), r.j(), r.full()}, {x, y, slope});
      r.add({r.i() + 0.5, r.j() + 0.5, r.top() + 2}, {x, y, slope});
    }
  }
}

void corners(Rays& r) {
  for (const auto& [x, y] : kDiagonals) {
    for (const auto& [p, q] : {std::array<double, 2>{1, 2}, {3, 2}, {1, 5}}) {
      r.pick();
      const double down = static_cast<double>(r.random().between(0, 4));
      const double back = down > 0 ? std::min(3.0, (r.full() - r.top()) / down) : 3;
      // At the texel's corner the ray has exactly the texel's height.
      r.add({r.i() - back * p * x, r.j() - back * q * y, r.top() + back * down}, {p * x, q * y, -down});
    }
  }
}

void edges(Rays& r) {
  for (const auto& [x, y] : kAxes) {
    r.pick();
    const double along_x = y != 0 ? r.i() : r.i() + 0.25, along_y = x != 0 ? r.j() : r.j() + 0.25;
    r.add({along_x, along_y, r.full()}, {x, y, -r.full() / 8});
    r.add({along_x, along_y, r.top()}, {x, y, 0});
    r.add({along_x, along_y, r.top()}, {x, y, -1});
    // Along the map's own sides.
    r.add({y != 0 ? 0 : along_x, x != 0 ? 0 : along_y, r.full()}, {x, y, -2});
    r.add({y != 0 ? r.width() : along_x, x != 0 ? r.height() : along_y, r.full()}, {x, y, -2});
  }
}

void on_a_plane(Rays& r) {
  for (const auto& [x, y] : kDiagonals) {
    r.pick();
    r.add({r.i(), r.j() + 0.4, r.top() + 1}, {x, y * 0.37, -1});
    r.add({r.i() + 0.6, r.j(), r.top() + r.grid_step()}, {x * 0.21, y, -0.25});
    r.add({r.i(), r.j(), r.top()}, {x * 0.9, y * 0.31, -1});
    r.add({r.i(), r.j(), r.top()}, {x * 0.9, y * 0.31, 1});
  }
}

void sides(Rays& r) {
  for (const double x : {0.0, 0.5 * r.width(), r.width()}) {
    for (const double y : {0.0, r.height()}) {
      r.pick();
      r.add({x, y, r.top() + 1}, {x > 0 ? -1.0 : 1.0, y > 0 ? -0.7 : 0.7, -1});
      r.add({x, y, r.full()}, {x > 0 ? 1.0 : -1.0, y > 0 ? 0.5 : -0.5, -1});
    }
  }
}

void grazing(Rays& r) {
  double slope = 0.1;
  for (int decade = 1; decade <= 12; ++decade, slope /= 10) {
    r.pick();
    const std::array<double, 3> in_tiles = {(r.i() + 0.5) / r.width(), (r.j() + 0.1) / r.height(),
                                            decade % 2 != 0 ? 1.0 : (r.top() + 1) / (r.full() + 1)};
    r.add_traced(in_tiles, {decade % 3 != 0 ? 1.0 : -1.0, r.random().unit() - 0.5, -slope});
    r.add_traced(in_tiles, {0.0, decade % 2 != 0 ? 1.0 : -1.0, -slope});
  }
}

void horizontal(Rays& r) {
  r.pick();
  for (const double z : {0.0, r.top(), r.top() + 0.5, r.top() - r.grid_step(), r.full()}) {
    if (z < 0 || z > r.full()) continue;
    r.add({r.i() + 0.5, r.j() + 0.5, z}, {1, 0, 0});
    r.add({r.i() + 0.5, r.j(), z}, {-1, -1, 0}, 2.5 * r.width());
    r.add({r.i() + 0.1, r.j() + 0.9, z}, {0.3, -1, 0}, 30);
  }
}

void rising(Rays& r) {
  for (const double slope : {1e-12, 1e-6, 1e-3, 0.1, 1.0, 4.0}) {
    r.pick();
    const double u = (r.i() + 0.5) / r.width(), v = (r.j() + 0.5) / r.height(), z = r.top() / r.full();
    r.add_traced({u, v, z}, {1, 0.3, slope});       // from a top
    r.add_traced({u, v, z / 2}, {-1, 0.2, slope});  // from inside
    r.add_traced({u, r.j() / r.height(), 0}, {0, -1, slope});
  }
}

void vertical(Rays& r) {
  for (const double way : {-1.0, 1.0}) {
    for (const double inside : {0.0, 0.5}) {
      r.pick();
      r.add({r.i() + inside, r.j() + inside, way < 0 ? r.full() : 0}, {0, 0, way});
      r.add({r.i(), r.j() + inside, r.top()}, {0, 0, way});
      r.add({r.i() + inside, r.j(), r.top()}, {0, 0, way * 1e-30}, 1e30);
    }
  }
  r.add({r.width(), r.height(), r.full()}, {0, 0, -1});
}

void denormal(Rays& r) {
  for (const double tiny : {kSmallest, 1e-310, 2.2250738585072014e-308}) {
    r.add_traced(r.anywhere(), {tiny, tiny, -tiny});
    r.add_traced(r.anywhere(), {1, tiny, -0.1});
    r.add_traced(r.anywhere(), {tiny, -1, -0.1});
    r.add_traced(r.anywhere(), {1, 0.5, -tiny});
    r.add_traced(r.anywhere(), {-tiny, tiny, 0});
  }
}

void huge(Rays& r) {
  for (const double much : {1e300, std::numeric_limits<double>::max()}) {
    r.add_traced(r.anywhere(), {much, much, -much});
    r.add_traced(r.anywhere(), {much, 1e-300, -1});
    r.add_traced(r.anywhere(), {-1, much, -1e-300});
    r.add_traced(r.anywhere(), {1e-300, 1, -much});
    r.add_traced(r.anywhere(), {-much, much, 0}).t_max = 1e-300;
  }
}

void near_an_axis(Rays& r) {
  for (const double little : {0x1p-12, 0x1p-20, 0x1p-31, 0x1p-33, 1e-300}) {
    r.pick();
    r.add({r.i() + 0.5, r.j(), r.full()}, {1, little, -r.full() / 16});
    r.add({r.i(), r.j() + 0.5, r.full()}, {-little, -1, -r.full() / 16});
  }
  r.add({r.i() + 0.5, r.j() + 0.5, r.full()}, {-0.0, 1, -1});
  r.add({r.i(), r.j() + 0.5, r.full()}, {-1, -0.0, -1});
  r.add({r.i(), r.j(), r.top()}, {1, 1, -0.0}, 20);
}

void over_and_under_the_slab(Rays& r) {
  for (const double z : {1 + 1e-15, 1.5, 1000.0}) {
    r.add_traced({0.3, 0.4, z}, {0.1, 0.2, -1});
    r.add_traced({0.3, 0.4, z}, {0, 0, -z});
    r.add_traced({0.3, 0.4, z}, {1, 0.2, -1e4});
  }
  r.add_traced({0.5, 0.5, 1}, {1, 0, -1});
  r.add_traced({0.5, 0.5, 0}, {1, 0, -1});  // on the floor, leaving it
  r.add_traced({0.5, 0.5, 0}, {1, 0, 1e-3});
}

void leaving_the_slab(Rays& r) {
  r.add_traced({0.5, 0.5, 1.5}, {1, 0, 1});
  r.add_traced({0.5, 0.5, 1.5}, {1, 0, 0});
  r.add_traced({0.5, 0.5, -0.5}, {1, 0, -1});
  r.add_traced({0.5, 0.5, -1e-9}, {0, 0, -1});
}

void beside_the_map(Rays& r) {
  const double tiles = static_cast<double>(int64_t{1} << r.place().format.tile_bits);
  for (const double away : {0.25, 0.75 * tiles, tiles - 1}) {
    r.add_traced({-away, 0.5, 1}, {1, 0, -0.5 / tiles});
    r.add_traced({away, -away, 1}, {-1, 1, -1 / tiles});  // through a corner of the map
    r.add_traced({0.5, away, 0.7}, {0, -1, 0});
    r.add_traced({away, 0.3, 0.7}, {1, 0, -0.1});  // away from the map
    r.add_traced({0.3, -away, 0.01}, {0.001, 1, 0.001});
  }
}

void inside_the_surface(Rays& r) {
  for (const auto& [x, y] : kDiagonals) {
    r.pick();
    r.add({r.i() + 0.5, r.j() + 0.5, 0}, {x, y, 0}, 50);
    r.add({r.i() + 0.5, r.j() + 0.5, r.top() / 2}, {x, 0, 1});
    r.add({r.i(), r.j(), r.top() / 2}, {x, y, -1});
    r.add({r.i() + 0.5, r.j() + 0.5, 0}, {0, 0, 1});
  }
}

void along_the_surface(Rays& r) {
  for (int k = 0; k < 4; ++k) {
    r.pick();
    const double east = r.top_beside(1, 0) - r.top(), west = r.top_beside(-1, 0) - r.top();
    const double both = r.top_beside(1, 1) - r.top();
    r.add({r.i(), r.j() + 0.5, r.top()}, {1, 0, east});  // touches the edges of equally rising tops
    r.add({r.i() + 1, r.j() + 0.5, r.top()}, {-1, 0, west});
    r.add({r.i(), r.j(), r.top()}, {1, 1, both});
    r.add({r.i(), r.j() + 0.5, std::min(r.full(), r.top() + r.grid_step())}, {1, 0, east});
    r.add({r.i(), r.j(), r.top()}, {1, 0, 0}, 40);
  }
}

void ends(Rays& r) {
  r.pick();
  for (const double t_max : {1.0, 2.0, 2.0000001, 3.5}) {
    r.add({r.i(), r.j() + 0.5, std::min(r.full(), r.top() + 2)}, {1, 0, -1}, t_max);
    r.add({r.i(), r.j(), r.top()}, {1, 1, 0}, t_max);
    r.add({r.i() + 0.5, r.j() + 0.5, r.full()}, {0, 0, -1}, r.full() - r.top() + t_max - 2);
  }
  TracedRay& late = r.add_traced({0.2, 0.3, 1}, {0.5, 0.1, -1});
  late.t_min = 0.4;
  late.t_max = 0.9;
}

void ends_before_it_begins(Rays& r) {
  r.add_traced(r.anywhere(), {1, 0.3, -1}).t_max = 0;
  r.add_traced(r.anywhere(), {0, 0, -1}).t_max = -1;
  TracedRay& turned = r.add_traced(r.anywhere(), {0.3, 1, -0.1});
  turned.t_min = 2;
  turned.t_max = 1;
  TracedRay& at_once = r.add_traced(r.anywhere(), {0.3, 1, 0.1});
  at_once.t_min = at_once.t_max = 1e-3;
  r.add_traced({0.5, 0.5, 2}, {0.1, 0, -1}).t_max = 1;  // ends where it enters the slab
}

void secondary(Rays& r) {
  for (int k = 0; k < 4; ++k) {
    r.pick();
    const double x = r.random().unit(), y = r.random().unit();
    const auto fix = [&](FixedAxis axis, double coordinate) {
      TracedRay& ray = r.add_traced({(r.i() + x) / r.width(), (r.j() + y) / r.height(), r.top() / r.full()},
                                    {x - 0.5, y - 0.5, axis == FixedAxis::kZ ? 0.3 : k - 1.5});
      ray.kind = RayKind::kShadow;
      ray.fixed_axis = axis;
      ray.fixed_coordinate = static_cast<int32_t>(coordinate);
    };
    fix(FixedAxis::kX, r.i());
    fix(FixedAxis::kY, r.j());
    fix(FixedAxis::kZ, r.top());
  }
}

void no_ray(Rays& r) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  r.add_traced(r.anywhere(), {0, 0, 0});
  r.add_traced(r.anywhere(), {-0.0, 0, -0.0});
  for (const double bad : {nan, kInfinity, -kInfinity}) {
    r.add_traced({bad, 0.5, 1}, {1, 0, -1});
    r.add_traced({0.5, 0.5, bad}, {1, 0, -1});
    r.add_traced(r.anywhere(), {bad, 0, -1});
    r.add_traced(r.anywhere(), {1, 0, bad});
    r.add_traced(r.anywhere(), {1, 0, -1}).t_min = bad == -kInfinity ? nan : bad;
  }
  r.add_traced(r.anywhere(), {1, 0, -1}).t_max = nan;
  r.add_traced({1e30, 0.5, 1}, {-1, 0, -1});
  r.add_traced({0.5, -1e300, 0.5}, {0, 1, -1});
}

void any(Rays& r) {
  RandomMap map;
  map.grid = r.place().grid;
  map.shape = r.place().map;
  map.format = r.place().format;
  std::vector<TracedRay> rays;
  for (uint64_t k = 0; k < 24; ++k) {
    const TracedRay ray = random_ray(r.random(), map, k);
    TracedRay& added = r.add_traced({0, 0, 0}, {0, 0, -1});
    const uint64_t id = added.id;
    added = ray;
    added.id = id;
  }
}

void far(Rays& r) {
  const double tiles = static_cast<double>(int64_t{1} << r.place().format.tile_bits);
  r.add_traced({-(tiles - 1), 0.5, 1}, {1, 0, -0.5 / tiles});
  r.add_traced({0.25, tiles - 1.5, 1}, {0.1, -1, 0});
  r.add_traced({tiles - 1.25, tiles - 1.25, 1}, {-1, -1, -0.9 / tiles});
}

template <void (*make)(Rays&)>
void with(Random& random, const HardPlace& place, std::vector<TracedRay>& rays) {
  Rays here(random, place, rays);
  make(here);
}

using enum Expected;
constexpr HardRays kRays[] = {
    {"along an axis", "one of u, v never changes", "`(b * P2.z) / a` with a = 0 in Ki & Oh's listing: 0/0",
     kExact, with<axis>},
    {"diagonal", "u and v change alike",
     "two planes at one time: a crossing of one axis alone enters a cell for no time", kExact,
     with<diagonal>},
    {"through corners", "a texel's corner at exactly the texel's height",
     "which of four cells holds a corner: rounding decides it where nothing else does", kExact,
     with<corners>},
    {"along edges", "on a texel's plane, and along the map's sides",
     "an offset delta jumps to either side of the plane", kExact, with<edges>},
    {"starting on a plane", "whole coordinates, on a top or a step above it",
     "floor() of a computed position takes the cell behind", kExact, with<on_a_plane>},
    {"from the map's sides", "x, y at 0 or at the map's end, inward and outward",
     "the index after the last texel; a tile's first plane is the last one of the tile before", kExact,
     with<sides>},
    {"grazing", "slopes of the slab per tile from 1e-1 to 1e-12",
     "`E / |E.z|` loses its digits, then overflows", kExact, with<grazing>},
    {"horizontal", "dz = 0: on the floor, at a top, between, at full scale", "`E / |E.z|` divides by 0",
     kExact, with<horizontal>},
    {"rising", "up from a top, the floor, and from inside", "depth as the parameter cannot hold them at all",
     kExact, with<rising>},
    {"vertical", "straight down and up, over centres, edges and corners",
     "dx = dy = 0: no plane is ever crossed, 0/0", kExact, with<vertical>},
    {"denormal components", "down to 5e-324, alone and with others",
     "reciprocals that overflow; flushing makes them 0", kExact, with<denormal>},
    {"huge components", "up to 1.8e308, alone and with others",
     "lengths that overflow; ratios beyond every format", kExact, with<huge>},
    {"nearly along an axis", "the other component 2^-12 to 1e-300, and -0.0",
     "a reciprocal that rounds to 0 or infinity; -0.0 mirrors a ray that has no direction", kExact,
     with<near_an_axis>},
    {"from over the slab", "starts above z = 1, or on the floor",
     "the entry is computed and may lie above z = 1 again", kExact, with<over_and_under_the_slab>},
    {"leaving the slab", "outside and going away", "must end without a step", kMiss, with<leaving_the_slab>},
    {"beside the map", "starts up to all tiles away: toward, past and away",
     "frac() after large uv; nothing to hit", kExact, with<beside_the_map>},
    {"inside the surface", "starts below a top, going every way",
     "no entry from above: a crossing is searched in vain", kExact, with<inside_the_surface>},
    {"along the surface", "exactly along ramps and tops, and one grid step over them",
     "touching is not going below: two rounded heights compared", kExact, with<along_the_surface>},
    {"ending near the surface", "t_max on a plane, at the hit, just after it",
     "a cap that returns the last position as a hit", kExact, with<ends>},
    {"ending before the start", "t_max at or before the start", "must miss without a step", kMiss,
     with<ends_before_it_begins>},
    {"secondary rays", "from a wall or a top whose coordinate is known",
     "shadow tests that compare two rounded hits: acne and leaks", kExact, with<secondary>},
    {"no ray at all", "length 0, NaN, infinite, origins beyond every tile", "must be refused with a sentence",
     kRefused, with<no_ray>},
    {"anything", "random, with a liking for planes, corners and whole ratios", "what nobody thought of",
     kExact, with<any>},
};
constexpr HardRays kFarRays = {"through all tiles", "flat, from one end of 2^w2 tiles to the other",
                               "frac() after large uv; walks of millions of steps", kExact, with<far>};

}  // namespace

std::span<const HardRays> hard_rays() { return kRays; }
const HardRays& far_rays() { return kFarRays; }

}  // namespace cuesta
