#include "traces/scene_heights.h"

#include <algorithm>
#include <vector>

#include "models/heightmap/generator.h"

namespace cuesta {

LoadedHeights heights_of(const Scene& scene, const SizeCheck& before) {
  const GeneratedHeights& wanted = scene.generated;
  if (wanted.kind.empty()) return load_heights(scene.image, before);
  LoadedHeights loaded;
  if (before) {
    const MapKind* kind = find_map_kind(wanted.kind);
    if (kind != nullptr) {
      before(wanted.width != 0 ? wanted.width : kind->width,
             wanted.height != 0 ? wanted.height : kind->height);
    }
  }
  loaded.grid = generate(wanted.kind, wanted.width, wanted.height, wanted.bits, wanted.seed);
  HeightStatement& statement = loaded.statement;
  statement.format = "generated: " + wanted.kind + ", seed " + std::to_string(wanted.seed);
  statement.width = loaded.grid.width;
  statement.height = loaded.grid.height;
  statement.type = "uint" + std::to_string(loaded.grid.bits);
  const auto [low, high] = std::minmax_element(loaded.grid.texels.begin(), loaded.grid.texels.end());
  statement.minimum = *low;
  statement.maximum = *high;
  std::vector<bool> seen(65536);
  for (uint16_t texel : loaded.grid.texels) seen[texel] = true;
  statement.distinct_levels = static_cast<int>(std::count(seen.begin(), seen.end(), true));
  statement.normalisation = "none: made as integers";
  return loaded;
}

}  // namespace cuesta
