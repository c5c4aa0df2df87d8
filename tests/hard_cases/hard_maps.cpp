#include <algorithm>
#include <cstdlib>

#include "tests/hard_cases/hard_cases.h"

namespace cuesta {
namespace {

/// Row by row: height = of(i, j), cut to what `bits` hold.
template <class Of>
HeightGrid map_of(int width, int height, int bits, Of&& of) {
  HeightGrid grid{width, height, bits, {}};
  grid.texels.reserve(static_cast<size_t>(width) * static_cast<size_t>(height));
  const auto full = static_cast<int64_t>(grid.full_scale());
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      grid.texels.push_back(static_cast<uint16_t>(std::clamp<int64_t>(of(i, j), 0, full)));
    }
  }
  return grid;
}

HeightGrid noise(int width, int height, int bits, int64_t low, int64_t high, uint64_t seed) {
  Random random(seed);
  return map_of(width, height, bits, [&](int, int) { return random.between(low, high); });
}

/// Rounded to the 11 digits that half precision keeps of a height scaled to [0, 1], and back.
int64_t through_half(int64_t height) {
  int64_t digit = 1;
  while ((height / digit) >= 2048) digit *= 2;
  return (height + digit / 2) / digit * digit;
}

/// The highest texel of each node stands in the node's corner that is met last from the lower left, at every level.
int64_t corner_height(int i, int j) {
  int64_t level = 0;
  while (level < 5 && ((i >> level) & 1) != 0 && ((j >> level) & 1) != 0) ++level;
  return 40 * level;
}

