#include "reports/image_write.h"

#include <OpenImageIO/imageio.h>

#include <string>
#include <vector>

#include "models/common/error.h"
#include "reports/result_json.h"

namespace cuesta {
namespace {

Error cannot_write(const std::filesystem::path& path, const std::string& why) {
  return {ExitCode::kResource, "Cannot write the planes to '" + path.string() + "': " + why + "."};
}

}  // namespace

void write_planes_exr(const std::filesystem::path& path, const Measurements& measurements) {
  const auto channels = static_cast<int>(measurements.planes.size());
  const auto pixels =
      static_cast<size_t>(measurements.plane_width) * static_cast<size_t>(measurements.plane_height);
  if (channels == 0 || pixels == 0) throw cannot_write(path, "there are none");
  OIIO::ImageSpec spec(measurements.plane_width, measurements.plane_height, channels, OIIO::TypeDesc::UINT32);
  spec.channelnames.clear();
  std::vector<uint32_t> interleaved(pixels * static_cast<size_t>(channels));
  for (size_t c = 0; c < measurements.planes.size(); ++c) {
    const Plane& plane = measurements.planes[c];
    if (plane.values.size() != pixels) throw cannot_write(path, "a plane has not one value per pixel");
    spec.channelnames.push_back(plane.name.substr(plane.name.find('.') + 1));
    for (size_t i = 0; i < pixels; ++i) interleaved[i * static_cast<size_t>(channels) + c] = plane.values[i];
  }
  spec.attribute("compression", "piz");
  try {
    auto output = OIIO::ImageOutput::create(path.string());
    if (!output) throw cannot_write(path, OIIO::geterror());
    const bool written = output->open(path.string(), spec) &&
                         output->write_image(OIIO::TypeDesc::UINT32, interleaved.data()) && output->close();
    if (!written) throw cannot_write(path, output->geterror());
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
