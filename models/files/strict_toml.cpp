#include "models/files/strict_toml.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "models/files/strict_toml_node.h"

namespace cuesta {
namespace {

using strict_toml_detail::description;
using strict_toml_detail::Kind;
using strict_toml_detail::Node;

constexpr uintmax_t kLargestFile = 256 * 1024;

Error value_error(const Node& node, const std::string& accepted) {
  return usage_error(node.place + ": `" + node.path + "` is " + description(node) + "; accepted is " +
                     accepted + ".");
}

std::string child_path(const Node& table, std::string_view key) {
  return table.path.empty() ? std::string(key) : table.path + "." + std::string(key);
}

std::vector<std::string_view> views(const std::vector<std::string>& texts) {
  return {texts.begin(), texts.end()};
}

/// The value at `key`, marked as known, or nullptr.
Node* ask(Node& table, std::string_view key) {
  if (std::find(table.asked.begin(), table.asked.end(), key) == table.asked.end())
    table.asked.emplace_back(key);
  Node* node = table.child(key);
  if (node) node->known = true;
  return node;
}

Node* ask(Node& table, std::string_view key, bool required, const std::string& accepted) {
  Node* node = ask(table, key);
  if (node || !required) return node;
  const std::string_view name[] = {key};
  for (const auto& child : table.children) {  // a misspelt key reads as a missing one
    if (!child->known && !nearest_name(child->key, name).empty()) {
      throw usage_error(child->place + ": unknown key `" + printable(child->path) + "`; did you mean `" +
                        std::string(key) + "`?");
    }
  }
  throw usage_error(table.place + ": `" + child_path(table, key) + "` is missing; accepted is " + accepted +
                    ".");
}

std::string range_text(IntegerRange range) {
  return "a whole number from " + std::to_string(range.low) + " to " + std::to_string(range.high);
}

std::string range_text(RealRange range) {
  if (range.low == kAnyReal.low && range.high == kAnyReal.high) return "a finite number";
  if (range.high == kAnyReal.high) return "a finite number from " + shortest_text(range.low) + " up";
  return "a number from " + shortest_text(range.low) + " to " + shortest_text(range.high);
}

int64_t integer_of(const Node& node, IntegerRange accepted) {
  if (node.kind != Kind::kInteger || node.integer < accepted.low || node.integer > accepted.high) {
    throw value_error(node, range_text(accepted));
  }
  return node.integer;
}

double real_of(const Node& node, RealRange accepted) {
  const double value = node.kind == Kind::kInteger ? static_cast<double>(node.integer) : node.real;
  const bool number = node.kind == Kind::kInteger || node.kind == Kind::kReal;
  if (!number || !std::isfinite(value) || value < accepted.low || value > accepted.high) {
    throw value_error(node, range_text(accepted));
  }
  return value;
}

std::string choice_error(const Node& node, std::span<const std::string_view> names) {
  std::string message =
      node.place + ": `" + node.path + "` is " + description(node) + "; accepted is one of " + joined(names);
  const std::string near = node.kind == Kind::kText ? did_you_mean(node.text, names) : "";
  return message + (near.empty() ? "." : near);
}

size_t choice_of(const Node& node, std::span<const std::string_view> names) {
  const auto found = std::find(names.begin(), names.end(), node.text);
  if (node.kind != Kind::kText || found == names.end()) throw usage_error(choice_error(node, names));
  return static_cast<size_t>(found - names.begin());
}

/// The elements of an array, or of a missing one.
std::span<const std::shared_ptr<Node>> elements(Node& table, std::string_view key, bool required,
                                                size_t count, const std::string& of_what) {
  const std::string accepted = "an array of " + (count ? std::to_string(count) + " " : "") + of_what;
  const Node* node = ask(table, key, required, accepted);
  if (!node) return {};
  if (node->kind != Kind::kArray || (count && node->children.size() != count))
    throw value_error(*node, accepted);
  return node->children;
}

}  // namespace

bool TomlTable::has(std::string_view key) const { return ask(*node_, key) != nullptr; }

bool TomlTable::is_text(std::string_view key) const {
  const Node* node = ask(*node_, key);
  return node && node->kind == Kind::kText;
}

bool TomlTable::is_integer(std::string_view key) const {
  const Node* node = ask(*node_, key);
  return node && node->kind == Kind::kInteger;
}

bool TomlTable::boolean(std::string_view key, std::optional<bool> otherwise) const {
  const Node* node = ask(*node_, key, !otherwise, "true or false");
  if (!node) return *otherwise;
  if (node->kind != Kind::kBoolean) throw value_error(*node, "true or false");
  return node->boolean;
}

int64_t TomlTable::integer(std::string_view key, IntegerRange accepted,
                           std::optional<int64_t> otherwise) const {
  const Node* node = ask(*node_, key, !otherwise, range_text(accepted));
  return node ? integer_of(*node, accepted) : *otherwise;
}

double TomlTable::real(std::string_view key, RealRange accepted, std::optional<double> otherwise) const {
  const Node* node = ask(*node_, key, !otherwise, range_text(accepted));
  return node ? real_of(*node, accepted) : *otherwise;
}

std::string TomlTable::text(std::string_view key, std::optional<std::string> otherwise) const {
  const Node* node = ask(*node_, key, !otherwise, "a text");
  if (!node) return *otherwise;
  if (node->kind != Kind::kText) throw value_error(*node, "a text");
  return node->text;
}

size_t TomlTable::choice(std::string_view key, std::span<const std::string_view> names,
                         std::optional<size_t> otherwise) const {
  const Node* node = ask(*node_, key, !otherwise, "one of " + joined(names));
  return node ? choice_of(*node, names) : *otherwise;
}

std::vector<double> TomlTable::reals(std::string_view key, RealRange accepted, size_t count,
                                     bool required) const {
  std::vector<double> values;
  for (const auto& node : elements(*node_, key, required, count, "numbers"))
    values.push_back(real_of(*node, accepted));
  return values;
}

std::vector<int64_t> TomlTable::integers(std::string_view key, IntegerRange accepted, size_t count,
                                         bool required) const {
  std::vector<int64_t> values;
  for (const auto& node : elements(*node_, key, required, count, "whole numbers")) {
    values.push_back(integer_of(*node, accepted));
  }
  return values;
}

std::vector<std::string> TomlTable::texts(std::string_view key, bool required) const {
  std::vector<std::string> values;
  for (const auto& node : elements(*node_, key, required, 0, "texts")) {
    if (node->kind != Kind::kText) throw value_error(*node, "a text");
    values.push_back(node->text);
  }
  return values;
}

std::vector<std::string> TomlTable::choices(std::string_view key, std::span<const std::string_view> names,
                                            bool required) const {
  std::vector<std::string> values;
  for (const auto& node : elements(*node_, key, required, 0, "names out of " + joined(names))) {
    const std::string name(names[choice_of(*node, names)]);
    if (std::find(values.begin(), values.end(), name) != values.end()) {
      throw usage_error(node->place + ": `" + node->path + "` names \"" + name + "\" a second time.");
    }
    values.push_back(name);
  }
  return values;
}

TomlTable TomlTable::table(std::string_view key) const {
  Node* node = ask(*node_, key, true, "a table [" + child_path(*node_, key) + "]");
  return *optional_table(node->key);
}

std::optional<TomlTable> TomlTable::optional_table(std::string_view key) const {
  Node* node = ask(*node_, key);
  if (!node) return {};
  if (node->kind != Kind::kTable) throw value_error(*node, "a table [" + node->path + "]");
  TomlTable table;
  table.node_ = std::shared_ptr<Node>(node_, node);  // keeps the document alive
  return table;
}

TomlTable TomlTable::table_or_empty(std::string_view key) const {
  if (auto table = optional_table(key)) return *table;
  TomlTable empty;
  empty.node_ = std::make_shared<Node>();
  empty.node_->key = key;
  empty.node_->path = child_path(*node_, key);
  empty.node_->place = node_->place;
  return empty;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const std::string accepted = "tables [[" + child_path(*node_, key) + "]]";
  std::vector<TomlTable> tables;
  Node* array = ask(*node_, key);
  if (array && array->kind != Kind::kArray) throw value_error(*array, accepted);
  for (const auto& node : elements(*node_, key, false, 0, "tables")) {
    if (node->kind != Kind::kTable) throw value_error(*node, accepted);
    TomlTable table;
    table.node_ = std::shared_ptr<Node>(node_, node.get());
    tables.push_back(std::move(table));
  }
  return tables;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> keys;
  for (const auto& child : node_->children) keys.push_back(child->key);
  return keys;
}

bool TomlTable::empty() const { return node_->children.empty(); }

const std::string& TomlTable::path() const { return node_->path; }

std::string TomlTable::where(std::string_view key) const {
  const Node* node = key.empty() ? nullptr : node_->child(key);
  return (node ? node->place : node_->place) + ": ";
}

Error TomlTable::error(std::string_view key, const std::string& sentence) const {
  return usage_error(where(key) + "`" + (key.empty() ? node_->path : child_path(*node_, key)) + "` " +
                     sentence);
}

TomlDocument TomlDocument::read_text(std::string_view text, const std::string& name) {
  if (text.size() > kLargestFile) {
    throw usage_error(name + ": holds " + std::to_string(text.size()) + " bytes; accepted are at most " +
                      std::to_string(kLargestFile) + ".");
  }
  TomlDocument document;
  document.name_ = name;
  document.root_.node_ = strict_toml_detail::parse_toml(text, name);
  if (document.root_.empty()) throw usage_error(name + ": holds no keys.");
  return document;
}

TomlDocument TomlDocument::read_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code failure;
  const std::string name = printable(path).size() == path.size() ? path : printable(path);
  const fs::file_status status = fs::status(path, failure);
  if (status.type() == fs::file_type::not_found) throw usage_error(name + ": there is no such file.");
  if (fs::is_directory(status)) throw usage_error(name + ": this is a folder; accepted is a TOML file.");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw usage_error(name + ": cannot be read: " + std::strerror(errno) + ".");
  std::string text(kLargestFile + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw usage_error(name + ": cannot be read.");
  text.resize(static_cast<size_t>(file.gcount()));
  if (text.empty()) throw usage_error(name + ": the file is empty.");
  if (text.size() > kLargestFile) {
    throw usage_error(name + ": is larger than the " + std::to_string(kLargestFile) + " bytes accepted.");
  }
  return read_text(text, name);
}

void TomlDocument::set(std::string_view dotted_path, std::string_view value, const std::string& origin) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  std::shared_ptr<Node> parsed;
  try {
    parsed = strict_toml_detail::parse_toml("value = " + std::string(value), origin);
    if (parsed->children.size() != 1) parsed = nullptr;
  } catch (const Error&) {
  }
  std::shared_ptr<Node> leaf = parsed ? parsed->children[0] : std::make_shared<Node>();
  if (!parsed) {
    leaf->kind = Kind::kText;
    leaf->text = value;
  }
  leaf->path = std::string(dotted_path);
  leaf->place = origin;

