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

/// A file from its start to its end, through a small buffer: files may be larger than what is left of memory.
class ByteStream {
 public:
  explicit ByteStream(const std::string& path) : file_(path, std::ios::binary), buffer_(1 << 16) {}

  bool more() {
    if (at_ == end_) {
      file_.read(reinterpret_cast<char*>(buffer_.data()), static_cast<std::streamsize>(buffer_.size()));
      at_ = 0;
      end_ = static_cast<size_t>(file_.gcount());
    }
    return at_ < end_;
  }
  /// 0 beyond the end.
  uint8_t next() { return more() ? buffer_[at_++] : uint8_t{0}; }
  /// Calls take(bytes, count) for the pieces of the next `count` bytes; returns how many there were.
  template <typename Take>
  uint64_t pieces(uint64_t count, Take take) {
    uint64_t done = 0;
    while (done < count && more()) {
      size_t piece = static_cast<size_t>(std::min<uint64_t>(count - done, end_ - at_));
      take(&buffer_[at_], piece);
      at_ += piece;
      done += piece;
    }
    return done;
  }
  uint64_t skip(uint64_t count) {
    return pieces(count, [](const uint8_t*, size_t) {});
  }

 private:
  std::ifstream file_;
  std::vector<uint8_t> buffer_;
  size_t at_ = 0, end_ = 0;
};

/// CRC-32 as PNG uses it (ISO 3309, reflected), eight bytes at a time.
class PngCheckSum {
 public:
  void add(const uint8_t* bytes, size_t count) {
    const auto& t = tables();
    size_t k = 0;
    for (; k + 8 <= count; k += 8) {
      const uint32_t low =
          sum_ ^ (bytes[k] | static_cast<uint32_t>(bytes[k + 1]) << 8 |
                  static_cast<uint32_t>(bytes[k + 2]) << 16 | static_cast<uint32_t>(bytes[k + 3]) << 24);
      sum_ = t[7][low & 0xFF] ^ t[6][low >> 8 & 0xFF] ^ t[5][low >> 16 & 0xFF] ^ t[4][low >> 24] ^
             t[3][bytes[k + 4]] ^ t[2][bytes[k + 5]] ^ t[1][bytes[k + 6]] ^ t[0][bytes[k + 7]];
    }
    for (; k < count; ++k) sum_ = t[0][(sum_ ^ bytes[k]) & 0xFF] ^ (sum_ >> 8);
  }
  uint32_t value() const { return ~sum_; }

 private:
  using Tables = std::array<std::array<uint32_t, 256>, 8>;
  static const Tables& tables() {
    static const Tables kTables = [] {
      Tables tables{};
      for (uint32_t k = 0; k < 256; ++k) {
        uint32_t value = k;
        for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ (value & 1 ? 0xEDB88320u : 0);
        tables[0][k] = value;
      }
      for (size_t n = 1; n < 8; ++n) {
        for (uint32_t k = 0; k < 256; ++k) {
          tables[n][k] = tables[n - 1][k] >> 8 ^ tables[0][tables[n - 1][k] & 0xFF];
        }
      }
      return tables;
    }();
    return kTables;
  }
  uint32_t sum_ = 0xFFFFFFFFu;
};

uint32_t big32(const std::array<uint8_t, 8>& bytes, size_t at) {
  return static_cast<uint32_t>(bytes[at]) << 24 | static_cast<uint32_t>(bytes[at + 1]) << 16 |
         static_cast<uint32_t>(bytes[at + 2]) << 8 | bytes[at + 3];
}

/// An end-of-image marker (FF D9) somewhere after the first start of scan.
bool jpeg_has_its_end(ByteStream file) {
  file.skip(2);
  // Segments: FF, kind, big-endian length that counts itself.
  for (uint8_t mark = file.next(); mark == 0xFF && file.more(); mark = file.next()) {
    uint8_t kind = file.next();
    while (kind == 0xFF && file.more()) kind = file.next();
    if (kind == 0xDA) break;
    const unsigned high = file.next(), length = high << 8 | file.next();
    file.skip(std::max(length, 2u) - 2);
  }
  for (bool marked = false; file.more();) {
    const uint8_t byte = file.next();
    if (marked && byte == 0xD9) return true;
    marked = byte == 0xFF;
  }
  return false;
}

/// Pixels that the runs of a TGA from byte `at` on hold, counted up to `wanted`.
uint64_t tga_run_pixels(ByteStream file, uint64_t at, uint64_t pixel_bytes, uint64_t wanted) {
  uint64_t pixels = 0;
  file.skip(at);
  while (pixels < wanted && file.more()) {
    const uint8_t head = file.next();
    const uint64_t count = (head & 0x7Fu) + 1;
    const uint64_t bytes = pixel_bytes * ((head & 0x80) != 0 ? 1 : count);
    if (file.skip(bytes) < bytes) break;
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
  ByteStream file(path);
  file.skip(8);
  for (uint64_t at = 8; file.more();) {  // length, type, data, check sum of type and data
    std::array<uint8_t, 8> head{};
    const std::string place = std::to_string(at);
    size_t read = 0;
    for (; read < 8 && file.more(); ++read) head[read] = file.next();
    const uint64_t length = big32(head, 0);
    PngCheckSum sum;
    sum.add(&head[4], 4);
    if (read < 8 ||
        file.pieces(length, [&](const uint8_t* data, size_t count) { sum.add(data, count); }) < length) {
      return "it is cut off in its chunk at byte " + place;
    }
    std::array<uint8_t, 8> tail{};
    for (read = 0; read < 4 && file.more(); ++read) tail[read] = file.next();
    if (read < 4) return "it is cut off in its chunk at byte " + place;
    if (big32(tail, 0) != sum.value()) return "the check sum of its chunk at byte " + place + " is wrong";
    if (std::equal(head.begin() + 4, head.end(), "IEND")) return "";
    at += length + 12;
  }
  return "it is cut off before its last chunk";
}

std::string damage_of_others(const std::string& path, const std::string& format, int width, int height) {
  std::error_code fault;
  uint64_t size = std::filesystem::file_size(path, fault);
  auto header = read_header(path);
  uint64_t columns = static_cast<uint64_t>(width), rows = static_cast<uint64_t>(height);
  if (format == "jpeg" && !jpeg_has_its_end(ByteStream(path))) return "its end marker is missing";
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
        runs ? tga_run_pixels(ByteStream(path), first, pixel_bytes, needed) : size - std::min(size, first);
    if (found < needed && runs) return "its runs end after " + std::to_string(found) + " texels";
    if (found < needed) return too_short(needed, found);
  }
  return "";
}

}  // namespace cuesta
