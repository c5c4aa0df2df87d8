#include <algorithm>
#include <cmath>
#include <new>

#include "models/common/error.h"
#include "traces/rays_reader.h"

namespace cuesta {
namespace {

class Summing {
 public:
  Summing(int width, int height)
      : seen_(static_cast<size_t>(width) * static_cast<size_t>(height), false), width_(width) {
    summary_.width = width;
    summary_.height = height;
  }

  void add(const TracedRay& ray) {
    for (int axis = 0; axis < 3; ++axis) {
      const double value = ray.origin[axis];
      summary_.low[axis] = summary_.rays == 0 ? value : std::min(summary_.low[axis], value);
      summary_.high[axis] = summary_.rays == 0 ? value : std::max(summary_.high[axis], value);
    }
    ++summary_.rays;
    ++summary_.of_kind[static_cast<int>(ray.kind)];
    ++(ray.direction[2] < 0   ? summary_.descending
       : ray.direction[2] > 0 ? summary_.rising
                              : summary_.horizontal);
    ++summary_.of_slope[slope_class(ray)];
    auto seen = seen_[static_cast<size_t>(ray.pixel_y) * static_cast<size_t>(width_) + ray.pixel_x];
    if (!seen) ++summary_.pixels;
    seen = true;
    ids_.push_back(ray.id);
  }

  RaySummary result(const std::string& where) {
    require_distinct_ids(std::move(ids_), where);
    return summary_;
  }

 private:
  RaySummary summary_;
  std::vector<bool> seen_;
  std::vector<uint64_t> ids_;
  int width_;
};

}  // namespace

int slope_class(const TracedRay& ray) {
  const auto size = [&](int axis) { return std::abs(ray.direction[axis]); };
  const double across = std::max(size(0), size(1));
  if (across == 0) return 0;
  if (size(2) == 0) return kSlopeClasses - 1;
  double least = 10;  // of the class
  for (int k = 1; k < kSlopeClasses - 2; ++k, least /= 10) {
    if (size(2) >= least * across) return k;
  }
  return kSlopeClasses - 2;
}

std::string_view name_of_slope_class(int slope_class) {
  static constexpr std::string_view kNames[kSlopeClasses] = {
      "vertical",     "10 and more",  "1 to 10",      "0.1 to 1",   "0.01 to 0.1",
      "1e-3 to 0.01", "1e-4 to 1e-3", "1e-5 to 1e-4", "below 1e-5", "horizontal"};
  return kNames[slope_class];
}

RaySummary check_rays(const std::string& path) {
  try {
    RayReader reader(path);
    Summing summing(reader.width(), reader.height());
    std::vector<TracedRay> rays;
    while (reader.next_chunk(rays)) {
      for (const TracedRay& ray : rays) summing.add(ray);
      rays.clear();
    }
    RaySummary summary = summing.result("Cannot read the ray trace " + path);
    summary.chunks = reader.chunk_count();
    summary.file_bytes = reader.file_bytes();
    return summary;
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::kResource, "Cannot read the ray trace " + path + ": memory does not suffice.");
  }
}

RaySummary summarise(const RayTrace& trace) {
  Summing summing(trace.width, trace.height);
  for (const TracedRay& ray : trace.rays) summing.add(ray);
  return summing.result("The ray trace");
}

}  // namespace cuesta
