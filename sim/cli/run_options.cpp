#include "sim/cli/run_options.h"
#include "sim/config/on_architecture.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "models/common/words.h"
#include "sim/cli/options.h"
#include "sim/hosts/systemc/systemc_host.h"
#include "sim/machine/transaction_run.h"
#include "sim/session/measure.h"

namespace cuesta {

void RunOptions::declare(Options& options) {
  options
      .add("--fidelity", fidelity,
           "functional (hits and steps, no time), transaction (cycles and traffic estimated, rays "
           "running ahead of "
           "time), cycle (every cycle of every unit), or rtl (cycle with the hardware, Verilated, in "
           "the place of its "
           "units: units.hmt_top)")
      .with_default();
  options
      .add("--host", host,
           "direct (the event loop) or systemc (the machine as a SystemC module, its dram behind a TLM "
           "socket)")
      .with_default();
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

Fidelity parse_fidelity(const std::string& name) {
  static constexpr std::string_view kNames[] = {"functional", "transaction", "cycle", "rtl"};
  for (size_t k = 0; k < std::size(kNames); ++k) {
    if (name == kNames[k]) return static_cast<Fidelity>(k);
  }
  const std::string near = did_you_mean(name, kNames);
  throw usage_error("There is no fidelity `" + printable(name) + "`; accepted are " + joined(kNames) +
                    (near.empty() ? "." : near));
}

Host parse_host(const std::string& name, Fidelity fidelity) {
  if (name == "direct") return Host::kDirect;
  static constexpr std::string_view kNames[] = {"direct", "systemc"};
  if (name != "systemc") {
    const std::string near = did_you_mean(name, kNames);
    throw usage_error("There is no host `" + printable(name) + "`; accepted are direct, systemc" +
                      (near.empty() ? "." : near));
  }
  if (fidelity == Fidelity::kFunctional || fidelity == Fidelity::kTransaction) {
    throw usage_error("--host systemc runs the machine in time, and --fidelity " +
                      std::string(name_of(fidelity)) +
                      (fidelity == Fidelity::kFunctional ? " has none" : " runs ahead of it") +
                      "; accepted with it are --fidelity cycle, rtl.");
  }
  return Host::kSystemC;
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

std::vector<std::string> split_at_commas(const std::vector<std::string>& texts, const char* option) {
  std::vector<std::string> parts;
  for (const std::string& text : texts) {
    for (const std::string_view part : split(text, ',')) {
      if (part.empty()) {
        throw usage_error(std::string(option) + " " + printable(text, 200) +
                          (text.empty() ? " names nothing" : " names nothing before or behind a comma") +
                          "; accepted are names with one comma between each two.");
      }
      parts.emplace_back(part);
    }
  }
  return parts;
}

namespace {

constexpr std::string_view kGroups[] = {"all", "parts", "searches", "printed"};

bool is_group(std::string_view name) { return std::ranges::find(kGroups, name) != std::end(kGroups); }

std::span<const Algorithm> group_of(std::string_view name) {
  return name == kGroups[0]   ? algorithms()
         : name == kGroups[1] ? algorithm_parts()
         : name == kGroups[2] ? searches()
                              : printed_searches();
}

bool is_accepted(const std::string& algorithm) {
  try {
    parse_algorithm(algorithm);
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// Where `name`, after a comma, is no algorithm but the rest of the one before it: a decimal comma, or a comma in the
/// place of a colon.
void refuse_comma_inside(const std::string& before, const std::string& name) {
  if (is_accepted(name)) return;
  const size_t equals = before.rfind('=');
  const bool number = equals != std::string::npos &&
                      before.find_first_not_of("0123456789", equals + 1) == std::string::npos &&
                      name[0] >= '0' && name[0] <= '9';
  const std::string joined = before + (number ? "." : ":") + name;
  if (!is_accepted(joined) && name.find('=') >= name.find(':')) return;
  throw usage_error("`" + printable(name) + "` stands after a comma, where the next algorithm begins; " +
                    (number ? "accepted is a decimal point, as in " : "accepted is ") +
                    printable(joined, 200) + (number ? "." : " for one with that ending."));
}

/// "root,common,never": where parts[k], no algorithm, becomes a schedule with what stands after the next commas.
void refuse_commas_for_colons(const std::vector<std::string>& parts, size_t k) {
  if (is_accepted(parts[k])) return;
  std::string schedule = parts[k], found = parts[k], longest, longest_found;
  for (size_t next = k + 1; next < parts.size(); ++next) {
    schedule += ":" + parts[next];
    found += "," + parts[next];
    if (!is_accepted(schedule)) continue;
    longest = schedule;
    longest_found = found;
  }
  if (longest.empty()) return;
  throw usage_error("`" + printable(longest_found, 200) +
                    "`: at a comma the next algorithm begins, and a schedule has colons; accepted is " +
                    printable(longest, 200) + ".");
}

/// Names that stand for several algorithms are known here alone: where one is meant, before parse_algorithm.
void refuse_groups_misspelt(const std::string& name) {
  const std::vector<std::string_view> words = split(name, '+');
  for (const std::string_view word : words) {
    if (words.size() == 1 || is_group(word)) continue;
    const std::string near = did_you_mean(word, kGroups);
    throw usage_error("`" + printable(word) + "` in `" + printable(name) +
                      "` is no group of algorithms; accepted between plus signs are " + joined(kGroups) +
                      (near.empty() ? ". Single algorithms are joined by commas." : near));
  }
  const std::string_view first = std::string_view(name).substr(0, name.find(':'));
  if (first.size() < name.size() && is_group(first)) {
    std::vector<std::string_view> ids;
    for (const Algorithm& algorithm : group_of(first)) ids.push_back(algorithm.id);
    throw usage_error("`" + printable(name) + "`: " + std::string(first) +
                      " are several algorithms, and an ending belongs to one; accepted are " + joined(ids) +
                      ", each with its own.");
  }
  if (is_accepted(name)) return;
  std::vector<std::string_view> names(std::begin(kGroups), std::end(kGroups));
  for (const std::span<const Algorithm> list :
       {algorithms(), algorithm_parts(), searches(), printed_searches()}) {
    for (const Algorithm& algorithm : list) names.push_back(algorithm.id);
  }
  if (!is_group(nearest_name(name, names))) return;
  throw usage_error(
      "There is no algorithm or group `" + printable(name) +
      "`; accepted are the groups all, parts, searches and printed, what `cuesta list algorithms` "
      "prints, and schedules" +
      did_you_mean(name, kGroups));
}

}  // namespace

std::vector<Algorithm> parse_algorithms(const std::vector<std::string>& names) {
  std::vector<std::string> parts = split_at_commas(names, "--algorithm");
  if (parts.empty()) parts.emplace_back("all");
  std::vector<Algorithm> found;
  const auto add = [&](const Algorithm& algorithm) {
    for (const Algorithm& earlier : found) {
      if (earlier.id == algorithm.id)
        throw usage_error("Algorithm " + algorithm.id + " is given twice; accepted is once.");
    }
    found.push_back(algorithm);
  };
  for (size_t k = 0; k < parts.size(); ++k) {
    // "all+parts+searches+printed": several groups, joined by plus signs
    const std::vector<std::string_view> groups = split(parts[k], '+');
    if (std::ranges::all_of(groups, is_group)) {
      for (const std::string_view group : groups) std::ranges::for_each(group_of(group), add);
      continue;
    }
    if (k > 0) refuse_comma_inside(parts[k - 1], parts[k]);
    refuse_commas_for_colons(parts, k);
    refuse_groups_misspelt(parts[k]);
    add(parse_algorithm(parts[k]));
  }
  return found;
}

std::vector<ResolvedArchitecture> parse_architectures(const std::vector<std::string>& names,
                                                      const std::vector<std::string>& settings,
                                                      Fidelity fidelity) {
  std::vector<ResolvedArchitecture> found;
  for (const std::string& name : split_at_commas(names, "--arch")) {
    found.push_back(resolve_architecture(name, settings, fidelity != Fidelity::kFunctional));
    if (fidelity == Fidelity::kTransaction) check_loosely_timed(found.back().architecture);
    if (fidelity == Fidelity::kRtl) {
      for (const std::string& setting : settings) {
        if (setting.starts_with("units."))
          throw usage_error("--set " + setting +
                            ": --fidelity rtl says it all; accepted with it is --fidelity cycle.");
      }
      found.back().set("units.hmt_top", static_cast<int64_t>(Implementation::kRtl), "--fidelity rtl");
    }
    for (size_t k = 0; k + 1 < found.size(); ++k) {
      if (found[k].architecture.name == found.back().architecture.name) {
        throw usage_error("Two architectures are named " + found[k].architecture.name +
                          "; accepted are different names, since results are told apart by them.");
      }
    }
  }
  if (found.empty())
    throw usage_error("--arch names no architecture; `cuesta list architectures` prints all.");
  return found;
}

void check_searches(const std::vector<Algorithm>& algorithms,
                    const std::vector<ResolvedArchitecture>& machines, Host host) {
  for (const Algorithm& algorithm : algorithms) {
    if (algorithm.exact()) continue;
    if (host == Host::kSystemC) check_served_by_systemc(algorithm.search);
    for (const ResolvedArchitecture& machine : machines) {
      algorithm_on(algorithm, machine.architecture.traverse);
      const UnitParameters& units = machine.architecture.units;
      if (units.hmt_top == Implementation::kRtl || units.traverse == Implementation::kRtl) {
        throw usage_error("The hardware (--fidelity rtl, [units]) has exact algorithms, and " + algorithm.id +
                          " is a search; accepted with it are exact algorithms.");
      }
    }
  }
}

std::string scene_or_default(const std::string& named, const RunOptions& options) {
  if (!named.empty()) return named;
  if (!options.heightmap.empty()) return "default";
  throw usage_error(
      "No scene is given; accepted is a scene file, a name out of `cuesta list scenes`, or --heightmap.");
}

}  // namespace cuesta
