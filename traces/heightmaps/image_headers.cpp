#include "traces/heightmaps/image_headers.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
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

std::vector<uint8_t> read_file(const std::string& path) {
  std::error_code fault;
  std::vector<uint8_t> bytes(std::filesystem::file_size(path, fault));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<size_t>(file.gcount()));
  return bytes;
}

/// CRC-32 as PNG uses it (ISO 3309, reflected).
uint32_t png_check_sum(const uint8_t* bytes, size_t count) {
  static const std::array<uint32_t, 256> kTable = [] {
    std::array<uint32_t, 256> table{};
    for (uint32_t k = 0; k < 256; ++k) {
      uint32_t value = k;
      for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ (value & 1 ? 0xEDB88320u : 0);
      table[k] = value;
    }
    return table;
  }();
  uint32_t sum = 0xFFFFFFFFu;
  for (size_t k = 0; k < count; ++k) sum = kTable[(sum ^ bytes[k]) & 0xFF] ^ (sum >> 8);
  return ~sum;
}

uint32_t big32(const uint8_t* bytes) {
  return static_cast<uint32_t>(bytes[0]) << 24 | static_cast<uint32_t>(bytes[1]) << 16 |
         static_cast<uint32_t>(bytes[2]) << 8 | bytes[3];
}

/// An end-of-image marker (FF D9) somewhere after the first start of scan.
bool jpeg_has_its_end(const std::vector<uint8_t>& bytes) {
  size_t at = 2;  // segments: FF, kind, big-endian length that counts itself
  while (at + 4 <= bytes.size() && bytes[at] == 0xFF && bytes[at + 1] != 0xDA) {
    if (bytes[at + 1] == 0xFF) {
      ++at;
      continue;
    }
    at += 2 + (static_cast<size_t>(bytes[at + 2]) << 8 | bytes[at + 3]);
  }
  for (; at + 1 < bytes.size(); ++at) {
    if (bytes[at] == 0xFF && bytes[at + 1] == 0xD9) return true;
  }
  return false;
}

/// Pixels that the runs of a TGA from byte `at` on hold, counted up to `wanted`.
uint64_t tga_run_pixels(const std::vector<uint8_t>& bytes, size_t at, size_t pixel_bytes, uint64_t wanted) {
  uint64_t pixels = 0;
  while (pixels < wanted && at < bytes.size()) {
    uint64_t count = (bytes[at] & 0x7Fu) + 1;
    at += 1 + pixel_bytes * ((bytes[at] & 0x80) != 0 ? 1 : count);
    if (at > bytes.size()) break;
    pixels += count;
  }
  return pixels;
}

}  // namespace

bool has_palette(const std::string& path, const std::string& format) {
  auto header = read_header(path);
  if (format == "png") return header[25] == 3;       // IHDR's colour type
  if (format == "bmp") return u16(header, 28) <= 8;  // bits of a pixel
  if (format == "targa") return header[1] == 1 && (header[2] == 1 || header[2] == 9);
  return false;
}

std::string damage_of_png(const std::string& path) {
  constexpr std::array<uint8_t, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  auto header = read_header(path);
  if (!std::equal(kSignature.begin(), kSignature.end(), header.begin())) return "";
  std::vector<uint8_t> bytes = read_file(path);
  for (size_t at = 8; at + 12 <= bytes.size();) {  // length, type, data, check sum of type and data
    uint64_t length = big32(&bytes[at]);
    std::string type(&bytes[at + 4], &bytes[at + 8]);
    if (length + 12 > bytes.size() - at) return "it is cut off in its chunk at byte " + std::to_string(at);
    if (png_check_sum(&bytes[at + 4], length + 4) != big32(&bytes[at + 8 + length])) {
      return "the check sum of its chunk at byte " + std::to_string(at) + " is wrong";
    }
    if (type == "IEND") return "";
    at += length + 12;
  }
  return "it is cut off before its last chunk";
}

std::string damage_of_others(const std::string& path, const std::string& format, int width, int height) {
  std::error_code fault;
  uint64_t size = std::filesystem::file_size(path, fault);
  auto header = read_header(path);
  uint64_t columns = static_cast<uint64_t>(width), rows = static_cast<uint64_t>(height);
  if (format == "jpeg" && !jpeg_has_its_end(read_file(path))) return "its end marker is missing";
  if (format == "bmp" && (u32(header, 30) == 0 || u32(header, 30) == 3)) {  // uncompressed
    uint64_t row_bytes = (columns * u16(header, 28) + 31) / 32 * 4;
    uint64_t first = u32(header, 10);
    if (first + row_bytes * rows > size) return too_short(row_bytes * rows, size > first ? size - first : 0);
  }
  if (format == "targa") {
    uint64_t first = 18 + header[0] + (header[1] == 1 ? u16(header, 5) * ((header[7] + 7) / 8) : 0);
    uint64_t pixel_bytes = (header[16] + 7u) / 8;
    bool runs = header[2] >= 9;
    uint64_t needed = columns * rows * (runs ? 1 : pixel_bytes);
    uint64_t found =
        runs ? tga_run_pixels(read_file(path), first, pixel_bytes, needed) : size - std::min(size, first);
    if (found < needed && runs) return "its runs end after " + std::to_string(found) + " texels";
    if (found < needed) return too_short(needed, found);
  }
  return "";
}

}  // namespace cuesta
