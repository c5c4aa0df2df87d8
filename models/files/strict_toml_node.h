#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cuesta::strict_toml_detail {

enum class Kind : uint8_t { kTable, kArray, kText, kInteger, kReal, kBoolean, kDate };

struct Node {
  Kind kind = Kind::kTable;
  std::string key;    ///< of its table; empty in an array
  std::string path;   ///< dotted, from the root
  std::string place;  ///< "scene.toml:12"
  int line = 0;
  bool known = false;  ///< somebody asked for it
  std::string text;
  int64_t integer = 0;
  double real = 0;
  bool boolean = false;
  std::vector<std::shared_ptr<Node>> children;  ///< of a table or array, in the order of the file
  std::vector<std::string> asked;               ///< of a table: keys that somebody asked for

  Node* child(std::string_view name) const {
    for (const auto& node : children) {
      if (node->key == name) return node.get();
    }
    return nullptr;
  }
};

/// Deepest nesting of tables and arrays that is read.
inline constexpr int kDeepest = 16;

/// Throws usage_error, with `name` in the place of a file name.
std::shared_ptr<Node> parse_toml(std::string_view text, const std::string& name);

/// "the text \"x\"", "the table", "4.5".
std::string description(const Node& node);

}  // namespace cuesta::strict_toml_detail
