#include "reports/picture.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "models/common/error.h"

namespace cuesta {
namespace {

void append_u32(std::string& bytes, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xFF);
}

void append_chunk(std::string& png, const std::string& type, const std::string& data) {
  append_u32(png, static_cast<uint32_t>(data.size()));
  const std::string body = type + data;
  png += body;
  append_u32(png, static_cast<uint32_t>(
                      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()))));
}

std::string deflated(const std::string& raw) {
  uLongf size = compressBound(static_cast<uLong>(raw.size()));
  std::string packed(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                               reinterpret_cast<const Bytef*>(raw.data()), static_cast<uLong>(raw.size()), 4);
  if (status != Z_OK) throw Error(ExitCode::kResource, "A picture could not be compressed: memory is short.");
  packed.resize(size);
  return packed;
}

}  // namespace

void Picture::fill_rectangle(int x, int y, int w, int h, uint8_t colour) {
  const int left = std::clamp(x, 0, width), right = std::clamp(x + w, 0, width);
  for (int row = std::clamp(y, 0, height); row < std::clamp(y + h, 0, height); ++row) {
    const auto start = pixels.begin() + static_cast<ptrdiff_t>(row) * width;
    std::fill(start + left, start + right, colour);
  }
}

Colour viridis(double position) {
  static constexpr double kFit[7][3] = {{0.2777273272234177, 0.005407344544966578, 0.3340998053353061},
                                        {0.1050930431085774, 1.404613529898575, 1.384590162594685},
                                        {-0.3308618287255563, 0.214847559468213, 0.09509516302823659},
                                        {-4.634230498983486, -5.799100973351585, -19.33244095627987},
                                        {6.228269936347081, 14.17993336680509, 56.69055260068105},
                                        {4.776384997670288, -13.74514537774601, -65.35303263337234},
                                        {-5.435455855934631, 4.645852612178535, 26.3124352495832}};
  const double t = std::clamp(position, 0.0, 1.0);
  uint8_t channel[3];
  for (int c = 0; c < 3; ++c) {
    double value = kFit[6][c];
    for (int power = 5; power >= 0; --power) value = kFit[power][c] + t * value;
    channel[c] = static_cast<uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  }
  return {channel[0], channel[1], channel[2]};
}

std::string encode_png(const Picture& picture) {
  std::string header;
  append_u32(header, static_cast<uint32_t>(picture.width));
  append_u32(header, static_cast<uint32_t>(picture.height));
  header +=
      std::string("\x08\x03\x00\x00\x00", 5);  // 8 bits, palette, deflate, no filter choice, not interlaced
  std::string palette;
  for (const Colour& colour : picture.palette) {
    palette += static_cast<char>(colour.r);
    palette += static_cast<char>(colour.g);
    palette += static_cast<char>(colour.b);
  }
  std::string rows;
  rows.reserve(picture.pixels.size() + static_cast<size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y) {
    rows += '\0';
    rows.append(reinterpret_cast<const char*>(picture.pixels.data()) + static_cast<size_t>(y) * picture.width,
                static_cast<size_t>(picture.width));
  }
  std::string png = "\x89PNG\r\n\x1A\n";
  append_chunk(png, "IHDR", header);
  append_chunk(png, "PLTE", palette);
  append_chunk(png, "IDAT", deflated(rows));
  append_chunk(png, "IEND", "");
  return png;
}

}  // namespace cuesta
