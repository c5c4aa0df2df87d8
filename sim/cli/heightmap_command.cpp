#include "sim/cli/heightmap_command.h"

#include <fmt/core.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "models/common/words.h"
#include "models/heightmap/generator.h"
#include "models/heightmap/pyramid.h"
#include "models/heightmap/texel_layout.h"
#include "sim/cli/options.h"
#include "sim/cli/output_file.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"
#include "traces/heightmaps/height_source_text.h"
#include "traces/heightmaps/image_writer.h"

namespace cuesta {
namespace {

template <typename Number>
bool parse_number(std::string_view text, Number& value) {
  auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size();
}

void check_bits(int bits) {
  if (bits < 1 || bits > 16)
    throw usage_error("--bits " + std::to_string(bits) + " is not accepted; 1 to 16 bits are.");
}

std::string kind_list() {
  std::string list = "Kind of map:";
  for (const MapKind& kind : map_kinds()) list += fmt::format("\n{}: {}", kind.name, kind.meaning);
  return list;
}

/// A bar over rows, from the first word of them to the watch's end.
Watch watch_of(const Session& session, const char* label) {
  auto bar = std::make_shared<std::optional<ProgressBar>>();
  return [&session, label, bar](uint64_t done, uint64_t all) {
    if (!*bar) bar->emplace(session, label, "rows", all);
    return (*bar)->update(done);
  };
}

class MakeCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("kind", options_.kind, kind_list()).required();
    options.add("-o,--output", options_.output, "File to write: .png, .tif or .tiff").required();
    options.add("--size", size_, "Texels: 256 or 640x480, 1 to 16384 on a side; default: the kind's own");
    options.add("--bits", options_.bits, "Bits of a height, 1 to 16; default: the kind's own");
    options.add("--seed", options_.seed, "Another seed, another map of the kind").with_default();
    options.add_flag("--force", options_.force, "Replace a file of that name");
  }
  ExitCode run(const Session& session) override {
    if (!size_.empty()) parse_map_size(size_, options_.width, options_.height);
    std::string line = heightmap_make(options_, watch_of(session, "making"), watch_of(session, "writing"));
    if (!session.quiet) std::fprintf(stderr, "%s\n", line.c_str());
    return ExitCode::kOk;
  }

 private:
  HeightmapMakeOptions options_;
  std::string size_;
};

class InfoCommand : public Command {
 public:
  void declare(Options& options) override {
    options
        .add("file", source_.path,
             "An image (PNG, TIFF, EXR, TGA, BMP, JPEG, DDS ...), an ESRI text grid (.asc, .grd), an SRTM "
             "tile "
             "(.hgt), or a file without a header (.raw, .r8, .r16, .r32, or any with --raw)")
        .required();
    options.add("--channel", source_.channel,
                "Name or index of the channel to read; default: the one that it can be");
    options.add("--values", values_, "What the file holds: height or depth").with_default();
    options.add("--bits", bits_, "Bits of a height, 1 to 16; default: 8 for 8-bit files, else 16");
    options.add("--normalise", normalise_, "auto, none or min_max").with_default();
    options.add("--range", range_, "LOW..HIGH: what becomes 0 and full scale, in the file's units");
    options.add(
        "--nodata", nodata_,
        "The number of cells without data, which become height 0: -9999, nan; default: as the file says");
    options.add("--raw", raw_,
                "A file without a header: WIDTHxHEIGHT, then :uint16 or such, then :little or :big");
  }
  ExitCode run(const Session&) override {
    source_.invert = parse_depth(values_, "--values");
    source_.normalisation = parse_normalisation(normalise_, "--normalise");
    if (bits_) check_bits(*bits_);
    source_.bits = bits_.value_or(0);
    if (!range_.empty()) {
      if (normalise_ != "auto") {
        throw usage_error("--range and --normalise " + normalise_ +
                          " contradict each other; accepted is one of them.");
      }
      source_.normalisation = Normalisation::kRange;
      parse_height_range(range_, "--range", source_.low, source_.high);
    }
    if (!nodata_.empty()) source_.nodata = parse_nodata(nodata_, "--nodata");
    if (!raw_.empty()) source_.raw = parse_raw_shape(raw_, "--raw");
    std::fputs(heightmap_info(source_).c_str(), stdout);
    return ExitCode::kOk;
  }

 private:
  HeightSource source_;
  std::optional<int> bits_;
  std::string values_ = "height", normalise_ = "auto", range_, nodata_, raw_;
};

}  // namespace

