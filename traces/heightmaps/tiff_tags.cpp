#include "traces/heightmaps/tiff_tags.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <vector>

namespace cuesta {
namespace {

/// Integers at places of a file, in its byte order; zeros beyond its end.
class TiffBytes {
 public:
  explicit TiffBytes(const std::string& path) : file_(path, std::ios::binary) {}

  void use_big_endian() { big_ = true; }
  std::string bytes(uint64_t at, size_t count) {
    std::string text(count, '\0');
    file_.clear();
    if (at > INT64_MAX - count) return text;
    file_.seekg(static_cast<std::streamoff>(at));
    file_.read(text.data(), static_cast<std::streamsize>(count));
    return text;
  }
  uint64_t integer(uint64_t at, size_t size) {
    std::string text = bytes(at, size);
    if (big_) std::reverse(text.begin(), text.end());
    uint64_t value = 0;
    for (size_t k = size; k-- > 0;) value = value << 8 | static_cast<uint8_t>(text[k]);
    return value;
  }

 private:
  std::ifstream file_;
  bool big_ = false;
};

constexpr uint64_t kPhotometric = 262, kGdalNodata = 42113;
constexpr uint64_t kAscii = 2;

}  // namespace

TiffTags read_tiff_tags(const std::string& path) {
  TiffTags tags;
  TiffBytes file(path);
  const std::string order = file.bytes(0, 2);
  if (order != "II" && order != "MM") return tags;
  if (order == "MM") file.use_big_endian();
  const uint64_t version = file.integer(2, 2);
  if (version != 42 && version != 43) return tags;
  const bool wide = version == 43;  // BigTIFF: all offsets and counts take 8 bytes
  const size_t word = wide ? 8 : 4;
  const uint64_t directory = file.integer(wide ? 8 : 4, word);
  const uint64_t entries = std::min<uint64_t>(file.integer(directory, wide ? 8 : 2), 4096);
  for (uint64_t k = 0; k < entries; ++k) {
    const uint64_t entry = directory + (wide ? 8 + 20 * k : 2 + 12 * k);
    const uint64_t tag = file.integer(entry, 2), type = file.integer(entry + 2, 2);
    const uint64_t count = file.integer(entry + 4, word), value = entry + 4 + word;
    if (tag == kPhotometric && count == 1) tags.photometric = static_cast<int>(file.integer(value, 2));
    if (tag != kGdalNodata || type != kAscii || count == 0 || count > 64) continue;
    std::string text = file.bytes(count <= word ? value : file.integer(value, word), count);
    text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
    while (!text.empty() && text.back() == ' ') text.pop_back();
    text.erase(0, std::min(text.find_first_not_of(" +"), text.size()));
    double number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault == std::errc() && end == text.data() + text.size() && !text.empty()) tags.gdal_nodata = number;
  }
  return tags;
}

}  // namespace cuesta
