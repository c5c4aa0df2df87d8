#include "sim/cli/heightmap_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <filesystem>

#include "models/common/words.h"
#include "models/heightmap/generator.h"
#include "models/heightmap/texel_layout.h"
#include "sim/cli/output_file.h"
#include "sim/cli/verbs.h"
#include "traces/heightmaps/image_writer.h"

namespace cuesta {
namespace {

template <typename Number>
bool parse_number(std::string_view text, Number& value) {
  auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size();
}

std::string kind_list() {
  std::string list = "Kind of map:";
  for (const MapKind& kind : map_kinds()) list += fmt::format("\n{}: {}", kind.name, kind.meaning);
  return list;
}

constexpr std::pair<const char*, Normalisation> kNormalisations[] = {
    {"auto", Normalisation::kAuto}, {"none", Normalisation::kNone}, {"min_max", Normalisation::kMinMax}};

class MakeCommand : public Command {
 public:
  void declare(CLI::App& app) override {
    app.add_option("kind", options_.kind, kind_list())->required();
    app.add_option("-o,--output", options_.output, "File to write: .png, .tif or .tiff")->required();
    app.add_option("--size", size_, "Texels: 256 or 640x480, 1 to 16384 on a side; default: the kind's own");
    app.add_option("--bits", options_.bits, "Bits of a height, 1 to 16; default: the kind's own");
    app.add_option("--seed", options_.seed, "Another seed, another map of the kind")->capture_default_str();
    app.add_flag("--force", options_.force, "Replace a file of that name");
  }
  ExitCode run(const Session& session) override {
    if (!size_.empty()) parse_map_size(size_, options_.width, options_.height);
    std::string line = heightmap_make(options_);
    if (!session.quiet) std::fprintf(stderr, "%s\n", line.c_str());
    return ExitCode::kOk;
  }

 private:
  HeightmapMakeOptions options_;
  std::string size_;
};

class InfoCommand : public Command {
 public:
  void declare(CLI::App& app) override {
    app.add_option("file", source_.path, "An image: PNG, TIFF, EXR, TGA, BMP, JPEG")->required();
    app.add_option("--channel", source_.channel,
                   "Name or index of the channel to read; default: the one that it can be");
    app.add_option("--values", values_, "What the file holds: height or depth")->capture_default_str();
    app.add_option("--bits", source_.bits, "Bits of a height, 1 to 16; default: 8 for 8-bit files, else 16");
    app.add_option("--normalise", normalise_, "auto, none or min_max")->capture_default_str();
    app.add_option("--range", range_, "LOW,HIGH: what becomes 0 and full scale, in the file's units");
  }
  ExitCode run(const Session&) override {
    if (values_ != "height" && values_ != "depth") {
      throw usage_error("--values " + printable(values_) + " is not known; accepted are height, depth.");
    }
    source_.invert = values_ == "depth";
    bool known = false;
    for (auto [name, rule] : kNormalisations) {
      if (normalise_ != name) continue;
      source_.normalisation = rule;
      known = true;
    }
    if (!known) {
      throw usage_error("--normalise " + printable(normalise_) +
                        " is not known; accepted are auto, none, min_max.");
    }
    if (!range_.empty()) {
      if (normalise_ != "auto") {
        throw usage_error("--range and --normalise " + normalise_ +
                          " contradict each other; accepted is one of them.");
      }
      source_.normalisation = Normalisation::kRange;
      parse_range(range_, source_.low, source_.high);
    }
    std::fputs(heightmap_info(source_).c_str(), stdout);
    return ExitCode::kOk;
  }

 private:
  HeightSource source_;
  std::string values_ = "height", normalise_ = "auto", range_;
};

}  // namespace

void parse_map_size(const std::string& text, int& width, int& height) {
  size_t cross = text.find('x');
  std::string_view first = std::string_view(text).substr(0, cross);
  std::string_view second = cross == std::string::npos ? first : std::string_view(text).substr(cross + 1);
  bool known = parse_number(first, width) && parse_number(second, height);
  if (!known || width < 1 || height < 1 || width > 16384 || height > 16384) {
    throw usage_error("--size " + printable(text) +
                      " is not a size; accepted are 256 or 640x480, 1 to 16384 texels on a side.");
  }
}

void parse_range(const std::string& text, double& low, double& high) {
  size_t comma = text.find(',');
  std::string_view whole = text;
  if (comma == std::string::npos || !parse_number(whole.substr(0, comma), low) ||
      !parse_number(whole.substr(comma + 1), high)) {
    throw usage_error("--range " + printable(text) +
                      " is not a range; accepted are two numbers, as -4.5,900.");
  }
}

std::string heightmap_make(const HeightmapMakeOptions& options) {
  refuse_existing(options.output, options.force);
  check_height_image_name(options.output);
  if (options.bits < 0) {
    throw usage_error("--bits " + std::to_string(options.bits) + " is not accepted; 1 to 16 bits are.");
  }
  HeightGrid grid = generate(options.kind, options.width, options.height, options.bits, options.seed);
  write_height_image(options.output, grid, options.force);
  return fmt::format("{}: {}, {} x {} texels of {} bits, seed {}.", options.output, options.kind, grid.width,
                     grid.height, grid.bits, options.seed);
}

std::string heightmap_info(const HeightSource& source) {
  LoadedHeights loaded = load_heights(source);
  const HeightStatement& found = loaded.statement;
  Pyramid pyramid = build_max_pyramid(loaded.grid);
  std::vector<std::string_view> channels(found.channels.begin(), found.channels.end());
  uint32_t lowest = loaded.grid.full_scale(), highest = 0;
  for (uint32_t height : loaded.grid.texels) {
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }

  std::string text = source.path + "\n";
  auto line = [&](std::string_view name, const std::string& value) {
    text += fmt::format("  {:<12}{}\n", name, value);
  };
  line("format", fmt::format("{}, {} bytes", found.format, std::filesystem::file_size(source.path)));
  line("size", fmt::format("{} x {} texels", found.width, found.height));
  line("channels", joined(channels));
  line("read", fmt::format("{} ({})", found.channel, found.channel_reason));
  line("numbers",
       fmt::format("{}, {} to {}", found.type, shortest_text(found.minimum), shortest_text(found.maximum)));
  line("becomes", fmt::format("{} bits: {}", loaded.grid.bits, found.normalisation));
  line("heights", fmt::format("{} to {} of {}, {} different", lowest, highest, pyramid.full_scale(),
                              found.distinct_levels));
  line("pyramid",
       fmt::format("{} levels, {} nodes of {} byte{}", pyramid.root_level() + 1, pyramid.node_count(),
                   pyramid.texel_bytes(), pyramid.texel_bytes() == 1 ? "" : "s"));
  for (const TexelLayoutEntry& layout : texel_layouts()) {
    line("", fmt::format("{:<10}{:>12} bytes", layout.name, TexelLayout(layout.kind, pyramid).size_bytes()));
  }
  for (const std::string& note : found.notes) line("note", note);
  if (highest < pyramid.full_scale()) {
    line("note", fmt::format("The map reaches z = {:.4f} of 1.",
                             static_cast<double>(highest) / pyramid.full_scale()));
  }
  return text;
}

std::unique_ptr<Command> make_heightmap_make_command() { return make_command<MakeCommand>(); }
std::unique_ptr<Command> make_heightmap_info_command() { return make_command<InfoCommand>(); }

}  // namespace cuesta
