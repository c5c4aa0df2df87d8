#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reports/picture.h"
#include "reports/result.h"

namespace cuesta {

/// From counts to colours, one for a plane's name over all runs of a result, so that pictures are comparable.
/// Bin k holds first[k] to first[k + 1] - 1, the last one what is above; at most 254 bins (two palette entries
/// are left for text and paper).
struct HeatScale {
  std::vector<int64_t> first;    ///< first[0] = 0, rising
  std::vector<double> position;  ///< 0 to 1, of the bin's colour
  int64_t maximum = 0;           ///< the largest count of all runs
  bool logarithmic = false;
  std::string unit;

  size_t bin_of(int64_t value) const;
  /// Round numbers within the scale, for labels.
  std::vector<int64_t> ticks() const;
  /// 0 to 1: where a value stands on the colour bar.
  double place_of(int64_t value) const;
};

/// Bins are single counts where the maximum is below 254. Colours are linear, or logarithmic where some run's
/// 99th percentile would lie in the lowest third of the scale.
HeatScale make_heat_scale(const Result& result, std::string_view plane_name);

/// A colour per bin, no two alike, so that a count can be read back from a picture.
std::vector<Colour> palette_of(const HeatScale& scale);

/// The plane alone, one pixel each; planes wider or higher than `limit` are reduced by a whole factor (mean).
struct PlanePicture {
  Picture picture;
  int reduction = 1;
};
PlanePicture plane_picture(const Plane& plane, int width, int height, const HeatScale& scale, int limit);

/// With title and colour bar: a picture that stands alone.
Picture heat_map(const Plane& plane, int width, int height, const HeatScale& scale, const std::string& title,
                 const std::string& subtitle);

}  // namespace cuesta
