#include "reports/image_write.h"

#include <string>
#include <vector>

#include "models/common/error.h"
#include "models/files/image_codec.h"
#include "reports/result_json.h"

namespace cuesta {
namespace {

Error cannot_write(const std::filesystem::path& path, const std::string& why) {
  return {ExitCode::kResource, "Cannot write the planes to '" + path.string() + "': " + why + "."};
}

/// Empty, or what went wrong.
std::string write_rows(const std::filesystem::path& path, const ImageLayout& layout,
                       const std::vector<uint32_t>& interleaved) {
  std::string fault;
  auto output = image_codec().create(path.string(), "openexr", layout, fault);
  if (!output) return fault;
  const size_t row = static_cast<size_t>(layout.width) * layout.channels.size();
  for (int j = 0; j < layout.height && fault.empty(); ++j) {
    fault = output->write_row(j, interleaved.data() + static_cast<size_t>(j) * row);
  }
  return fault.empty() ? output->close() : fault;
}

}  // namespace

void write_planes_exr(const std::filesystem::path& path, const Measurements& measurements) {
  const size_t channels = measurements.planes.size();
  const auto pixels =
      static_cast<size_t>(measurements.plane_width) * static_cast<size_t>(measurements.plane_height);
  if (channels == 0 || pixels == 0) throw cannot_write(path, "there are none");
  ImageLayout layout{measurements.plane_width, measurements.plane_height, {}, SampleKind::kUint32, "piz"};
  std::vector<uint32_t> interleaved(pixels * channels);
  for (size_t c = 0; c < channels; ++c) {
    const Plane& plane = measurements.planes[c];
    if (plane.values.size() != pixels) throw cannot_write(path, "a plane has not one value per pixel");
    layout.channels.push_back(plane.name.substr(plane.name.find('.') + 1));
    for (size_t i = 0; i < pixels; ++i) interleaved[i * channels + c] = plane.values[i];
  }
  try {
    const std::string fault = write_rows(path, layout, interleaved);
    if (!fault.empty()) throw cannot_write(path, fault);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& problem) {
    throw cannot_write(path, problem.what());
  }
}

void write_planes(const Result& result, ResultFolder& folder) {
  for (size_t i = 0; i < result.runs.size(); ++i) {
    const Measurements& measurements = result.runs[i].measurements;
    if (!measurements.planes.empty()) write_planes_exr(folder.file(planes_path(result, i)), measurements);
  }
}

}  // namespace cuesta
