#include "traces/heightmaps/image_writer.h"

#include <unistd.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "models/common/error.h"
#include "models/files/image_codec.h"

namespace cuesta {
namespace {

std::string format_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".png") return "png";
  if (ending == ".tif" || ending == ".tiff") return "tiff";
  throw usage_error("Heights cannot be written to \"" + path +
                    "\"; a name that ends in .png, .tif or .tiff is accepted.");
}

/// Writes everything to `path`; empty, or what went wrong.
std::string write_rows(const std::string& path, const std::string& format, const HeightGrid& grid,
                       const Watch& watch) {
  bool small = grid.bits <= 8;
  uint32_t white = small ? 255 : 65535;
  const ImageLayout layout{
      grid.width, grid.height, {"Y"}, small ? SampleKind::kUint8 : SampleKind::kUint16, ""};
  std::string fault;
  auto output = image_codec().create(path, format, layout, fault);
  if (!output) return fault;
  std::vector<uint16_t> wide(static_cast<size_t>(grid.width));
  std::vector<uint8_t> narrow(static_cast<size_t>(grid.width));
  uint32_t full_scale = grid.full_scale();
  for (int j = 0; j < grid.height; ++j) {
    for (int i = 0; i < grid.width; ++i) {
      uint64_t value = (uint64_t{2} * white * grid.at(i, j) + full_scale) / (2 * full_scale);
      wide[i] = static_cast<uint16_t>(value);
      narrow[i] = static_cast<uint8_t>(value);
    }
    fault = output->write_row(j, small ? static_cast<void*>(narrow.data()) : wide.data());
    if (!fault.empty()) return fault;
    if (watch && !watch(static_cast<uint64_t>(j) + 1, static_cast<uint64_t>(grid.height))) {
      output->close();
      throw Error(ExitCode::kIncomplete,
                  "Writing the image was stopped before it was whole; nothing of it is kept.");
    }
  }
  return output->close();
}

}  // namespace

void check_height_image_name(const std::string& path) { format_of(path); }

void write_height_image(const std::string& path, const HeightGrid& grid, bool overwrite, const Watch& watch) {
  std::string format = format_of(path);
  std::error_code fault;
  if (!overwrite && std::filesystem::exists(path, fault)) {
    throw usage_error("There is a file \"" + path +
                      "\" already; another name, or leave to replace it, is needed.");
  }
  std::string partial = path + ".partial." + std::to_string(getpid());
  std::string reason;
  try {
    reason = write_rows(partial, format, grid, watch);
  } catch (const Error&) {
    std::filesystem::remove(partial, fault);
    throw;
  } catch (const std::exception& error) {
    reason = error.what();
    if (reason.empty()) reason = "no reason given";
  }
  if (reason.empty()) {
    std::filesystem::rename(partial, path, fault);
    if (fault) reason = fault.message();
  }
  if (!reason.empty()) {
    while (reason.size() > 1 && (reason.back() == ' ' || reason.back() == '.' || reason.back() == '\n')) {
      reason.pop_back();
    }
    std::filesystem::remove(partial, fault);
    throw Error(ExitCode::kResource, "The image \"" + path + "\" cannot be written: " + reason + ".");
  }
}

}  // namespace cuesta
