#include "sim/explore/adversary/adversary_files.h"

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "models/common/words.h"
#include "traces/heightmaps/image_writer.h"
#include "traces/rays_csv.h"

namespace cuesta {
namespace {

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// Makes an algorithm's name fit for files: "root:2:never" is "root-2-never".
std::string file_name(std::string id) {
  std::replace(id.begin(), id.end(), ':', '-');
  std::erase(id, '=');
  return id;
}

/// Writes a text as a basic string of TOML.
std::string quoted(const std::string& value) {
  std::string text = "\"";
  for (const char letter : value) {
    if (letter == '"' || letter == '\\') text += '\\';
    text += letter;
  }
  return text + "\"";
}

std::string settings_of(const AdversaryRecord& record) {
  std::string text;
  for (const std::string& setting : record.settings) text += " --set " + setting;
  return text;
}

std::string scene_text(const AdversaryRecord& record) {
  return "name = \"worst-" + std::string(maximise_names()[static_cast<size_t>(record.maximise)]) + "-" +
         file_name(record.algorithm) + "\"\ndescription = \"Found by cuesta adversary: the worst " +
         std::string(unit_of(record.maximise)) + " of " + record.algorithm +
         "\"\n\n[heightmap]\nfile = \"map.png\"\nbits = " + std::to_string(record.options.bounds.bits) +
         "\nnormalise = \"none\"\naddress_mode = \"" + std::string(name_of(record.address_mode)) +
         "\"\n\n[rays]\nfile = \"rays.csv\"\n";
}

std::string case_text(const AdversaryRecord& record, const AdversaryResult& result) {
  const auto text = [](const std::string& key, const std::string& value) {
    return key + " = " + quoted(value) + "\n";
  };
  std::string settings;
  for (const std::string& setting : record.settings)
    settings += (settings.empty() ? "" : ", ") + quoted(setting);
  return text("algorithm", record.algorithm) +
         text("maximise", std::string(maximise_names()[static_cast<size_t>(record.maximise)])) +
         text("architecture", record.architecture) + "settings = [" + settings + "]\n" +
         text("address_mode", std::string(name_of(record.address_mode))) +
         "score = " + shortest_text(result.score) + "\n" +
         text("unit", std::string(unit_of(record.maximise))) +
         "leaf_walk = " + shortest_text(record.leaf_walk) + "\n" + text("fault", result.fault) +
         text("found_by", finding_command(record, result.best_try)) +
         "tries = " + std::to_string(result.tries) + "\nbest_try = " + std::to_string(result.best_try) + "\n";
}

std::string readme_text(const AdversaryRecord& record, const AdversaryResult& result) {
  const AdversaryBounds& bounds = record.options.bounds;
  return "# " + record.algorithm + ": " + rounded(result.score) + " " +
         std::string(unit_of(record.maximise)) + "\n\nThe worst of " + std::to_string(result.tries) +
         " cases that were scored (number " + std::to_string(result.best_try) + "): a map of " +
         std::to_string(bounds.width) + " x " + std::to_string(bounds.height) + " texels, address mode " +
         std::string(name_of(record.address_mode)) + ", and " + std::to_string(bounds.rays) +
         " rays that fall through the slab within " + shortest_text(bounds.reach) +
         " tiles along u and v. The leaf walk takes " + rounded(record.leaf_walk) + " on it.\n" +
         (result.fault.empty() ? "" : "\n**An exact algorithm is not exact here:** " + result.fault + "\n") +
         "\nFound by\n\n    " + finding_command(record, result.best_try) +
         " -o FOLDER\n\nand run from this folder by\n\n    " + reproducing_command(record, ".") + "\n\n" +
         place_of_score(record) + "\n";
}

/// Quotes a text where a shell would read it otherwise.
std::string shell_word(const std::string& text) {
  const bool plain = std::ranges::all_of(text, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '/' || c == '.' || c == '-' || c == '_' || c >= 0x80;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

std::string finding_command(const AdversaryRecord& record, uint64_t tries) {
  const AdversaryBounds& bounds = record.options.bounds;
  return "cuesta adversary --algorithm " + record.algorithm + " --maximise " +
         std::string(maximise_names()[static_cast<size_t>(record.maximise)]) + " --arch " +
         record.architecture + settings_of(record) + " --address " +
         std::string(name_of(record.address_mode)) + " --size " + std::to_string(bounds.width) + "x" +
         std::to_string(bounds.height) + " --bits " + std::to_string(bounds.bits) + " --rays " +
         std::to_string(bounds.rays) + " --reach " + shortest_text(bounds.reach) + " --seed " +
         std::to_string(record.options.seed) + " --tries " + std::to_string(tries);
}

std::string place_of_score(const AdversaryRecord& record) {
  if (record.maximise == Maximise::kSteps)
    return "The run's steps per ray are the score: machine.steps over machine.rays of its result.json.";
  if (record.maximise == Maximise::kCycles)
    return "The score is machine.cycles over machine.rays of the run's result.json.";
  return (!parse_algorithm(record.algorithm).exact()
              ? "The run does not print the score: its error.wrong counts rays, and its height_error holds "
                "height LSBs of the rays that hit and truly hit."
              : "The run does not print the score, since it judges no exact algorithm.") +
         std::string(" It is `score` in case.toml, and the search that found it prints it again.");
}

std::string reproducing_command(const AdversaryRecord& record, const std::string& folder) {
  return "cuesta run " + shell_word(folder + "/scene.toml") + " --algorithm " + record.algorithm +
         " --arch " + record.architecture + settings_of(record) + " --fidelity " +
         (record.maximise == Maximise::kCycles ? "cycle" : "functional");
}

void write_adversary_files(const AdversaryRecord& record, const AdversaryResult& result,
                           ResultFolder& folder) {
  write_height_image(folder.file("map.png").string(), result.best.grid);
  RayTrace trace;
  trace.width = static_cast<int>(result.best.rays.size());
  trace.height = 1;
  trace.rays = result.best.traced();
  write_rays_csv(folder.file("rays.csv").string(), trace);
  folder.write("scene.toml", scene_text(record));
  folder.write("case.toml", case_text(record, result));
  folder.write("README.md", readme_text(record, result));
}

}  // namespace cuesta
