#include <algorithm>
#include <stdexcept>

#include "models/common/error.h"
#include "models/common/strict_toml_node.h"
#include "models/common/words.h"

// The only file that compiles toml++ (3.3.0). Broken files reach some of its assertions, as by a table named [.];
// with NDEBUG it would take them for granted and go on. Here they are errors like any other.
[[noreturn]] static void toml_assertion_failed() { throw std::logic_error("malformed"); }
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>((condition) || (toml_assertion_failed(), true))
#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace cuesta::strict_toml_detail {
namespace {

/// The library destroys nested tables recursively, so one line with 100,000 dots would exhaust the stack. The dot
/// of a decimal number does not count.
void refuse_deep_keys(std::string_view text, const std::string& name) {
  constexpr int kMostDots = 32;
  int line = 1, dots = 0;
  for (size_t k = 0; k < text.size();) {
    if (text[k] == '\n') {
      ++line;
      dots = 0;
    }
    const size_t end = std::min(text.find_first_not_of("0123456789.", k), text.size());
    const auto in_run = std::count(text.begin() + k, text.begin() + end, '.');
    const bool decimal = in_run == 1 && text[k] != '.' && text[end - 1] != '.';
    if (!decimal) dots += static_cast<int>(in_run);
    if (dots > kMostDots) {
      throw usage_error(name + ":" + std::to_string(line) + ": the line has more than " +
                        std::to_string(kMostDots) + " dots; keys are at most " + std::to_string(kDeepest) +
                        " names deep.");
    }
    k = std::max(end, k + 1);
  }
}

std::shared_ptr<Node> converted(const toml::node& from, const std::string& key, const std::string& path,
                                const std::string& name, int depth) {
  auto node = std::make_shared<Node>();
  node->key = key;
  node->path = path;
  node->line = static_cast<int>(from.source().begin.line);
  node->place = node->line > 0 ? name + ":" + std::to_string(node->line) : name;
  if (depth > kDeepest) {
    throw usage_error(node->place + ": `" + printable(path) + "` is nested more than " +
                      std::to_string(kDeepest) + " levels deep.");
  }
  if (const toml::table* table = from.as_table()) {
    node->kind = Kind::kTable;
    for (const auto& [child_key, child] : *table) {
      const std::string child_name(child_key.str());
      node->children.push_back(
          converted(child, child_name, path.empty() ? child_name : path + "." + child_name, name, depth + 1));
    }
    std::stable_sort(node->children.begin(), node->children.end(),
                     [](const auto& a, const auto& b) { return a->line < b->line; });
  } else if (const toml::array* array = from.as_array()) {
    node->kind = Kind::kArray;
    for (const toml::node& child : *array) {
      const std::string index = "[" + std::to_string(node->children.size()) + "]";
      node->children.push_back(converted(child, "", path + index, name, depth + 1));
    }
  } else if (const auto* text = from.as_string()) {
    node->kind = Kind::kText;
    node->text = text->get();
  } else if (const auto* integer = from.as_integer()) {
    node->kind = Kind::kInteger;
    node->integer = integer->get();
  } else if (const auto* real = from.as_floating_point()) {
    node->kind = Kind::kReal;
    node->real = real->get();
  } else if (const auto* boolean = from.as_boolean()) {
    node->kind = Kind::kBoolean;
    node->boolean = boolean->get();
  } else {
    node->kind = Kind::kDate;
  }
  return node;
}

/// The first line whose end a failing assertion's cause lies before.
int malformed_line(std::string_view text) {
  int line = 1;
  for (size_t end = text.find('\n'); end < text.size(); end = text.find('\n', end + 1), ++line) {
    try {
      static_cast<void>(toml::parse(text.substr(0, end + 1)));
    } catch (const toml::parse_error&) {
    } catch (const std::logic_error&) {
      break;
    }
  }
  return line;
}

}  // namespace

std::shared_ptr<Node> parse_toml(std::string_view text, const std::string& name) {
  refuse_deep_keys(text, name);
  try {
    const toml::table table = toml::parse(text, name);
    auto root = converted(table, "", "", name, 0);
    root->place = name;
    root->known = true;
    return root;
  } catch (const toml::parse_error& error) {
    throw usage_error(name + ":" + std::to_string(error.source().begin.line) +
                      ": this is not TOML: " + printable(error.description(), 300) + ".");
  } catch (const std::logic_error&) {
    throw usage_error(name + ":" + std::to_string(malformed_line(text)) + ": this is not TOML: malformed.");
  }
}

std::string description(const Node& node) {
  switch (node.kind) {
    case Kind::kTable:
      return "a table";
    case Kind::kArray:
      return "an array of " + std::to_string(node.children.size());
    case Kind::kText:
      return "the text \"" + printable(node.text) + "\"";
    case Kind::kInteger:
      return std::to_string(node.integer);
    case Kind::kReal:
      return shortest_text(node.real);
    case Kind::kBoolean:
      return node.boolean ? "true" : "false";
    case Kind::kDate:
      break;
  }
  return "a date or time";
}

}  // namespace cuesta::strict_toml_detail
