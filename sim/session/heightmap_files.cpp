#include "sim/session/heightmap_files.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "models/common/error.h"
#include "models/common/words.h"
#include "models/heightmap/pyramid.h"
#include "models/heightmap/texel_layout.h"
#include "sim/session/output_file.h"
#include "traces/heightmaps/image_writer.h"

namespace cuesta {
namespace {

/// Refuses a map before its memory is taken: the system would end the program without a sentence.
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

void check_map_bits(int bits) {
  if (bits < 1 || bits > 16)
    throw usage_error("--bits " + std::to_string(bits) + " is not accepted; 1 to 16 bits are.");
}

std::string heightmap_make(const HeightmapMakeOptions& options, const Watch& making, const Watch& writing) {
  refuse_existing(options.output, options.force);
  check_height_image_name(options.output);
  const std::filesystem::path folder = std::filesystem::path(options.output).parent_path();
  std::error_code ignored;
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) {
    throw usage_error("There is no folder " + printable(folder.string(), 200) +
                      " to write the map into; accepted: a name in a folder that is there.");
  }
  if (options.bits) check_map_bits(*options.bits);
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

}  // namespace cuesta
