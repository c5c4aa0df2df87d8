#include "traces/heightmaps/channel_choice.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {
namespace {

std::string lower_name(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

std::string channel_list(const ImageFile& file) {
  std::string list;
  for (size_t k = 0; k < file.channels().size(); ++k) {
    list += (k == 0 ? "" : ", ") + std::to_string(k) + " (" + file.channels()[k] + ")";
  }
  return list;
}

std::optional<int> by_name(const ImageFile& file, const std::string& wanted) {
  for (size_t k = 0; k < file.channels().size(); ++k) {
    if (lower_name(file.channels()[k]) == lower_name(wanted)) return static_cast<int>(k);
  }
  if (lower_name(wanted) == "alpha" && file.alpha_channel() >= 0) return file.alpha_channel();
  return std::nullopt;
}

std::optional<int> by_index(const ImageFile& file, const std::string& wanted) {
  bool digits =
      !wanted.empty() && wanted.size() <= 4 &&
      std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!digits) return std::nullopt;
  size_t index = std::stoul(wanted);
  return index < file.channels().size() ? std::optional<int>(static_cast<int>(index)) : std::nullopt;
}

/// The name after the last dot: layers of an EXR are "layer.name".
std::string last_part(const std::string& name) { return lower_name(name.substr(name.rfind('.') + 1)); }

struct ColourScan {
  bool grey = true;  ///< R = G = B in every pixel
  bool alpha_constant = true;
};

/// Reads R, G, B and, where there is one, alpha; 16-bit integers hold what 8 and 16 bits tell apart, float
/// the rest.
template <typename T>
ColourScan scan(ImageFile& file, SampleKind kind) {
  ColourScan found;
  int count = file.alpha_channel() == 3 ? 4 : 3;
  std::vector<T> strip(static_cast<size_t>(file.strip_rows()) * file.width() * count);
  T first_alpha{};
  for (int first = 0; first < file.height(); first += file.strip_rows()) {
    int last = std::min(first + file.strip_rows(), file.height());
    file.read_rows(first, last, 0, count, kind, strip.data());
    if (first == 0 && count == 4) first_alpha = strip[3];
    size_t texels = static_cast<size_t>(last - first) * file.width();
    for (size_t k = 0; k < texels; ++k) {
      const T* pixel = strip.data() + k * count;
      if (pixel[0] != pixel[1] || pixel[1] != pixel[2]) found.grey = false;
      if (count == 4 && pixel[3] != first_alpha) found.alpha_constant = false;
    }
    if (!found.grey && (count == 3 || !found.alpha_constant)) break;
  }
  return found;
}

ChannelChoice by_rule(ImageFile& file) {
  const auto& names = file.channels();
  if (names.size() == 1) return {0, "the only channel"};
  std::vector<int> called;
  for (size_t k = 0; k < names.size(); ++k) {
    std::string name = last_part(names[k]);
    if (name == "height" || name == "displacement") called.push_back(static_cast<int>(k));
  }
  if (called.size() == 1) return {called[0], "called so"};
  if (names.size() == 2 && file.alpha_channel() >= 0)
    return {1 - file.alpha_channel(), "the one that is not alpha"};
  bool colours = names.size() >= 3 && names[0] == "R" && names[1] == "G" && names[2] == "B";
  if (colours) {
    bool small = file.kind(0) == SampleKind::kUint8 || file.kind(0) == SampleKind::kUint16;
    ColourScan found =
        small ? scan<uint16_t>(file, SampleKind::kUint16) : scan<float>(file, SampleKind::kFloat);
    if (found.grey) return {0, "R = G = B in every pixel"};
    if (file.alpha_channel() == 3 && !found.alpha_constant)
      return {3, "R, G and B differ and alpha is not constant"};
  }
  std::string reason = colours ? "has colours (R, G and B differ) and no alpha that varies"
                               : "has no channel that is known to hold heights";
  throw input_error("The image \"" + file.path() + "\" " + reason + "; name one of its channels " +
                    channel_list(file) + ".");
}

}  // namespace

ChannelChoice choose_channel(ImageFile& file, const std::string& wanted) {
  if (wanted.empty()) return by_rule(file);
  if (auto index = by_name(file, wanted)) return {*index, "asked for"};
  if (auto index = by_index(file, wanted)) return {*index, "asked for"};
  throw input_error("The image \"" + file.path() + "\" has no channel " + printable(wanted) + "; there are " +
                    channel_list(file) + ".");
}

}  // namespace cuesta
