#include "models/heightmap/generator.h"

#include <algorithm>
#include <array>
#include <string>

#include "models/common/error.h"
#include "models/common/random.h"
#include "models/common/words.h"
#include "models/heightmap/reliefs.h"

namespace cuesta {
namespace {

Relief make_flat(int width, int height, uint64_t) { return Relief(static_cast<size_t>(width) * height, 0.5); }

/// One texel in every block of 8 x 8 (less at the right and lower edge) stands up, 1/2 to 1 high; all else is
/// 0. The worst case of a max pyramid: nearly every inner node promises a height that a ray does not find.
Relief make_spikes(int width, int height, uint64_t seed) {
  Relief relief(static_cast<size_t>(width) * height, 0.0);
  Random random(seed);
  for (int top = 0; top < height; top += 8) {
    for (int left = 0; left < width; left += 8) {
      auto i = left + static_cast<int>(random.below(static_cast<uint64_t>(std::min(8, width - left))));
      auto j = top + static_cast<int>(random.below(static_cast<uint64_t>(std::min(8, height - top))));
      double needle = 0.5 + 0.5 * random.unit();
      relief[static_cast<size_t>(j) * width + i] = top == 0 && left == 0 ? 1.0 : needle;
    }
  }
  return relief;
}

constexpr std::array<MapKind, 9> kKinds = {{
    {"fractal", "Mountains with eroded flanks, from octaves of gradient noise.", 512, 512, 16, true,
     make_fractal},
    {"rocks", "Angular stones of three sizes over gravel.", 512, 512, 8, true, make_rocks},
    {"text", "Large block letters with bevelled edges; the seed chooses the words.", 512, 512, 8, true,
     make_text},
    {"spikes", "One needle of a texel in every 8 x 8 texels, the rest at 0: the worst case of a max pyramid.",
     256, 256, 8, false, make_spikes},
    {"flat", "Half of full scale everywhere.", 256, 256, 8, false, make_flat},
    {"hawaii", "An island of five shield volcanoes in a flat sea; stands in for Ki & Oh's Hawaii.", 256, 256,
     8, true, make_hawaii},
    {"rockbump", "Rounded cobbles with deep joints; stands in for Ki & Oh's Rockbump.", 256, 256, 8, true,
     make_rockbump},
    {"logo", "An emblem over a name, bevelled, on a flat ground; stands in for Ki & Oh's logo.", 256, 256, 8,
     true, make_logo},
    {"text512", "A page of small upright letters with steep walls; stands in for Ki & Oh's 512 x 512 text.",
     512, 512, 8, true, make_text512},
}};

constexpr int kMaxSide = 16384;

void check(const std::string& what, int value, int largest) {
  if (value >= 1 && value <= largest) return;
  throw usage_error("A height map with " + what + " " + std::to_string(value) + " was asked for; 1 to " +
                    std::to_string(largest) + " is accepted.");
}

}  // namespace

std::span<const MapKind> map_kinds() { return kKinds; }

const MapKind* find_map_kind(std::string_view name) {
  for (const MapKind& kind : kKinds) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

HeightGrid generate(std::string_view name, int width, int height, int bits, uint64_t seed) {
  const MapKind* kind = find_map_kind(name);
  if (kind == nullptr) {
    std::vector<std::string_view> names;
    for (const MapKind& known : kKinds) names.push_back(known.name);
    std::string near = did_you_mean(name, names);
    throw usage_error("There is no kind of height map called \"" + printable(name) + "\"; there are " +
                      joined(names) + (near.empty() ? "." : near));
  }
  HeightGrid grid;
  grid.width = width != 0 ? width : kind->width;
  grid.height = height != 0 ? height : kind->height;
  grid.bits = bits != 0 ? bits : kind->bits;
  check("width", grid.width, kMaxSide);
  check("height", grid.height, kMaxSide);
  check("bits", grid.bits, 16);

  Relief relief = kind->make(grid.width, grid.height, seed);
  double low = 0, high = 1;
  if (kind->stretch) {
    auto [lowest, highest] = std::minmax_element(relief.begin(), relief.end());
    low = *lowest;
    high = *highest;
  }
  grid.texels.reserve(relief.size());
  double full_scale = grid.full_scale();
  for (double value : relief) {
    double share = high > low ? (value - low) / (high - low) : 1;
    grid.texels.push_back(static_cast<uint16_t>(static_cast<uint32_t>(2 * share * full_scale + 1) / 2));
  }
  return grid;
}

}  // namespace cuesta