void parse_map_size(const std::string& text, int& width, int& height, int longest) {
  size_t cross = text.find('x');
  std::string_view first = std::string_view(text).substr(0, cross);
  std::string_view second = cross == std::string::npos ? first : std::string_view(text).substr(cross + 1);
  bool known = parse_number(first, width) && parse_number(second, height);
  if (!known || width < 1 || height < 1 || width > longest || height > longest) {
    throw usage_error(fmt::format(
        "--size {}: accepted is one number of texels or WIDTHxHEIGHT, each from 1 to {}, as in 16 or 24x16.",
        printable(text), longest));
  }
}

namespace {

/// Before a map's memory is taken: the system would end the program without a sentence.
void check_map_memory(int width, int height) {
  const uint64_t needed = sizeof(uint16_t) * pyramid_storage(width, height);
  const uint64_t there =
      static_cast<uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
  if (needed <= there) return;
  throw Error(ExitCode::kResource,
              fmt::format("A map of {} x {} texels and its pyramid take {} MiB of memory, and "
                          "this host has {}; a smaller map fits.",
                          width, height, needed >> 20, there >> 20));
}

}  // namespace

std::string heightmap_make(const HeightmapMakeOptions& options, const Watch& making, const Watch& writing) {
  refuse_existing(options.output, options.force);
  check_height_image_name(options.output);
  const std::filesystem::path folder = std::filesystem::path(options.output).parent_path();
  std::error_code ignored;
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
    throw usage_error("There is no folder " + printable(folder.string(), 200) +
                      " to write the map into; accepted: a name in a folder that is there.");
  }
  if (options.bits) check_bits(*options.bits);
  const MapKind* kind = find_map_kind(options.kind);
  if (kind != nullptr) {
    check_map_memory(options.width > 0 ? options.width : kind->width,
                     options.height > 0 ? options.height : kind->height);
  }
  HeightGrid grid =
      generate(options.kind, options.width, options.height, options.bits.value_or(0), options.seed, making);
  write_height_image(options.output, grid, options.force, writing);
  return fmt::format("{}: {}, {} x {} texels of {} bits, seed {}.", options.output, options.kind, grid.width,
                     grid.height, grid.bits, options.seed);
}

std::string heightmap_info(const HeightSource& source) {
  LoadedHeights loaded = load_heights(source, check_map_memory);
  const HeightStatement& found = loaded.statement;
  std::vector<std::string_view> channels(found.channels.begin(), found.channels.end());
  uint32_t lowest = loaded.grid.full_scale(), highest = 0;
  for (uint32_t height : loaded.grid.texels) {
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  const int bits = loaded.grid.bits;
  const Pyramid pyramid = build_max_pyramid(std::move(loaded.grid));

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
  line("becomes", fmt::format("{} bits: {}", bits, found.normalisation));
  line("heights", fmt::format("{} to {} of {}, {} different", lowest, highest, pyramid.full_scale(),
                              found.distinct_levels));
  if (!found.nodata.empty()) {
    line("no data",
         fmt::format("{} of {} cells, marked by {}", found.nodata_cells,
                     static_cast<uint64_t>(found.width) * static_cast<uint64_t>(found.height), found.nodata));
  }
  line("pyramid",
       fmt::format("{} levels, {} nodes of {} byte{}", pyramid.root_level() + 1, pyramid.node_count(),
                   pyramid.texel_bytes(), pyramid.texel_bytes() == 1 ? "" : "s"));
  for (const TexelLayoutEntry& layout : texel_layouts()) {
    line("", fmt::format("{:<14}{:>12} bytes", layout.name, TexelLayout(layout.kind, pyramid).size_bytes()));
  }
  for (const std::string& note : found.notes) line("note", note);
  const bool square_power = found.width == found.height && (found.width & (found.width - 1)) == 0;
  if (!square_power) {
    line("note",
         fmt::format("The map is no square power of two: it is walked as part of one of {0} x {0}, of which "
                     "nothing is stored or visited outside the map.",
                     1 << pyramid.root_level()));
  }
  if (highest < pyramid.full_scale()) {
    line("note", fmt::format("The map reaches z = {:.4f} of 1.",
                             static_cast<double>(highest) / pyramid.full_scale()));
  }
  return text;
}

std::unique_ptr<Command> make_heightmap_make_command() { return make_command<MakeCommand>(); }
std::unique_ptr<Command> make_heightmap_info_command() { return make_command<InfoCommand>(); }

}  // namespace cuesta
