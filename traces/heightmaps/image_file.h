#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/files/image_codec.h"

namespace cuesta {

/// Bytes of the file at `path`. Throws input_error where there is none, where it is a folder, may not be read or is
/// empty.
uint64_t readable_file_bytes(const std::string& path);

/// An image opened through OpenImageIO, read in strips of rows so that only what is wanted is ever in memory.
/// The constructor makes the checks that need no pixels: the file exists, is not empty, its format is known,
/// and the size that its header declares is accepted and believable. Everything throws cuesta::Error (input).
class ImageFile {
 public:
  static constexpr int kMaxSide = 16384;  ///< texels
  /// No format read here packs more than about 1000 to 1 (deflate 1032 to 1); above 64 MiB a header that
  /// declares more than this ratio is taken as damaged instead of being allocated.
  static constexpr double kMaxRatio = 4096;

  explicit ImageFile(const std::string& path);

  const std::string& path() const { return path_; }
  const std::string& format() const { return header().format; }
  int width() const { return header().width; }
  int height() const { return header().height; }
  const std::vector<std::string>& channels() const { return header().channels; }
  int alpha_channel() const { return header().alpha_channel; }  ///< -1: none
  /// nullopt: a number type that heights are not read from.
  std::optional<SampleKind> kind(int channel) const { return header().kinds[static_cast<size_t>(channel)]; }
  std::vector<std::string> notes() const;  ///< palette, lossy, turned, further pictures in the file

  /// Rows that the file gives at once, at least 1.
  int strip_rows() const;
  /// Rows [first, last) of channels [channel, channel + count), interleaved, as `kind` (kHalf: as floats). `first` is
  /// a multiple of strip_rows(), `last` another or height().
  void read_rows(int first, int last, int channel, int count, SampleKind kind, void* target);

 private:
  const ImageHeader& header() const { return input_->header(); }
  void open();
  int rows_of_doubles() const;  ///< of a strip, where only whole strips can be read; else 0
  void refuse_damage(const std::string& damage) const;
  void check_size() const;

  std::string path_;
  std::unique_ptr<ImageInput> input_;
  bool more_pictures_ = false;
};

}  // namespace cuesta
