#include "traces/heightmaps/raw_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <charconv>
#include <filesystem>

#include "models/common/error.h"
#include "models/common/words.h"
#include "traces/heightmaps/image_file.h"

namespace cuesta {
namespace {

constexpr std::array kRawNumbers = {SampleKind::kUint8, SampleKind::kUint16, SampleKind::kUint32,
                                    SampleKind::kInt16, SampleKind::kInt32,  SampleKind::kFloat,
                                    SampleKind::kDouble};

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

std::string shape_text(const RawShape& shape) {
  return size_text(shape.width, shape.height) + " numbers of " + std::string(sample_type(shape.numbers).name);
}

uint64_t bytes_of(const RawShape& shape) {
  return static_cast<uint64_t>(shape.width) * static_cast<uint64_t>(shape.height) *
         static_cast<uint64_t>(sample_type(shape.numbers).bytes);
}

bool parse_side(std::string_view text, int& side) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), side);
  return fault == std::errc() && end == text.data() + text.size() && side >= 1 && side <= ImageFile::kMaxSide;
}

/// The last WIDTHxHEIGHT in a name; digits on both sides of an x.
bool size_in_name(const std::string& name, RawShape& shape) {
  auto digit = [&](size_t at) { return std::isdigit(static_cast<unsigned char>(name[at])) != 0; };
  for (size_t cross = name.size(); cross-- > 1;) {
    if ((name[cross] != 'x' && name[cross] != 'X') || cross + 1 >= name.size()) continue;
    size_t first = cross, last = cross + 1;
    while (first > 0 && digit(first - 1)) --first;
    while (last < name.size() && digit(last)) ++last;
    std::string_view whole = name;
    if (parse_side(whole.substr(first, cross - first), shape.width) &&
        parse_side(whole.substr(cross + 1, last - cross - 1), shape.height)) {
      return true;
    }
  }
  shape.width = shape.height = 0;
  return false;
}

/// The square that the bytes would fill, as a hint for the sentence; empty when there is none.
std::string square_hint(uint64_t bytes) {
  for (SampleKind kind : {SampleKind::kUint16, SampleKind::kUint8, SampleKind::kFloat}) {
    const SampleType& type = sample_type(kind);
    const auto size = static_cast<uint64_t>(type.bytes);
    uint64_t side = 1;
    while (side < static_cast<uint64_t>(ImageFile::kMaxSide) && side * side * size < bytes) ++side;
    if (side * side * size != bytes) continue;
    return " (its " + std::to_string(bytes) + " bytes would be " + std::to_string(side) + " x " +
           std::to_string(side) + " numbers of " + std::string(type.name) + ")";
  }
  return " (it has " + std::to_string(bytes) + " bytes)";
}

}  // namespace

bool find_raw_numbers(std::string_view name, SampleKind& kind) {
  for (SampleKind known : kRawNumbers) {
    if (sample_type(known).name != name) continue;
    kind = known;
    return true;
  }
  return false;
}

std::string raw_number_names() {
  std::vector<std::string_view> names;
  for (SampleKind known : kRawNumbers) names.push_back(sample_type(known).name);
  return joined(names);
}

RawShape parse_raw_shape(const std::string& text, const std::string& origin) {
  RawShape shape;
  std::vector<std::string> parts;
  for (size_t start = 0; start <= text.size();) {
    const size_t colon = std::min(text.find(':', start), text.size());
    parts.push_back(text.substr(start, colon - start));
    start = colon + 1;
  }
  const size_t cross = parts[0].find('x');
  bool known = cross != std::string::npos && parts.size() <= 3 &&
               parse_side(std::string_view(parts[0]).substr(0, cross), shape.width) &&
               parse_side(std::string_view(parts[0]).substr(cross + 1), shape.height);
  if (known && parts.size() > 1) known = find_raw_numbers(parts[1], shape.numbers);
  if (known && parts.size() > 2) {
    known = parts[2] == "big" || parts[2] == "little";
    shape.big_endian = parts[2] == "big";
  }
  if (known) return shape;
  throw usage_error(
      origin + " " + printable(text) +
      " is not the shape of a headerless file; accepted is WIDTHxHEIGHT, 1 to 16384 on a side, then "
      ":NUMBERS out of " +
      raw_number_names() + ", then :little or :big, as 1024x1024:uint16:little.");
}

bool has_raw_name(const std::string& path) {
  const std::string extension = lower_extension(path);
  static constexpr std::string_view kNames[] = {".raw", ".r8", ".r16", ".r32", ".hgt"};
  return std::find(std::begin(kNames), std::end(kNames), extension) != std::end(kNames);
}

RawFile::RawFile(const std::string& path, const RawShape& wanted) : path_(path), shape_(wanted) {
  const uint64_t bytes = readable_file_bytes(path);
  const std::string extension = lower_extension(path);
  facts_.format = "raw";
  if (!shape_.given() && extension == ".hgt") {
    shape_ = {bytes == 3601u * 3601 * 2 ? 3601 : 1201, 0, SampleKind::kInt16, true};
    shape_.height = shape_.width;
    facts_ = {"hgt", true, -32768, "SRTM's mark of a void", {}};
  } else if (!shape_.given() && size_in_name(std::filesystem::path(path).stem().string(), shape_)) {
    if (extension == ".r8") shape_.numbers = SampleKind::kUint8;
    if (extension == ".r32") shape_.numbers = SampleKind::kFloat;
    if (extension == ".raw") {
      shape_.numbers = SampleKind::kUint8;
      if (bytes != bytes_of(shape_)) shape_.numbers = SampleKind::kUint16;
    }
    facts_.notes.push_back("The file has no header; by its name it is taken as " + shape_text(shape_) +
                           (sample_type(shape_.numbers).bytes > 1 ? ", little-endian." : "."));
  } else if (!shape_.given()) {
    throw input_error(
        "The file \"" + path + "\" has no header that states its size" + square_hint(bytes) +
        "; give heightmap.raw = {width, height, numbers, endian} in a scene, raw=1024x1024:uint16 "
        "behind --heightmap, --raw 1024x1024:uint16 to `heightmap info`, or a name like "
        "map_1024x1024.r16.");
  }
  if (bytes != bytes_of(shape_)) {
    throw input_error("The headerless file \"" + path + "\" has " + std::to_string(bytes) + " bytes; " +
                      shape_text(shape_) + " are " + std::to_string(bytes_of(shape_)) + ".");
  }
  file_.open(path, std::ios::binary);
}

void RawFile::read_rows(int first, int last, void* target) {
  const auto size = static_cast<size_t>(sample_type(shape_.numbers).bytes);
  const size_t row_bytes = static_cast<size_t>(shape_.width) * size;
  const size_t count = row_bytes * static_cast<size_t>(last - first);
  auto* bytes = static_cast<char*>(target);
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(row_bytes * static_cast<size_t>(first)));
  if (!file_.read(bytes, static_cast<std::streamsize>(count))) {
    throw input_error("The headerless file \"" + path_ + "\" cannot be read in rows " +
                      std::to_string(first) + " to " + std::to_string(last - 1) + ".");
  }
  if (shape_.big_endian == (std::endian::native == std::endian::big) || size == 1) return;
  for (size_t at = 0; at < count; at += size) std::reverse(bytes + at, bytes + at + size);
}

}  // namespace cuesta
