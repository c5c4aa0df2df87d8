#include "traces/heightmaps/image_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>

#include "models/common/error.h"
#include "traces/heightmaps/image_headers.h"

namespace cuesta {
namespace {

std::string in_quotes(const std::string& path) { return "\"" + path + "\""; }

/// What OpenImageIO says, as the end of a sentence: one line, without its own full stop.
std::string one_line(std::string message) {
  for (char& c : message) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  while (!message.empty() && (message.back() == ' ' || message.back() == '.')) message.pop_back();
  return message.empty() ? "no reason given" : message;
}

/// Runs what calls into OpenImageIO and its plugins, so that nothing but cuesta::Error leaves.
template <typename Function>
auto guarded(const std::string& path, Function function) {
  try {
    return function();
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::kResource, "The image " + in_quotes(path) + " does not fit into memory.");
  } catch (const std::exception& fault) {
    throw input_error("The image " + in_quotes(path) + " cannot be read: " + one_line(fault.what()) + ".");
  }
}

}  // namespace

uint64_t readable_file_bytes(const std::string& path) {
  std::error_code fault;
  auto status = std::filesystem::status(path, fault);
  if (!std::filesystem::exists(status)) throw input_error("There is no image file " + in_quotes(path) + ".");
  if (!std::filesystem::is_regular_file(status)) {
    throw input_error(in_quotes(path) + " is not a file; an image file is expected.");
  }
  if (!std::ifstream(path, std::ios::binary)) {
    throw input_error("The image file " + in_quotes(path) + " may not be read.");
  }
  const uint64_t bytes = std::filesystem::file_size(path, fault);
  if (bytes == 0) throw input_error("The image file " + in_quotes(path) + " is empty (0 bytes).");
  return bytes;
}

ImageFile::ImageFile(const std::string& path) : path_(path) {
  readable_file_bytes(path);
  guarded(path_, [&] { open(); });
}

void ImageFile::open() {
  refuse_damage(damage_of_png(path_));
  std::string fault;
  input_ = image_codec().open(path_, fault);
  if (!input_) {
    const std::string reason = one_line(fault);
    bool unknown =
        reason.find("format reader") != std::string::npos;  // OpenImageIO's words take three sentences
    throw input_error("The image " + in_quotes(path_) +
                      (unknown ? " is of no known format" : " cannot be opened: ") + (unknown ? "" : reason) +
                      "; PNG, TIFF, EXR, TGA, BMP, DDS and JPEG are accepted.");
  }
  check_size();
  refuse_damage(damage_of_others(path_, format(), width(), height()));
  fault = input_->look_for_more(more_pictures_);
  if (!fault.empty()) {
    throw input_error("The image " + in_quotes(path_) + " cannot be read: " + one_line(fault) + ".");
  }
}

void ImageFile::refuse_damage(const std::string& damage) const {
  if (!damage.empty()) throw input_error("The image " + in_quotes(path_) + " is damaged: " + damage + ".");
}

void ImageFile::check_size() const {
  std::string size = std::to_string(width()) + " x " + std::to_string(height());
  if (width() < 1 || height() < 1 || width() > kMaxSide || height() > kMaxSide) {
    throw input_error("The image " + in_quotes(path_) + " is " + size + " texels; 1 to " +
                      std::to_string(kMaxSide) + " on each side are accepted.");
  }
  if (header().depth > 1 || header().deep) {
    throw input_error("The image " + in_quotes(path_) +
                      " is a volume or holds deep samples; a flat picture is accepted.");
  }
  if (channels().empty() || channels().size() > 1024) {
    throw input_error("The image " + in_quotes(path_) + " has " + std::to_string(channels().size()) +
                      " channels; 1 to 1024 are accepted.");
  }
  double declared = static_cast<double>(header().image_bytes);
  std::error_code fault;
  double stored = static_cast<double>(std::filesystem::file_size(path_, fault));
  if (declared > 64.0 * 1024 * 1024 && declared > kMaxRatio * stored) {
    throw input_error("The image " + in_quotes(path_) + " declares " + size + " texels of " +
                      std::to_string(header().pixel_bytes) + " bytes, which its " +
                      std::to_string(static_cast<uint64_t>(stored)) + " bytes cannot hold.");
  }
}

std::vector<std::string> ImageFile::notes() const {
  std::vector<std::string> notes;
  if (has_palette(path_, format())) {
    notes.push_back("The picture has a palette; the colours that it stands for are read, not the indices.");
  }
  if (const int turn = header().orientation; turn != 1) {
    notes.push_back("The file asks to be shown turned (orientation " + std::to_string(turn) +
                    "); its rows are read as they are stored.");
  }
  if (format() == "jpeg") notes.push_back("JPEG is lossy: the heights are not those that were saved.");
  if (more_pictures_) notes.push_back("The file holds further pictures or levels; the first is read.");
  if (header().full_width != width() || header().full_height != height()) {
    notes.push_back("The file's display window is " + std::to_string(header().full_width) + " x " +
                    std::to_string(header().full_height) + "; the data window is read.");
  }
  return notes;
}

/// OpenImageIO 2.4 gives zeros, and no error, for any part of a strip and for one row alone of a TIFF of doubles; whole
/// strips of two rows or more come out right.
int ImageFile::rows_of_doubles() const {
  if (header().tile_height > 0 || format() != "tiff" || header().widest != SampleKind::kDouble) return 0;
  return std::clamp(header().rows_per_strip, 1, height());
}

int ImageFile::strip_rows() const {
  if (header().tile_height > 0) return header().tile_height;
  const int whole = rows_of_doubles();
  return whole > 0 ? (63 / whole + 1) * whole : 64;
}

void ImageFile::read_rows(int first, int last, int channel, int count, SampleKind kind, void* target) {
  guarded(path_, [&] {
    if (rows_of_doubles() > 0 && last - first == 1) {  // see rows_of_doubles
      if (height() == 1) {
        throw input_error(
            "The image " + in_quotes(path_) +
            " is a TIFF of doubles of one row, which OpenImageIO cannot read; float, or two rows, "
            "is accepted.");
      }
      const int before = std::min(first, rows_of_doubles());
      const size_t row_bytes = static_cast<size_t>(sample_type(kind).bytes) * static_cast<size_t>(width()) *
                               static_cast<size_t>(count);
      std::vector<char> rows(row_bytes * static_cast<size_t>(before + 1));
      read_rows(first - before, last, channel, count, kind, rows.data());
      std::memcpy(target, rows.data() + row_bytes * static_cast<size_t>(before), row_bytes);
      return;
    }
    const std::string fault = input_->read_rows(first, last, channel, count, kind, target);
    if (!fault.empty()) {
      throw input_error("The image " + in_quotes(path_) + " is damaged or cut off in rows " +
                        std::to_string(first) + " to " + std::to_string(last - 1) + ": " + one_line(fault) +
                        ".");
    }
  });
}

}  // namespace cuesta
