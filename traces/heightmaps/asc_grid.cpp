#include "traces/heightmaps/asc_grid.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>

#include "models/common/error.h"
#include "models/common/words.h"
#include "traces/heightmaps/image_file.h"

namespace cuesta {
namespace {

constexpr size_t kLongestLine = size_t{1} << 26;  ///< bytes: 16384 numbers of 4096 characters

bool space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool parse_grid_number(std::string_view word, double& value) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
  return fault == std::errc() && end == word.data() + word.size();
}

}  // namespace

bool has_asc_name(const std::string& path) {
  const std::string extension = lower(std::filesystem::path(path).extension().string());
  return extension == ".asc" || extension == ".grd";
}

AscGrid::AscGrid(const std::string& path) : path_(path) {
  readable_file_bytes(path);
  file_.open(path, std::ios::binary);
  facts_ = {"esri ascii grid", true, -9999, "the format's own mark", {}};
  read_header();
  count_numbers();
}

void AscGrid::refuse(const std::string& what) const {
  throw input_error("The text grid \"" + path_ + "\" " + what + ".");
}

bool AscGrid::next_line() {
  line_.clear();
  at_ = 0;
  if (!std::getline(file_, line_)) return false;
  ++line_number_;
  if (line_.size() > kLongestLine) refuse("has a line of " + std::to_string(line_.size()) + " bytes");
  return true;
}

void AscGrid::read_header() {
  while (true) {
    const std::streamoff start = file_.tellg();
    if (!next_line()) break;
    size_t word_end = 0, first = 0;
    while (first < line_.size() && space(line_[first])) ++first;
    if (first == line_.size()) continue;
    for (word_end = first; word_end < line_.size() && !space(line_[word_end]);) ++word_end;
    const std::string key = lower(std::string_view(line_).substr(first, word_end - first));
    double number;
    if (parse_grid_number(key, number)) {
      first_number_ = start;
      first_line_ = line_number_ - 1;
      break;
    }
    size_t value_start = word_end, value_end = line_.size();
    while (value_start < line_.size() && space(line_[value_start])) ++value_start;
    while (value_end > value_start && space(line_[value_end - 1])) --value_end;
    const std::string word = line_.substr(value_start, value_end - value_start);
    const bool known = key == "ncols" || key == "nrows" || key == "nodata_value" || key == "cellsize" ||
                       key == "xllcorner" || key == "yllcorner" || key == "xllcenter" || key == "yllcenter" ||
                       key == "dx" || key == "dy";
    if (!known || !parse_grid_number(word, number)) {
      refuse("has \"" + printable(line_) + "\" as line " + std::to_string(line_number_) +
             "; a header of ncols, nrows, xllcorner, yllcorner, cellsize, NODATA_value and then numbers are "
             "accepted");
    }
    if (key == "ncols" || key == "nrows") {
      if (!(number >= 1 && number <= ImageFile::kMaxSide) || number != static_cast<int>(number)) {
        refuse("states " + key + " " + printable(word) + "; 1 to 16384 are accepted");
      }
      (key == "ncols" ? width_ : height_) = static_cast<int>(number);
    }
    if (key == "nodata_value") {
      facts_.nodata = number;
      facts_.nodata_reason = "the file's NODATA_value";
    }
  }
  if (width_ == 0 || height_ == 0) refuse("states no ncols and nrows before its first number");
  if (first_number_ == 0) refuse("holds no numbers after its header");
}

void AscGrid::count_numbers() {
  file_.clear();
  file_.seekg(first_number_);
  line_number_ = first_line_;
  const uint64_t wanted = static_cast<uint64_t>(width_) * static_cast<uint64_t>(height_);
  uint64_t found = 0, odd_line = 0, odd_count = 0;
  while (next_line()) {
    uint64_t count = 0;
    for (size_t k = 0; k < line_.size(); ++k) {
      if (!space(line_[k]) && (k == 0 || space(line_[k - 1]))) ++count;
    }
    if (odd_line == 0 && count != 0 && count != static_cast<uint64_t>(width_)) {
      odd_line = line_number_;
      odd_count = count;
    }
    found += count;
  }
  if (found != wanted) {
    refuse("holds " + std::to_string(found) + " numbers, and " + std::to_string(width_) + " x " +
           std::to_string(height_) + " are " + std::to_string(wanted) +
           (odd_line == 0 ? ""
                          : "; line " + std::to_string(odd_line) + " is the first that has not " +
                                std::to_string(width_) + " but " + std::to_string(odd_count)));
  }
}

bool AscGrid::next_number(double& value) {
  while (true) {
    while (at_ < line_.size() && space(line_[at_])) ++at_;
    if (at_ < line_.size()) break;
    if (!next_line()) return false;
  }
  size_t end = at_;
  while (end < line_.size() && !space(line_[end])) ++end;
  const std::string_view word = std::string_view(line_).substr(at_, end - at_);
  if (!parse_grid_number(word, value)) {
    refuse("has \"" + printable(word) + "\" in line " + std::to_string(line_number_) +
           "; decimal numbers with a point are accepted");
  }
  at_ = end;
  return true;
}

void AscGrid::read_rows(int first, int last, void* target) {
  if (first == 0) {
    file_.clear();
    file_.seekg(first_number_);
    line_number_ = first_line_;
    line_.clear();
    at_ = 0;
  }
  auto* values = static_cast<double*>(target);
  const size_t count = static_cast<size_t>(last - first) * static_cast<size_t>(width_);
  for (size_t k = 0; k < count; ++k) {
    if (!next_number(values[k])) refuse("ends before its last number");
  }
}

}  // namespace cuesta
