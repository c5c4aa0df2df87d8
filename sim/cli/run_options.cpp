#include "sim/cli/run_options.h"

#include <charconv>
#include <filesystem>

#include "models/common/error.h"
#include "models/common/words.h"
#include "sim/cli/options.h"
#include "sim/session/hosts.h"

namespace cuesta {
namespace {

std::string host_meanings() {
  std::string text;
  for (const Host& host : hosts()) {
    text += (text.empty() ? "" : " or ") + std::string(host.name) + " (" + std::string(host.meaning) + ")";
  }
  return text;
}

}  // namespace

void RunOptions::declare(Options& options) {
  options
      .add("--fidelity", fidelity,
           "functional (hits and steps, no time), transaction (cycles and traffic estimated, rays "
           "running ahead of "
           "time), cycle (every cycle of every unit), or rtl (cycle with the hardware, Verilated, in "
           "the place of its "
           "units: units.hmt_top)")
      .with_default();
  options.add("--host", host, host_meanings()).with_default();
  options.add("--set", settings, "One value of the architecture: height_l1.ways=4; may be repeated");
  options.add(
      "--heightmap", heightmap,
      "Heights from an image in the place of the scene's: FILE or FILE:CHANNEL, as rocks.tga:A, and then "
      "any of ,values=depth ,bits=12 ,normalise=min_max ,range=-4.5..921 ,nodata=-9999 "
      ",raw=1024x1024:uint16");
  options.add("--rays", rays_file, "Rays from a .rays or .csv file in the place of the scene's camera");
  options.add("--angle", angle_degrees,
              "The camera's angle to the surface's normal: 0 front to 89.9 grazing");
  options.add("--depth", depth, "Thickness of the relief in widths of a tile: 0.0001 to 10");
  options.add(
      "--surface", surface,
      "What the heights mean, in the place of the scene's surface.kind: texel (each texel is flat) or "
      "bilinear (patches between the texels' middles; in float and double)");
  options.add("--size", size, "Pixels: 256 or 640x480");
  options.add("--crop", crop, "Only the pixels x,y,width,height of the frame");
  options.add("-o,--output", folder, "Result folder; default: the next free results/SCENE-ALGORITHM-NNN");
  options.add_flag("--force,--overwrite", force, "Replace an older result folder of that name");
  options.add_flag("--json", json, "Print result.json to stdout in the place of the table");
}

namespace {

std::pair<int, int> parse_size(const std::string& text) {
  const size_t cross = text.find('x');
  const std::string parts[] = {text.substr(0, cross),
                               cross == std::string::npos ? text : text.substr(cross + 1)};
  int sides[2];
  for (int k = 0; k < 2; ++k) {
    const char* end = parts[k].data() + parts[k].size();
    const auto [stop, fault] = std::from_chars(parts[k].data(), end, sides[k]);
    if (parts[k].empty() || fault != std::errc{} || stop != end || sides[k] < 1 || sides[k] > kLongestSide) {
      throw usage_error("--size " + printable(text) +
                        ": accepted is one number of pixels or WIDTHxHEIGHT, each from 1 to " +
                        std::to_string(kLongestSide) + ".");
    }
  }
  return {sides[0], sides[1]};
}

Surface parse_surface(const std::string& text) {
  for (const Surface surface : {Surface::kTexel, Surface::kBilinear}) {
    if (text == name_of(surface)) return surface;
  }
  static constexpr std::string_view kNames[] = {"texel", "bilinear"};
  const std::string near = did_you_mean(text, kNames);
  throw usage_error("There is no surface `" + printable(text) + "`; accepted are " + joined(kNames) +
                    (near.empty() ? "." : near));
}

std::optional<double> in_range(const char* option, std::optional<double> value, double low, double high) {
  if (!value || (*value >= low && *value <= high)) return value;
  throw usage_error(std::string(option) + " is " + shortest_text(*value) + "; accepted is a number from " +
                    shortest_text(low) + " to " + shortest_text(high) + ".");
}

/// "r.png:bits=12", where a channel's name stands.
void refuse_key_for_channel(const std::string& text) {
  static constexpr std::string_view kKeys[] = {"values=", "bits=", "normalise=", "range=", "nodata=", "raw="};
  std::error_code ignored;
  if (std::filesystem::exists(text, ignored)) return;
  for (const std::string_view key : kKeys) {
    const size_t colon = text.find(":" + std::string(key));
    if (colon == std::string::npos) continue;
    std::string meant = text;
    meant[colon] = ',';
    throw usage_error(
        "--heightmap " + printable(text, 200) +
        ": behind a colon stands a channel's name, and keys stand behind commas; did you mean " +
        printable(meant, 200) + "?");
  }
}

}  // namespace

SceneChanges scene_changes(const RunOptions& options) {
  SceneChanges changes;
  refuse_key_for_channel(options.heightmap);
  changes.heightmap = options.heightmap;
  changes.rays_file = options.rays_file;
  changes.angle_degrees = in_range("--angle", options.angle_degrees, 0, 89.9);
  changes.depth = in_range("--depth", options.depth, 1e-4, 10);
  if (!options.surface.empty()) changes.surface = parse_surface(options.surface);
  if (!options.size.empty()) changes.size = parse_size(options.size);
  if (!options.crop.empty()) changes.crop = parse_crop(options.crop);
  return changes;
}

std::string scene_or_default(const std::string& named, const RunOptions& options) {
  if (!named.empty()) return named;
  if (!options.heightmap.empty()) return "default";
  throw usage_error(
      "No scene is given; accepted is a scene file, a name out of `cuesta list scenes`, or --heightmap.");
}

}  // namespace cuesta