constexpr HardMap kMaps[] = {
    {"one texel at 0", "1 x 1, 8 bits, height 0",
     "the pyramid is its own leaf: n = 0, no level to go down to",
     [] { return map_of(1, 1, 8, [](int, int) { return 0; }); }},
    {"one texel", "1 x 1, 16 bits, height 20000",
     "every crossing leaves the tile; walls only where nothing tiles",
     [] { return map_of(1, 1, 16, [](int, int) { return 20000; }); }},
    {"one row", "33 x 1, noise", "one axis has no level below the root; the other has six",
     [] { return noise(33, 1, 8, 0, 255, 1); }},
    {"one column", "1 x 17, spikes", "as one row, the other way",
     [] { return map_of(1, 17, 8, [](int, int j) { return j % 5 == 0 ? 255 : 3; }); }},
    {"2^n + 1", "17 x 17, noise", "a padded pyramid is almost half empty: padding must not be met",
     [] { return noise(17, 17, 8, 0, 255, 2); }},
    {"2^n + 1, long", "65 x 9, 16 bits, noise",
     "sides of different powers; the last column alone in its nodes",
     [] { return noise(65, 9, 16, 0, 65535, 3); }},
    {"flat at 0", "16 x 16, all 0", "the surface is the slab's floor: rays touch it without going below",
     [] { return map_of(16, 16, 8, [](int, int) { return 0; }); }},
    {"flat at 1", "16 x 16, all full scale",
     "hit where the ray enters, at time 0: 0/0 where a listing divides by it",
     [] { return map_of(16, 16, 8, [](int, int) { return 255; }); }},
    {"flat between", "7 x 5, all 100 of 255", "no node is ever skipped before the plane is reached",
     [] { return map_of(7, 5, 8, [](int, int) { return 100; }); }},
    {"maximum below 1", "32 x 32, noise of 0 to 200 of 255",
     "a public port of maximum mipmaps fails 76 to 90 % of rays when the maximum is below 1.0 exactly",
     [] { return noise(32, 32, 8, 0, 200, 4); }},
    {"one spike", "16 x 16, one texel at 1 in 0",
     "a filtered or rounded-down pyramid loses it; offsets step over it",
     [] { return map_of(16, 16, 8, [](int i, int j) { return i == 9 && j == 6 ? 255 : 0; }); }},
    {"one hole", "16 x 16, one texel at 0 in 1",
     "only steep rays see its floor; every node's bound is full scale",
     [] { return map_of(16, 16, 8, [](int i, int j) { return i == 5 && j == 10 ? 0 : 255; }); }},
    {"spikes", "64 x 64, 16 bits, one texel in 37 at 1",
     "linear searches step over texels (McGuire 2005 and after)",
     [] {
       return map_of(64, 64, 16, [](int i, int j) { return (i * 5 + j * 11) % 37 == 0 ? 65535 : 700; });
     }},
    {"checker", "16 x 16, 0 and 1", "every bound is full scale: no node above the leaves is ever skipped",
     [] { return map_of(16, 16, 8, [](int i, int j) { return ((i ^ j) & 1) * 255; }); }},
    {"checker with a seam", "7 x 5, 0 and 1", "odd sides: two alike meet where the map repeats",
     [] { return map_of(7, 5, 8, [](int i, int j) { return ((i ^ j) & 1) * 255; }); }},
    {"cliff", "16 x 16, 0 left and 1 right",
     "a wall of full height: grazing rays hit it at a corner of the texel",
     [] { return map_of(16, 16, 8, [](int i, int) { return i < 8 ? 0 : 255; }); }},
    {"cliffs in both axes", "12 x 20, 16 bits", "walls meet in corners that a diagonal ray passes exactly",
     [] { return map_of(12, 20, 16, [](int i, int j) { return (i / 4 + j / 4) % 2 != 0 ? 65535 : 0; }); }},
    {"terraces", "32 x 32, steps of 32 over 4 texels",
     "equal neighbours: tops meet in one height, Tz is the same",
     [] { return map_of(32, 32, 8, [](int i, int j) { return i / 4 * 32 + j / 16 * 16; }); }},
    {"ramp", "64 x 8, 4 a texel", "a ray along the ramp touches every top's edge and goes below none",
     [] { return map_of(64, 8, 8, [](int i, int) { return i * 4; }); }},
    {"diagonal ramp", "16 x 16, 16 bits, 1024 a texel each way",
     "the same along both axes: touched at corners",
     [] { return map_of(16, 16, 16, [](int i, int j) { return (i + j) * 1024; }); }},
    {"1 ulp at the floor", "16 x 16, 16 bits, 0 and 1",
     "relief of one height LSB: half a height off is another cell",
     [] { return map_of(16, 16, 16, [](int i, int j) { return (i + j) % 3 == 0 ? 1 : 0; }); }},
    {"1 ulp at the top", "16 x 16, 16 bits, 65534 and 65535", "the same where a float's digits are fewest",
     [] { return map_of(16, 16, 16, [](int i, int j) { return (i * 3 + j) % 4 == 0 ? 65534 : 65535; }); }},
    {"1 bit", "8 x 8, 1 bit, noise", "full scale is 1: height LSB and slab are the same",
     [] { return noise(8, 8, 1, 0, 1, 5); }},
    {"16 bits", "32 x 32, 16 bits, noise", "most digits a height can have, at every texel another",
     [] { return noise(32, 32, 16, 0, 65535, 6); }},
    {"half precision", "32 x 32, 16 bits, heights as a half-precision texture keeps them",
     "11 digits: near full scale only each 32nd height is left, so that tops meet",
     [] {
       Random random(7);
       return map_of(32, 32, 16, [&](int, int) { return through_half(random.between(0, 65535)); });
     }},
    {"bounds in the far corner", "32 x 32, the highest texel of each node in its last corner",
     "every bound is right and none helps: most steps for what is found",
     [] { return map_of(32, 32, 8, [](int i, int j) { return corner_height(i, j); }); }},
    {"groove", "12 x 3, 200, the middle row at 0 up to the last texel",
     "clamped, the groove's end repeats for ever; safety radii leapt over it",
     [] { return map_of(12, 3, 8, [](int i, int j) { return j == 1 && i < 11 ? 0 : 200; }); }},
    {"narrow and tall", "3 x 200, 8 bits, pits",
     "n is that of the longer side: seven of eight nodes are outside",
     [] {
       return map_of(3, 200, 8, [](int i, int j) { return (j * 7 + i) % 11 == 0 ? 10 : 180 + j % 20; });
     }},
};

int mantissa_of(const MapShape& map) { return std::min(24, map.bits + 4); }

constexpr HardNumbers kNumbers[] = {
    {"the machine's own", "f 8, D 32, M B + 4, w2 4", "what every architecture has unless it says otherwise",
     [](const MapShape& map) {
       return NumberFormat{8, 32, mantissa_of(map), 4};
     }},
    {"narrow", "f 1, D 8, M 4, w2 1", "planes and heights fall together: ties in every second step",
     [](const MapShape&) {
       return NumberFormat{1, 8, 4, 1};
     }},
    {"wide", "f 12, D 32, M 24, w2 6", "products of 60 bits; times beyond what a double holds",
     [](const MapShape&) {
       return NumberFormat{12, 32, 24, 6};
     }},
};

constexpr HardNumbers kFar = {"far", "f 8, D 32, M B + 4, w2 20",
                              "a million tiles: large uv, where frac() is noise", [](const MapShape& map) {
                                return NumberFormat{8, 32, mantissa_of(map), 20};
                              }};

}  // namespace

std::span<const HardMap> hard_maps() { return kMaps; }
std::span<const HardNumbers> hard_numbers() { return kNumbers; }
const HardNumbers& far_numbers() { return kFar; }

}  // namespace cuesta
