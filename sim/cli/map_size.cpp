#include "sim/cli/map_size.h"

#include <fmt/core.h>

#include <charconv>
#include <string_view>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {
namespace {

bool parse_number(std::string_view text, int& value) {
  auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size();
}

}  // namespace

void parse_map_size(const std::string& text, int& width, int& height, int longest) {
  size_t cross = text.find('x');
  std::string_view first = std::string_view(text).substr(0, cross);
  std::string_view second = cross == std::string::npos ? first : std::string_view(text).substr(cross + 1);
  bool known = parse_number(first, width) && parse_number(second, height);
  if (!known || width < 1 || height < 1 || width > longest || height > longest) {
    throw usage_error(fmt::format(
        "--size {}: accepted is one number of texels or WIDTHxHEIGHT, each from 1 to {}, as in 16 or 24x16.",
        printable(text), longest));
  }
}

}  // namespace cuesta
