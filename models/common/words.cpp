#include "models/common/words.h"

#include <algorithm>
#include <charconv>
#include <vector>

namespace cuesta {

size_t edit_distance(std::string_view a, std::string_view b) {
  constexpr size_t kLongest = 64;  // messages only: longer names are compared by their heads
  a = a.substr(0, kLongest);
  b = b.substr(0, kLongest);
  std::vector<size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

namespace {

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

}  // namespace

std::string_view nearest_name(std::string_view found, std::span<const std::string_view> names) {
  std::string_view best;
  size_t best_distance = 1 + std::max<size_t>(1, found.size() / 3);
  for (std::string_view name : names) {
    size_t distance = edit_distance(lower_case(found), lower_case(name));
    // "way" for "ways" and "l1.ways" for "height_l1.ways" are meant whatever their length.
    if (found.size() >= 3 && (name.starts_with(found) || name.ends_with(found)))
      distance = std::min<size_t>(distance, 1);
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  return best;
}

std::string did_you_mean(std::string_view found, std::span<const std::string_view> names) {
  const std::string_view nearest = nearest_name(found, names);
  return nearest.empty() ? std::string() : "; did you mean `" + std::string(nearest) + "`?";
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> words;
  for (size_t end; (end = text.find(at)) != std::string_view::npos; text.remove_prefix(end + 1)) {
    words.push_back(text.substr(0, end));
  }
  words.push_back(text);
  return words;
}

std::string joined(std::span<const std::string_view> names) {
  std::string text;
  for (std::string_view name : names) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

std::string printable(std::string_view text, size_t limit) {
  std::string clean(text.size() > limit ? text.substr(0, limit - 3) : text);
  for (char& c : clean) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text.size() > limit ? clean + "..." : clean;
}

std::string shortest_text(double value) {
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return std::string(buffer, end);
}

}  // namespace cuesta
