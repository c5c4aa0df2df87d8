#include "traces/heightmaps/image_headers.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace cuesta {
namespace {

/// The first 64 bytes; zeros where the file is shorter.
std::array<uint8_t, 64> read_header(const std::string& path) {
  std::array<uint8_t, 64> header{};
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(header.data()), header.size());
  return header;
}

uint32_t u16(const std::array<uint8_t, 64>& header, size_t at) {
  return header[at] | static_cast<uint32_t>(header[at + 1]) << 8;
}
uint32_t u32(const std::array<uint8_t, 64>& header, size_t at) {
  return u16(header, at) | u16(header, at + 2) << 16;
}

std::string too_short(uint64_t needed, uint64_t found) {
  return "its rows need " + std::to_string(needed) + " bytes and " + std::to_string(found) + " are there";
}

/// An end-of-image marker (FF D9) somewhere after the first start of scan.
bool jpeg_has_its_end(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  auto byte = [&](size_t at) { return static_cast<uint8_t>(bytes[at]); };
  size_t at = 2;  // segments: FF, kind, big-endian length that counts itself
  while (at + 4 <= bytes.size() && byte(at) == 0xFF && byte(at + 1) != 0xDA) {
    if (byte(at + 1) == 0xFF) {
      ++at;
      continue;
    }
    at += 2 + (static_cast<size_t>(byte(at + 2)) << 8 | byte(at + 3));
  }
  for (; at + 1 < bytes.size(); ++at) {
    if (byte(at) == 0xFF && byte(at + 1) == 0xD9) return true;
  }
  return false;
}

}  // namespace

bool has_palette(const std::string& path, const std::string& format) {
  auto header = read_header(path);
  if (format == "png") return header[25] == 3;       // IHDR's colour type
  if (format == "bmp") return u16(header, 28) <= 8;  // bits of a pixel
  if (format == "targa") return header[1] == 1 && (header[2] == 1 || header[2] == 9);
  return false;
}

std::string damage_that_readers_hide(const std::string& path, const std::string& format, int width,
                                     int height) {
  std::error_code fault;
  uint64_t size = std::filesystem::file_size(path, fault);
  auto header = read_header(path);
  uint64_t columns = static_cast<uint64_t>(width), rows = static_cast<uint64_t>(height);
  if (format == "jpeg" && !jpeg_has_its_end(path)) return "its end marker is missing";
  if (format == "bmp" && (u32(header, 30) == 0 || u32(header, 30) == 3)) {  // uncompressed
    uint64_t row_bytes = (columns * u16(header, 28) + 31) / 32 * 4;
    uint64_t first = u32(header, 10);
    if (first + row_bytes * rows > size) return too_short(row_bytes * rows, size > first ? size - first : 0);
  }
  if (format == "targa" && header[2] >= 1 && header[2] <= 3) {  // uncompressed
    uint64_t first = 18 + header[0] + (header[1] == 1 ? u16(header, 5) * ((header[7] + 7) / 8) : 0);
    uint64_t needed = columns * rows * ((header[16] + 7u) / 8);
    if (first + needed > size) return too_short(needed, size > first ? size - first : 0);
  }
  return "";
}

}  // namespace cuesta
