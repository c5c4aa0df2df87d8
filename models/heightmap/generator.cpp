#include "models/heightmap/generator.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "models/common/words.h"
#include "models/heightmap/pyramid.h"
#include "models/heightmap/reliefs.h"

namespace cuesta {
namespace {

constexpr std::array<MapKind, 16> kKinds = {{
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
    {"bricks", "Courses of bevelled bricks, a little unequal in height, with joints at 0.", 512, 512, 8, true,
     make_bricks},
    {"noise", "White noise: every texel's height is drawn alone, evenly from 0 to full scale.", 256, 256, 8,
     true, make_noise},
    {"steps", "Stairs of 16 equal steps that rise along u and fall the full height at the seam.", 256, 256, 8,
     false, make_steps},
    {"checker", "Squares of 8 x 8 texels, in turn at full scale and at 0.", 256, 256, 8, false, make_checker},
    {"hole", "Full scale everywhere but in the middle's one texel, which is 0.", 256, 256, 8, false,
     make_hole},
    {"cliffs", "Plateaus at full scale over a floor at 0, with upright walls along irregular borders.", 256,
     256, 8, true, make_cliffs},
    {"terraces", "Hills cut into 8 terraces of exactly equal heights.", 256, 256, 8, true, make_terraces},
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

HeightGrid generate(std::string_view name, int width, int height, int bits, uint64_t seed, const Watch& watch,
                    size_t kept_texels) {
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

  const size_t texels = static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height);
  const auto rows = static_cast<uint64_t>(grid.height);
  const bool twice = kind->stretch && texels > kept_texels;
  uint64_t rows_done = 0;
  auto row_done = [&] {
    ++rows_done;
    if (!watch || watch(rows_done, kind->stretch ? 2 * rows : rows)) return;
    throw Error(ExitCode::kIncomplete,
                "The height map was stopped before it was whole; nothing of it is kept.");
  };

  double low = 0, high = 1;
  std::vector<double> kept;
  if (kind->stretch) {
    low = std::numeric_limits<double>::infinity();
    high = -low;
    kept.resize(twice ? static_cast<size_t>(grid.width) : texels);
    const ReliefRows relief = kind->make(grid.width, grid.height, seed);
    for (int j = 0; j < grid.height; ++j) {
      double* row = kept.data() + (twice ? 0 : static_cast<size_t>(j) * static_cast<size_t>(grid.width));
      relief(j, row);
      for (int i = 0; i < grid.width; ++i) {
        low = std::min(low, row[i]);
        high = std::max(high, row[i]);
      }
      row_done();
    }
  }

  const bool made = kind->stretch && !twice;
  const ReliefRows relief = made ? ReliefRows() : kind->make(grid.width, grid.height, seed);
  std::vector<double> fresh(static_cast<size_t>(grid.width));
  grid.texels.reserve(pyramid_storage(grid.width, grid.height));
  const double full_scale = grid.full_scale();
  for (int j = 0; j < grid.height; ++j) {
    if (!made) relief(j, fresh.data());
    const double* row =
        made ? kept.data() + static_cast<size_t>(j) * static_cast<size_t>(grid.width) : fresh.data();
    for (int i = 0; i < grid.width; ++i) {
      double share = high > low ? (row[i] - low) / (high - low) : 1;
      grid.texels.push_back(static_cast<uint16_t>(static_cast<uint32_t>(2 * share * full_scale + 1) / 2));
    }
    row_done();
  }
  return grid;
}

}  // namespace cuesta
