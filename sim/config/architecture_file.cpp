#include "sim/config/architecture_file.h"

#include <algorithm>
#include <bit>
#include <filesystem>

#include "models/files/strict_toml.h"
#include "sim/config/parameters.h"

namespace cuesta {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepestBase = 8;

bool is_file_name(const std::string& text) {
  return text.ends_with(".toml") || text.find('/') != std::string::npos;
}

const Preset* find_preset(std::string_view name) {
  for (const Preset& preset : presets()) {
    if (preset.name == name) return &preset;
  }
  return nullptr;
}

int64_t read_value(const Parameter& parameter, const TomlTable& section) {
  const std::string_view key = parameter.key();
  if (!parameter.names.empty()) {
    // `down = 2` is as good as `down = "2"`.
    if (!section.is_text(key)) {
      const auto names = std::span(parameter.names).subspan(1);
      const bool numbers = std::find(names.begin(), names.end(), "1") != names.end();
      if (numbers && section.is_integer(key)) {
        const std::string digits = std::to_string(section.integer(key, {-1000, 1000}));
        const auto at = std::find(parameter.names.begin(), parameter.names.end(), digits);
        if (at != parameter.names.end()) return at - parameter.names.begin();
        throw section.error(key, "is " + digits + "; accepted is " + parameter.accepted() + ".");
      }
    }
    return static_cast<int64_t>(section.choice(key, parameter.names));
  }
  const int64_t value = section.integer(key, {parameter.low, parameter.high});
  if (parameter.power_of_two && !std::has_single_bit(static_cast<uint64_t>(value))) {
    throw section.error(key, "is " + std::to_string(value) + "; accepted is " + parameter.accepted() + ".");
  }
  return value;
}

/// Puts what the document gives over `resolved`; `origin` empty: file and line.
void apply(const TomlTable& root, const std::string& origin, ResolvedArchitecture& resolved) {
  for (std::string_view name : parameter_sections()) {
    const TomlTable section = root.table_or_empty(name);
    for (size_t k = 0; k < parameters().size(); ++k) {
      const Parameter& parameter = parameters()[k];
      if (parameter.section() != name || !section.has(parameter.key())) continue;
      parameter.set(resolved.architecture, read_value(parameter, section));
      std::string where = section.where(parameter.key());
      resolved.origins[k] = origin.empty() ? where.substr(0, where.size() - 2) : origin;
    }
  }
}

void load(const std::string& preset_or_file, int depth, ResolvedArchitecture& resolved) {
  if (!is_file_name(preset_or_file)) {
    const Preset* preset = find_preset(preset_or_file);
    if (!preset) {
      std::vector<std::string_view> names;
      for (const Preset& known : presets()) names.push_back(known.name);
      const std::string near = did_you_mean(preset_or_file, names);
      throw usage_error("There is no architecture `" + printable(preset_or_file) + "`; accepted are " +
                        joined(names) + " or a file that ends in .toml" + (near.empty() ? "." : near));
    }
    const TomlDocument document = TomlDocument::read_text(preset->toml, "preset " + preset_or_file);
    apply(document.root(), document.name(), resolved);
    document.finish();
    resolved.architecture.name = preset_or_file;
    return;
  }
  const TomlDocument document = TomlDocument::read_file(preset_or_file);
  const TomlTable root = document.root();
  if (root.has("base")) {
    if (depth == kDeepestBase) {
      throw root.error("base", "is the " + std::to_string(kDeepestBase) +
                                   "th of a chain; accepted are fewer, and no circles.");
    }
    const std::string base = root.text("base");
    load(is_file_name(base) ? (fs::path(preset_or_file).parent_path() / base).string() : base, depth + 1,
         resolved);
  }
  apply(root, "", resolved);
  document.finish();
  resolved.files.push_back(preset_or_file);
  resolved.architecture.name = fs::path(preset_or_file).stem().string();
}

void apply_settings(std::span<const std::string> settings, ResolvedArchitecture& resolved) {
  if (settings.empty()) return;
  std::vector<std::string_view> paths;
  for (const Parameter& parameter : parameters()) paths.push_back(parameter.path);
  std::vector<std::string> seen;
  for (const std::string& setting : settings) {
    const auto [path, value] = split_setting(setting);
    if (!find_parameter(path)) {
      const std::string near = did_you_mean(path, paths);
      throw usage_error("--set " + printable(setting) + ": there is no parameter `" + printable(path) + "`" +
                        (near.empty() ? "; `cuesta list parameters` prints all." : near));
    }
    if (std::find(seen.begin(), seen.end(), path) != seen.end()) {
      throw usage_error("--set " + printable(setting) + ": `" + path + "` is set twice; accepted is once.");
    }
    seen.push_back(path);
    TomlDocument document = TomlDocument::read_text("settings = true", "--set " + printable(setting));
    document.set(path, value, document.name());
    apply(document.root(), "--set", resolved);
  }
}

/// Whole sections where none of their keys is used, else single keys.
std::vector<std::string> unused_in_files(const ResolvedArchitecture& resolved, bool with_time) {
  std::vector<std::string> unused;
  for (std::string_view section : parameter_sections()) {
    std::vector<std::string> keys;
    bool whole = true;
    for (size_t k = 0; k < parameters().size(); ++k) {
      const Parameter& parameter = parameters()[k];
      if (parameter.section() != section) continue;
      const std::string& origin = resolved.origins[k];
      const bool from_file = origin != "default" && origin != "--set" && !origin.starts_with("preset ");
      const bool used = why_unused(parameter, resolved.architecture, with_time).empty();
      if (used) whole = false;
      if (from_file && !used) keys.emplace_back(parameter.path);
    }
    if (whole && !keys.empty())
      unused.push_back("[" + std::string(section) + "]");
    else
      unused.insert(unused.end(), keys.begin(), keys.end());
  }
  return unused;
}

/// "fast.toml:4: " of the key that decides a contradiction: of those that the sentence names the one that was given
/// last, on the command line or else in a file; empty where all are a preset's or defaults.
std::string place_of(const std::string& contradiction, const ResolvedArchitecture& resolved) {
  std::string place;
  for (size_t k = 0; k < parameters().size(); ++k) {
    const std::string& origin = resolved.origins[k];
    if (origin == "default" || origin.starts_with("preset ")) continue;
    if (contradiction.find("`" + std::string(parameters()[k].path) + "`") == std::string::npos) continue;
    if (origin == "--set") return "--set " + std::string(parameters()[k].path) + ": ";
    if (place.empty()) place = origin + ": ";
  }
  return place;
}

}  // namespace

