#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "models/common/words.h"
#include "models/heightmap/generator.h"
#include "sim/cli/map_size.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"
#include "sim/session/heightmap_files.h"
#include "traces/heightmaps/height_source_text.h"

namespace cuesta {
namespace {

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
    if (bits_) check_map_bits(*bits_);
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

std::unique_ptr<Command> make_heightmap_make_command() { return make_command<MakeCommand>(); }
std::unique_ptr<Command> make_heightmap_info_command() { return make_command<InfoCommand>(); }

}  // namespace cuesta
