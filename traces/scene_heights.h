#pragma once

#include "traces/heightmaps/image_reader.h"
#include "traces/scene.h"

namespace cuesta {

/// A scene's heights, read or generated, with a statement of where they come from. `before` hears of the map's size
/// before its memory is taken. Throws as load_heights and generate, and what `before` throws.
LoadedHeights heights_of(const Scene& scene, const SizeCheck& before = {});

}  // namespace cuesta
