#pragma once

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

// Image files put together byte by byte, so that what a reader makes of them is compared with the format
// itself.
namespace cuesta::test {

using Bytes = std::vector<uint8_t>;

inline void write_bytes(const std::string& path, const Bytes& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

inline Bytes read_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(file), {});
}

inline void append(Bytes& bytes, const Bytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

inline Bytes little(uint32_t value, int size) {
  Bytes bytes;
  for (int k = 0; k < size; ++k) bytes.push_back(static_cast<uint8_t>(value >> (8 * k)));
  return bytes;
}

inline Bytes big32(uint32_t value) {
  return {static_cast<uint8_t>(value >> 24), static_cast<uint8_t>(value >> 16),
          static_cast<uint8_t>(value >> 8), static_cast<uint8_t>(value)};
}

/// A PNG chunk: length, type, data, CRC-32 of type and data.
inline Bytes png_chunk(const std::string& type, const Bytes& data) {
  Bytes body(type.begin(), type.end());
  append(body, data);
  uint32_t crc = 0xFFFFFFFFu;
  for (uint8_t byte : body) {
    crc ^= byte;
    for (int k = 0; k < 8; ++k) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0);
  }
  Bytes chunk = big32(static_cast<uint32_t>(data.size()));
  append(chunk, body);
  append(chunk, big32(~crc));
  return chunk;
}

/// A PNG of samples of `bits`; `rows` holds each row's filter byte (0) and samples, in the order of the passes;
/// it goes into one stored deflate block (at most 65535 bytes).
inline Bytes png(uint32_t width, uint32_t height, int colour_type, int interlace, const Bytes& palette,
                 const Bytes& rows, int bits = 8) {
  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  Bytes header = big32(width);
  append(header, big32(height));
  append(header, {static_cast<uint8_t>(bits), static_cast<uint8_t>(colour_type), 0, 0,
                  static_cast<uint8_t>(interlace)});
  append(file, png_chunk("IHDR", header));
  if (!palette.empty()) append(file, png_chunk("PLTE", palette));
  uint32_t a = 1, b = 0;  // Adler-32
  for (uint8_t byte : rows) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  uint32_t size = static_cast<uint32_t>(rows.size());
  Bytes data = {0x78, 0x01, 0x01};
  append(data, little(size, 2));
  append(data, little(~size & 0xFFFF, 2));
  append(data, rows);
  append(data, big32(b << 16 | a));
  append(file, png_chunk("IDAT", data));
  append(file, png_chunk("IEND", {}));
  return file;
}

/// A TGA header; `kind` 2 colours, 3 grey, 10 colours in runs, 11 grey in runs; rows go up unless `top_down`.
inline Bytes tga_header(int kind, int width, int height, int bits, bool top_down) {
  Bytes bytes = {0, 0, static_cast<uint8_t>(kind), 0, 0, 0, 0, 0, 0, 0, 0, 0};
  append(bytes, little(static_cast<uint32_t>(width), 2));
  append(bytes, little(static_cast<uint32_t>(height), 2));
  append(bytes,
         {static_cast<uint8_t>(bits), static_cast<uint8_t>((bits == 32 ? 8 : 0) | (top_down ? 0x20 : 0))});
  return bytes;
}

/// A BMP with a palette of 256 greys turned round (index k is grey 255 - k), rows going up, each padded to 4
/// bytes.
inline Bytes bmp_with_palette(int width, int height, const Bytes& rows) {
  Bytes bytes = {'B', 'M'};
  append(bytes, little(static_cast<uint32_t>(54 + 1024 + rows.size()), 4));
  append(bytes, little(0, 4));
  append(bytes, little(54 + 1024, 4));
  append(bytes, little(40, 4));
  append(bytes, little(static_cast<uint32_t>(width), 4));
  append(bytes, little(static_cast<uint32_t>(height), 4));
  append(bytes, little(1 | 8 << 16, 4));
  append(bytes, little(0, 4));
  append(bytes, little(static_cast<uint32_t>(rows.size()), 4));
  for (int k = 0; k < 4; ++k) append(bytes, little(k < 2 ? 2835 : 256, 4));
  for (int k = 0; k < 256; ++k) {
    uint8_t grey = static_cast<uint8_t>(255 - k);
    append(bytes, {grey, grey, grey, 0});
  }
  append(bytes, rows);
  return bytes;
}

/// A TIFF of one strip, in either byte order; `data` is in that order, too. `nodata` becomes the tag GDAL_NODATA, a
/// text, where it is not empty. `format` 1 unsigned, 2 signed, 3 floating point; `photometric` 0 white is zero, 1
/// black is zero, 3 palette of 256 entries, here (k, k, k) * 257.
struct TiffLook {
  int bits = 8;
  int format = 1;
  int photometric = 1;
  bool big_endian = false;
  std::string nodata;
};

