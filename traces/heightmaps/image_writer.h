#pragma once

#include <string>

#include "models/heightmap/generator.h"
#include "models/heightmap/height_grid.h"

namespace cuesta {

/// Writes heights as a one-channel PNG or TIFF (by the path's ending): 8-bit up to 8 bits, else 16-bit.
/// Heights are scaled so that full scale is white, halves up; reading the file with the grid's `bits` gives
/// the same heights back. The file appears under its name only when it is whole. Throws usage_error for
/// another ending, and for a file that is there already unless `overwrite`; Error (resource) when it cannot
/// be written. `watch` hears of rows; when it stops the writing, Error (incomplete) is thrown and nothing is left.
void write_height_image(const std::string& path, const HeightGrid& grid, bool overwrite = false,
                        const Watch& watch = {});

/// Throws usage_error for a name that write_height_image does not accept; for asking before the work.
void check_height_image_name(const std::string& path);

}  // namespace cuesta