std::pair<std::string, std::string> split_setting(const std::string& setting) {
  const size_t equals = setting.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size()) {
    throw usage_error("--set " + printable(setting) + ": accepted is key=value, as in height_l1.ways=4.");
  }
  return {setting.substr(0, equals), setting.substr(equals + 1)};
}

ResolvedArchitecture resolve_architecture(const std::string& preset_or_file,
                                          std::span<const std::string> settings, bool with_time) {
  ResolvedArchitecture resolved;
  resolved.origins.assign(parameters().size(), "default");
  load(preset_or_file, 0, resolved);
  apply_settings(settings, resolved);
  const std::vector<std::string> wrong = contradictions(resolved.architecture);
  if (!wrong.empty()) {
    throw usage_error(place_of(wrong.front(), resolved) + "Architecture " + resolved.architecture.name +
                      ": " + wrong.front());
  }
  // Reports tell machines apart by their names.
  for (size_t k = 0; k < settings.size(); ++k) {
    resolved.architecture.name += (k == 0 ? " with " : ", ") + settings[k];
  }

  for (size_t k = 0; k < parameters().size(); ++k) {
    const Parameter& parameter = parameters()[k];
    const std::string reason = why_unused(parameter, resolved.architecture, with_time);
    if (!reason.empty() && resolved.origins[k] == "--set") {
      throw usage_error("--set " + std::string(parameter.path) + ": this run does not use it, because " +
                        reason + ".");
    }
  }
  resolved.unused = unused_in_files(resolved, with_time);
  return resolved;
}

void ResolvedArchitecture::set(std::string_view path, int64_t value, const std::string& origin) {
  const Parameter* parameter = find_parameter(path);
  parameter->set(architecture, value);
  origins[static_cast<size_t>(parameter - parameters().data())] = origin;
}

std::string ResolvedArchitecture::toml(bool with_time) const {
  std::string text = "# The machine of this run, every value of it. name: " + architecture.name + "\n";
  std::string_view section;
  for (size_t k = 0; k < parameters().size(); ++k) {
    const Parameter& parameter = parameters()[k];
    if (parameter.section() != section) {
      section = parameter.section();
      text += "\n[" + std::string(section) + "]\n";
    }
    std::string line = std::string(parameter.key()) + " = " + parameter.text(parameter.get(architecture));
    line.resize(std::max<size_t>(line.size(), 34), ' ');
    text += line + " # " + (parameter.unit.empty() ? "" : std::string(parameter.unit) + ", ") + origins[k];
    const std::string reason = why_unused(parameter, architecture, with_time);
    text += reason.empty() ? "\n" : "; not used: " + reason + "\n";
  }
  return text;
}

}  // namespace cuesta
