#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/files/sample_type.h"

// Image files as OpenImageIO sees them, without its headers. It loads 261 shared libraries, which takes a program
// longer to start than most of what it does; it is therefore in a module of its own, cuesta_images.so beside the
// program, which the first image loads.

namespace cuesta {

/// What the header of an image's first picture says.
struct ImageHeader {
  std::string format;  ///< OpenImageIO's name: "png", "tiff", "openexr" ...
  int width = 0, height = 0, depth = 1;
  bool deep = false;
  int full_width = 0, full_height = 0;  ///< the display window
  std::vector<std::string> channels;
  std::vector<std::optional<SampleKind>>
      kinds;                            ///< of each channel; nullopt: one that there is no SampleKind for
  std::optional<SampleKind> widest;     ///< the kind that holds all channels
  int alpha_channel = -1;               ///< -1: none
  int tile_width = 0, tile_height = 0;  ///< 0: stored in rows
  uint64_t image_bytes = 0, pixel_bytes = 0;  ///< as stored, before compression
  int orientation = 1;                        ///< EXIF's
  int rows_per_strip = 0;                     ///< of a TIFF; else the height
};

/// An opened image. What can fail gives an empty text, or OpenImageIO's words on what is wrong; plugins may throw
/// std::exception too.
class ImageInput {
 public:
  virtual ~ImageInput() = default;
  virtual const ImageHeader& header() const = 0;
  /// Whether the file holds further pictures or levels.
  virtual std::string look_for_more(bool& more) = 0;
  /// Rows [first, last) of channels [channel, channel + count), interleaved, as `kind` (kHalf: as floats).
  virtual std::string read_rows(int first, int last, int channel, int count, SampleKind kind,
                                void* target) = 0;
};

/// What is to be written: rows of `channels`, interleaved, each a number of `kind`.
struct ImageLayout {
  int width = 0, height = 0;  ///< pixels
  std::vector<std::string> channels;
  SampleKind kind = SampleKind::kUint8;
  std::string compression;  ///< OpenImageIO's name; empty: the format's own
};

/// An image on its way into a file; failures as in ImageInput.
class ImageOutput {
 public:
  virtual ~ImageOutput() = default;
  virtual std::string write_row(int row, const void* samples) = 0;
  virtual std::string close() = 0;
};

class ImageCodec {
 public:
  virtual ~ImageCodec() = default;
  /// nullptr, with the reason in `fault`, where it cannot be opened.
  virtual std::unique_ptr<ImageInput> open(const std::string& path, std::string& fault) const = 0;
  /// A file of OpenImageIO's `format`, whatever its name; nullptr as above.
  virtual std::unique_ptr<ImageOutput> create(const std::string& path, const std::string& format,
                                              const ImageLayout& layout, std::string& fault) const = 0;
};

/// Loads the module cuesta_images.so, where module_path finds it, at its first call. Throws Error(kResource) where the
/// module is not there, cannot be loaded or is of another version.
const ImageCodec& image_codec();

/// Of the classes above; the module and the program must agree on it. Whoever changes the classes counts it up.
constexpr int kImageCodecVersion = 1;

}  // namespace cuesta
