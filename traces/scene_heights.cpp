#include "traces/scene_heights.h"

#include <algorithm>
#include <set>

#include "models/heightmap/generator.h"

namespace cuesta {

LoadedHeights heights_of(const Scene& scene) {
  const GeneratedHeights& wanted = scene.generated;
  if (wanted.kind.empty()) return load_heights(scene.image);
  LoadedHeights loaded;
  loaded.grid = generate(wanted.kind, wanted.width, wanted.height, wanted.bits, wanted.seed);
  HeightStatement& statement = loaded.statement;
  statement.format = "generated: " + wanted.kind + ", seed " + std::to_string(wanted.seed);
  statement.width = loaded.grid.width;
  statement.height = loaded.grid.height;
  statement.type = "uint" + std::to_string(loaded.grid.bits);
  const auto [low, high] = std::minmax_element(loaded.grid.texels.begin(), loaded.grid.texels.end());
  statement.minimum = *low;
  statement.maximum = *high;
  statement.distinct_levels =
      static_cast<int>(std::set<uint16_t>(loaded.grid.texels.begin(), loaded.grid.texels.end()).size());
  statement.normalisation = "none: made as integers";
  return loaded;
}

}  // namespace cuesta
