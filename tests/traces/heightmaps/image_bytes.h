#pragma once

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

/// A PNG of 8-bit samples; `rows` holds each row's filter byte (0) and samples, in the order of the passes;
/// it goes into one stored deflate block (at most 65535 bytes).
inline Bytes png(uint32_t width, uint32_t height, int colour_type, int interlace, const Bytes& palette,
                 const Bytes& rows) {
  Bytes file = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  Bytes header = big32(width);
  append(header, big32(height));
  append(header, {8, static_cast<uint8_t>(colour_type), 0, 0, static_cast<uint8_t>(interlace)});
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

}  // namespace cuesta::test
