#pragma once

#include "traces/heightmaps/image_reader.h"
#include "traces/scene.h"

namespace cuesta {

/// A scene's heights, read or generated, with a statement of where they come from.
/// Throws as load_heights and generate.
LoadedHeights heights_of(const Scene& scene);

}  // namespace cuesta
