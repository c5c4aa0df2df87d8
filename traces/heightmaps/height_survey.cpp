#include "traces/heightmaps/height_survey.h"

#include <algorithm>
#include <cmath>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {

Nodata::Nodata(double marker, SampleKind kind, std::string reason)
    : given_(true), nan_(std::isnan(marker)), marker_(marker), reason_(std::move(reason)) {
  const bool narrow = kind == SampleKind::kHalf || kind == SampleKind::kFloat;
  const double limit = std::numeric_limits<float>::max();
  if (narrow && std::isfinite(marker)) marker_ = static_cast<float>(std::clamp(marker, -limit, limit));
}

void Survey::take(double value, uint64_t texel, uint64_t count, const Nodata& nodata) {
  if (nodata.is(value)) {
    nodata_cells += count;
  } else if (!std::isfinite(value)) {
    if (not_finite == 0) {
      first_not_finite = texel;
      first_is_nan = std::isnan(value);
    }
    not_finite += count;
  } else {
    minimum = std::min(minimum, value);
    maximum = std::max(maximum, value);
  }
}

HeightRange choose_range(const HeightSource& source, const std::string& channel, const SampleType& type,
                         const Survey& survey, int width) {
  const std::string image = "The image \"" + source.path + "\" holds ";
  if (survey.not_finite > 0) {
    const auto across = static_cast<uint64_t>(width);
    const std::string more =
        survey.not_finite > 1 ? " and " + std::to_string(survey.not_finite - 1) + " more such numbers" : "";
    throw input_error(image + (survey.first_is_nan ? "NaN" : "infinity") + " in channel " + channel +
                      " at pixel (" + std::to_string(survey.first_not_finite % across) + ", " +
                      std::to_string(survey.first_not_finite / across) + ")" + more +
                      "; heights must be finite, or be named as cells without data (nodata = nan, or inf).");
  }
  if (!(survey.minimum <= survey.maximum)) {
    throw input_error(image + "no data in any of its " + std::to_string(survey.nodata_cells) +
                      " cells; at least one height is needed.");
  }
  const bool inside_unit = survey.minimum >= 0 && survey.maximum <= 1;
  Normalisation rule = source.normalisation;
  if (rule == Normalisation::kAuto) {
    const bool keep = type.integer ? !type.is_signed : inside_unit;
    rule = keep ? Normalisation::kNone : Normalisation::kMinMax;
  }
  if (rule == Normalisation::kRange) return {source.low, source.high};
  const std::string found =
      image + "heights of " + shortest_text(survey.minimum) + " to " + shortest_text(survey.maximum);
  if (rule == Normalisation::kNone) {
    if (survey.minimum < 0 || survey.maximum > type.largest) {
      throw input_error(found + "; without normalisation 0 to " + shortest_text(type.largest) +
                        " is accepted.");
    }
    return {0, type.largest};
  }
  // A terrain of metres has no such heights; stretching it to them would leave the rest on a few levels.
  for (double marker : {-9999.0, -99999.0, -32767.0, -32768.0}) {
    if (survey.minimum == marker && type.kind != SampleKind::kInt8) {
      throw input_error(found + ", and " + shortest_text(marker) +
                        " commonly marks cells without data; give nodata = " + shortest_text(marker) +
                        ", or the range of true heights as normalisation.");
    }
  }
  for (double extreme : {survey.minimum, survey.maximum}) {
    if (std::fabs(extreme) <= 1e30) continue;
    throw input_error(found + ", of which the extreme marks cells without data; give nodata = " +
                      shortest_text(extreme) + ", or the range of true heights as normalisation.");
  }
  return {survey.minimum, survey.maximum};
}

}  // namespace cuesta
