#pragma once

#include <memory>
#include <string>

#include "traces/heightmaps/image_reader.h"
#include "traces/heightmaps/sample_source.h"

namespace cuesta {

/// A file opened for its heights, whatever its kind: an image through OpenImageIO, a headerless file, a text grid.
struct OpenedHeights {
  std::unique_ptr<SampleSource> samples;
  PlainFileFacts facts;
  std::vector<std::string> channels;
  std::string channel;
  std::string channel_reason;
};

/// Throws what ImageFile, choose_channel, RawFile and AscGrid throw; usage_error for a raw shape or a channel that
/// contradicts the file.
OpenedHeights open_heights(const HeightSource& source);

}  // namespace cuesta