  Node* table = root_.node_.get();
  for (std::string_view rest = dotted_path;;) {
    const size_t dot = rest.find('.');
    const std::string_view name = rest.substr(0, dot);
    if (name.empty() || !std::all_of(name.begin(), name.end(), letter)) {
      throw usage_error(origin + ": `" + printable(dotted_path) +
                        "` is not a key; accepted are names joined by dots.");
    }
    if (table->kind != Kind::kTable)
      throw value_error(*table, "a table, to hold `" + std::string(dotted_path) + "`");
    const auto at = std::find_if(table->children.begin(), table->children.end(),
                                 [&](const auto& child) { return child->key == name; });
    if (dot == std::string_view::npos) {
      leaf->key = std::string(name);
      if (at != table->children.end())
        *at = leaf;
      else
        table->children.push_back(leaf);
      return;
    }
    if (at == table->children.end()) {
      auto section = std::make_shared<Node>();
      section->key = std::string(name);
      section->path = child_path(*table, name);
      section->place = origin;
      table->children.push_back(section);
      table = section.get();
    } else {
      table = at->get();
    }
    rest.remove_prefix(dot + 1);
  }
}

namespace {

void refuse_unknown(const Node& node) {
  for (const auto& child : node.children) {
    if (node.kind == Kind::kTable && !child->known) {
      const auto names = views(node.asked);
      const std::string near = did_you_mean(child->key, names);
      throw usage_error(child->place + ": unknown key `" + printable(child->path) + "`" +
                        (near.empty() ? "; accepted here: " + joined(names) + "." : near));
    }
    refuse_unknown(*child);
  }
}

}  // namespace

void TomlDocument::finish() const { refuse_unknown(*root_.node_); }

}  // namespace cuesta
