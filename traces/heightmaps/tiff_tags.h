#pragma once

#include <optional>
#include <string>

namespace cuesta {

/// What OpenImageIO does not say of a TIFF file, from its first directory (TIFF 6.0 and BigTIFF, both byte
/// orders). A file that is no TIFF, or is damaged, has none of it.
struct TiffTags {
  std::optional<double> gdal_nodata;  ///< tag 42113, a text: the marker of cells without data; may be NaN
  int photometric = -1;               ///< tag 262: 0 white is zero, 1 black is zero, 2 RGB, 3 palette
};

TiffTags read_tiff_tags(const std::string& path);

}  // namespace cuesta
