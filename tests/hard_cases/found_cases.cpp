#include "tests/hard_cases/found_cases.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "models/files/strict_toml.h"

namespace cuesta {
namespace {

constexpr const char* kFolder = "tests/hard_cases/found";

std::string short_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

}  // namespace

std::vector<FoundCase> found_cases() {
  std::vector<FoundCase> cases;
  if (!std::filesystem::is_directory(kFolder)) return cases;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    const TomlDocument document = TomlDocument::read_file((entry.path() / "case.toml").string());
    const TomlTable root = document.root();
    FoundCase found;
    found.name = entry.path().filename().string();
    found.folder = entry.path().string();
    found.algorithm = root.text("algorithm");
    found.maximise = root.text("maximise");
    found.architecture = root.text("architecture");
    found.settings = root.texts("settings", false);
    found.unit = root.text("unit");
    found.score = root.real("score");
    found.leaf_walk = root.real("leaf_walk");
    found.command = root.text("found_by");
    cases.push_back(found);
  }
  std::sort(cases.begin(), cases.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  return cases;
}

std::string found_table() {
  const std::vector<FoundCase> cases = found_cases();
  std::string text = "\n## Found by `cuesta adversary`\n";
  if (cases.empty()) return text + "None is kept yet.\n";
  text += "| case | algorithm | worst | the leaf walk there | of | found by |\n|---|---|---|---|---|---|\n";
  for (const FoundCase& c : cases) {
    text += "| found/" + c.name + " | " + c.algorithm + " | " + short_text(c.score) + " | " +
            short_text(c.leaf_walk) + " | " + c.unit + " | `" + c.command + "` |\n";
  }
  return text;
}

}  // namespace cuesta
