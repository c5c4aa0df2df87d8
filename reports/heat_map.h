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
  std::vector<int64_t> first;     ///< first[0] = 0, rising
  std::vector<double> position;   ///< 0 to 1, of the bin's colour
  int64_t maximum = 0;            ///< the largest count of all runs
  bool logarithmic = false;
  std::string unit;

  size_t bin_of(int64_t value) const;
  /// Round numbers within the scale, for labels.
  std::vector<int64_t> ticks() const;
  /// 0 to 1: where a value stands on the colour bar.
  double place_of(int64_t value) const;
};

/// Linear, exact where the maximum is below 254; logarithmic where one run's counts would leave another's no
/// more than a tenth of the scale.
HeatScale make_heat_scale(const Result& result, std::string_view plane_name);

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
