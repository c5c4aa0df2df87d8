#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "models/heightmap/generator.h"
#include "traces/heightmaps/image_reader.h"

namespace cuesta {

/// A map to make and the file to write it into.
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

/// Says in lines of text what the file holds, how it is read, and what pyramid stands over it. Throws as load_heights
/// does.
std::string heightmap_info(const HeightSource& source);

/// Throws usage_error for a number of bits that no height has; accepted are 1 to 16.
void check_map_bits(int bits);

}  // namespace cuesta
