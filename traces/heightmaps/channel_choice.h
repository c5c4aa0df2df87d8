#pragma once

#include <string>

#include "traces/heightmaps/image_file.h"

namespace cuesta {

struct ChannelChoice {
  int index = 0;
  std::string reason;  ///< "asked for", "the only channel" ...
};

/// The channel of a HeightSource: by name, by index, or, where `wanted` is empty, by the rule stated there.
/// The rule may have to read the whole file. Throws input_error for a channel that is not there (naming those
/// that are) and where the rule decides nothing.
ChannelChoice choose_channel(ImageFile& file, const std::string& wanted);

}  // namespace cuesta
