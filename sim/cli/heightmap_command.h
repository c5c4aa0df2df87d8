#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "models/heightmap/generator.h"
#include "traces/heightmaps/image_reader.h"

namespace cuesta {

struct HeightmapMakeOptions {
  std::string kind;
  std::string output;  ///< ends in .png, .tif or .tiff
  int width = 0;       ///< texels; 0: the kind's own
  int height = 0;
  std::optional<int> bits;  ///< nullopt: the kind's own
  uint64_t seed = 1;
  bool force = false;  ///< replace a file of that name
};

/// Makes the map and writes it; gives a line that says what was written. Throws usage_error for a kind, size
/// or name that is not accepted and for a file that is there already,
/// Error (resource) for a map that this host's memory does not hold, Error (incomplete) when a watch stops it.
std::string heightmap_make(const HeightmapMakeOptions& options, const Watch& making = {},
                           const Watch& writing = {});

/// What the file holds, how it is read, and the pyramid over it, as lines of text. Throws as load_heights
/// does.
std::string heightmap_info(const HeightSource& source);

/// "512x256" or "512" (square), texels, at most `longest` on a side. Throws usage_error.
void parse_map_size(const std::string& text, int& width, int& height, int longest = 16384);

}  // namespace cuesta
