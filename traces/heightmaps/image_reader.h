#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "models/heightmap/height_grid.h"
#include "traces/heightmaps/raw_file.h"

namespace cuesta {

/// How the numbers in a file become heights of 0 to full scale.
enum class Normalisation {
  kAuto,    ///< unsigned integers: kNone; signed: kMinMax; floats: 0 to 1 if all lie inside, else kMinMax
  kNone,    ///< integers: 0 to the type's largest number; half, float, double: 0 to 1, an error outside
  kMinMax,  ///< the smallest number in the channel to the largest; a flat channel becomes all zero
  kRange,  ///< `low` to `high` in the file's own units; what lies outside is clamped and counted in the notes
};

/// Which heights to read, and how.
struct HeightSource {
  std::string path;
  /// A channel's name ("A", "R", "height"; case does not matter; "alpha" is whatever channel is marked so) or
  /// its index from 0. Empty: the only channel; else the one called height or displacement; of two, the one
  /// that is not alpha; R where R = G = B in every pixel; alpha where it is not constant; else an error.
  std::string channel;
  bool invert = false;  ///< the file holds depth: full scale - value
  int bits = 0;         ///< 1 to 16 bits of a height; 0: 8 for 8-bit integers, else 16
  Normalisation normalisation = Normalisation::kAuto;
  double low = 0;   ///< kRange: becomes 0
  double high = 1;  ///< kRange: becomes full scale; above `low`
  /// The number of a cell without data; NaN stands for every NaN. Such a cell becomes height 0, the slab's floor,
  /// also of a file that holds depth, and is left out of kMinMax. Nothing: the marker that the file itself names
  /// (GDAL_NODATA of a TIFF, NODATA_value of a text grid, -32768 of SRTM), if it does.
  std::optional<double> nodata;
  RawShape raw;  ///< of a file without a header; not given: by its name, see RawFile
};

/// What was found in the file and what was made of it.
struct HeightStatement {
  std::string format;  ///< OpenImageIO's name: "png", "tiff", "openexr", "targa", "bmp", "jpeg"
  int width = 0;       ///< texels
  int height = 0;      ///< texels
  std::vector<std::string> channels;  ///< all there are
  std::string channel;                ///< the one read
  std::string channel_reason;         ///< why that one
  std::string type;                   ///< "uint8", "half" ...
  double minimum = 0;                 ///< in the file's units, before inversion
  double maximum = 0;
  int distinct_levels = 0;         ///< different heights in the grid
  uint64_t nodata_cells = 0;       ///< cells without data, now height 0
  std::string nodata;              ///< "-9999 (the file's GDAL_NODATA tag)"; empty: no marker
  std::string normalisation;       ///< "0 .. 255 becomes 0 .. 255"
  std::vector<std::string> notes;  ///< palette, lossy format, clamped heights, inversion: one sentence each
};

/// Hears of a map's width and height before its memory is taken; may throw.
using SizeCheck = std::function<void(int width, int height)>;

struct LoadedHeights {
  HeightGrid grid;
  HeightStatement statement;
};

/// Reads one channel of an image as heights; row 0 of the picture is row j = 0. value -> round((value - low)
/// / (high - low) * full scale), halves up. Alpha never multiplies the colours. PNG, TIFF, EXR, TGA, BMP,
/// JPEG, DDS and whatever else OpenImageIO reads, the first picture of a file with several; headerless files
/// (RawFile); ESRI ASCII grids (AscGrid). In memory at once: the grid, which has room for its pyramid, and a strip
/// of rows; TGA, interlaced PNG, DDS and runs in BMP come whole out of OpenImageIO on top of that.
/// Throws input_error for a file that is missing, empty, truncated, of an unknown format, larger than 16384
/// on a side, or declared so much larger than its bytes that it cannot be whole; for an unknown or undecided
/// channel; for NaN or infinity (with the pixel) and for a common marker of cells without data (-9999, -32768,
/// -3.4e38 ...) as the lowest number under kMinMax, both unless `nodata` names them. Throws usage_error for bits or a
/// range that make no sense, and what `before` throws.
LoadedHeights load_heights(const HeightSource& source, const SizeCheck& before = {});

}  // namespace cuesta
