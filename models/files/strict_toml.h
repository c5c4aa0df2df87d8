#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {

namespace strict_toml_detail {
struct Node;
}

/// Both ends belong to the range.
template <class T>
struct Range {
  T low, high;
};

using IntegerRange = Range<int64_t>;
using RealRange = Range<double>;

inline constexpr RealRange kAnyReal{-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};

/// An accepted name and what it stands for.
template <class E>
using Named = std::pair<std::string_view, E>;

/// A table of a strict TOML document. Every function that reads a key marks it as known; keys that nobody asked
/// for are errors in TomlDocument::finish(). Reading throws usage_error with file, line, key, what was found and
/// what is accepted. Without `otherwise` a key is required. A cheap handle; the document stays alive with it.
class TomlTable {
 public:
  bool has(std::string_view key) const;  ///< marks the key as known

  bool boolean(std::string_view key, std::optional<bool> otherwise = {}) const;
  /// A TOML integer; 4.0 is refused.
  int64_t integer(std::string_view key, IntegerRange accepted, std::optional<int64_t> otherwise = {}) const;
  /// A TOML float or integer, finite; NaN and infinities are refused.
  double real(std::string_view key, RealRange accepted = kAnyReal,
              std::optional<double> otherwise = {}) const;
  std::string text(std::string_view key, std::optional<std::string> otherwise = {}) const;
  /// Index into `names` of the text that stands there.
  size_t choice(std::string_view key, std::span<const std::string_view> names,
                std::optional<size_t> otherwise = {}) const;
  template <class E, size_t N>
  E choice(std::string_view key, const Named<E> (&named)[N],
           std::optional<std::type_identity_t<E>> otherwise = {}) const;
  /// True when the key is there and a text: for keys that take a text or a number.
  bool is_text(std::string_view key) const;
  /// Likewise for a whole number.
  bool is_integer(std::string_view key) const;

  /// Arrays; empty when the key is missing and `required` is false. `count` 0: any number.
  std::vector<double> reals(std::string_view key, RealRange accepted, size_t count,
                            bool required = true) const;
  std::vector<int64_t> integers(std::string_view key, IntegerRange accepted, size_t count,
                                bool required = true) const;
  std::vector<std::string> texts(std::string_view key, bool required = true) const;
  /// Texts out of `names`, no text twice.
  std::vector<std::string> choices(std::string_view key, std::span<const std::string_view> names,
                                   bool required = true) const;

  TomlTable table(std::string_view key) const;  ///< required
  /// An empty table when the key is missing.
  TomlTable table_or_empty(std::string_view key) const;
  std::optional<TomlTable> optional_table(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  ///< [[key]]; empty when missing

  /// Keys that stand in the table, in the order of the file; marks nothing.
  std::vector<std::string> keys() const;
  bool empty() const;
  /// Dotted path from the document's root: "camera", "light[1]"; empty for the root.
  const std::string& path() const;
  /// "scene.toml:12: " for an error about `key`, or about the table itself when the key is missing or empty.
  std::string where(std::string_view key = {}) const;
  /// usage_error: "scene.toml:12: `camera.angle` " + sentence.
  Error error(std::string_view key, const std::string& sentence) const;

 private:
  friend class TomlDocument;
  std::shared_ptr<strict_toml_detail::Node> node_;
};

/// A TOML file whose every key must be asked for.
class TomlDocument {
 public:
  /// Throws usage_error for a missing, unreadable, empty or oversized (256 KiB) file and for broken syntax.
  static TomlDocument read_file(const std::string& path);
  /// `name` stands in messages in the place of a file name.
  static TomlDocument read_text(std::string_view text, const std::string& name);

  const std::string& name() const { return name_; }
  TomlTable root() const { return root_; }
  /// Sets or replaces the value at a dotted path; `value` is TOML, or a bare text. Messages about it say
  /// `origin` ("--set camera.angle=95") in the place of file and line. Throws usage_error.
  void set(std::string_view dotted_path, std::string_view value, const std::string& origin);
  /// Throws usage_error for the first key that nobody asked for, with the nearest name somebody asked for.
  void finish() const;

 private:
  std::string name_;
  TomlTable root_;
};

template <class E, size_t N>
E TomlTable::choice(std::string_view key, const Named<E> (&named)[N],
                    std::optional<std::type_identity_t<E>> otherwise) const {
  std::array<std::string_view, N> names;
  std::optional<size_t> fallback;
  for (size_t k = 0; k < N; ++k) {
    names[k] = named[k].first;
    if (otherwise && named[k].second == *otherwise) fallback = k;
  }
  return named[choice(key, names, fallback)].second;
}

}  // namespace cuesta
