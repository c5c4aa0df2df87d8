#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "traces/heightmaps/image_reader.h"
#include "traces/heightmaps/sample_source.h"

namespace cuesta {

/// The number that stands for a cell without data, if any.
class Nodata {
 public:
  Nodata() = default;
  /// As stored in a channel of `kind`: half and float channels hold the marker rounded to float.
  Nodata(double marker, SampleKind kind, std::string reason);

  bool given() const { return given_; }
  bool is(double value) const { return given_ && (value == marker_ || (nan_ && value != value)); }
  double marker() const { return marker_; }
  const std::string& reason() const { return reason_; }

 private:
  bool given_ = false;
  bool nan_ = false;
  double marker_ = 0;
  std::string reason_;
};

/// What a look at every number of a channel found; cells without data are counted and otherwise left out.
struct Survey {
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();
  uint64_t nodata_cells = 0;
  uint64_t not_finite = 0;        ///< NaN and infinities
  uint64_t first_not_finite = 0;  ///< texel index
  bool first_is_nan = false;

  void take(double value, uint64_t texel, uint64_t count, const Nodata& nodata);
};

struct HeightRange {
  double low;
  double high;
};

/// The range that becomes 0 to full scale. Throws input_error for numbers that are not finite, a channel without a
/// single height, heights outside what Normalisation::kNone accepts, and a lowest or highest number that is a common
/// marker of missing data, each with what to give instead.
HeightRange choose_range(const HeightSource& source, const std::string& channel, const SampleType& type,
                         const Survey& survey, int width);

}  // namespace cuesta