inline Bytes tiff(int width, int height, const TiffLook& look, const Bytes& data) {
  auto number = [&](uint32_t value, int size) {
    Bytes bytes = little(value, size);
    if (look.big_endian) std::reverse(bytes.begin(), bytes.end());
    return bytes;
  };
  Bytes palette;
  for (int colour = 0; colour < 3 && look.photometric == 3; ++colour) {
    for (uint32_t k = 0; k < 256; ++k) append(palette, number(k * 257, 2));
  }
  Bytes text(look.nodata.begin(), look.nodata.end());
  text.push_back(0);
  const bool marked = !look.nodata.empty(), with_palette = look.photometric == 3;
  const auto entries = static_cast<uint32_t>(10 + (marked ? 1 : 0) + (with_palette ? 1 : 0));
  const uint32_t first_data = 8 + 2 + 12 * entries + 4;
  const auto data_bytes = static_cast<uint32_t>(data.size());
  const uint32_t palette_at = first_data + data_bytes,
                 text_at = palette_at + static_cast<uint32_t>(palette.size());
  Bytes file = look.big_endian ? Bytes{'M', 'M'} : Bytes{'I', 'I'};
  append(file, number(42, 2));
  append(file, number(8, 4));
  append(file, number(entries, 2));
  auto entry = [&](uint32_t tag, uint32_t type, uint32_t count, uint32_t value) {
    append(file, number(tag, 2));
    append(file, number(type, 2));
    append(file, number(count, 4));
    append(file, number(value, type == 3 && count == 1 ? 2 : 4));
    if (type == 3 && count == 1) append(file, {0, 0});
  };
  entry(256, 3, 1, static_cast<uint32_t>(width));
  entry(257, 3, 1, static_cast<uint32_t>(height));
  entry(258, 3, 1, static_cast<uint32_t>(look.bits));
  entry(259, 3, 1, 1);
  entry(262, 3, 1, static_cast<uint32_t>(look.photometric));
  entry(273, 4, 1, first_data);
  entry(277, 3, 1, 1);
  entry(278, 3, 1, static_cast<uint32_t>(height));
  entry(279, 4, 1, data_bytes);
  if (with_palette) entry(320, 3, 768, palette_at);
  entry(339, 3, 1, static_cast<uint32_t>(look.format));
  if (marked) {
    if (text.size() <= 4) {  // stands in the entry itself
      append(file, number(42113, 2));
      append(file, number(2, 2));
      append(file, number(static_cast<uint32_t>(text.size()), 4));
      text.resize(4);
      append(file, text);
    } else {
      entry(42113, 2, static_cast<uint32_t>(text.size()), text_at);
    }
  }
  append(file, number(0, 4));
  append(file, data);
  append(file, palette);
  append(file, text);
  return file;
}

/// A DDS of one surface; `four_cc` "DXT5", "ATI1" ...; blocks of 4 x 4 texels, row by row.
inline Bytes dds(int width, int height, const std::string& four_cc, const Bytes& blocks) {
  Bytes file = {'D', 'D', 'S', ' '};
  auto word = [&](uint32_t value) { append(file, little(value, 4)); };
  word(124);
  word(0x81007);  // caps, height, width, pixel format, linear size
  word(static_cast<uint32_t>(height));
  word(static_cast<uint32_t>(width));
  word(static_cast<uint32_t>(blocks.size()));
  for (int k = 0; k < 13; ++k) word(0);  // depth, mip levels, reserved
  word(32);
  word(4);  // a FourCC
  file.insert(file.end(), four_cc.begin(), four_cc.end());
  for (int k = 0; k < 5; ++k) word(0);
  word(0x1000);  // a texture
  for (int k = 0; k < 4; ++k) word(0);
  append(file, blocks);
  return file;
}

/// A block of one channel (BC4, the alpha of BC3) of two values: texel k has `second` where bit k of `which` is set.
inline Bytes two_value_block(uint8_t first, uint8_t second, uint16_t which) {
  uint64_t indices = 0;
  for (int k = 0; k < 16; ++k) indices |= static_cast<uint64_t>(which >> k & 1) << (3 * k);
  Bytes block = {first, second};
  append(block, little(static_cast<uint32_t>(indices & 0xFFFFFF), 3));
  append(block, little(static_cast<uint32_t>(indices >> 24), 3));
  return block;
}

}  // namespace cuesta::test
