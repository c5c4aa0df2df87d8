#include "traces/heightmaps/image_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "models/common/error.h"
#include "models/common/words.h"
#include "traces/heightmaps/channel_choice.h"
#include "traces/heightmaps/image_file.h"

namespace cuesta {
namespace {

using Base = OIIO::TypeDesc::BASETYPE;

/// What the reader needs to know of a number type.
struct SampleType {
  Base base;
  const char* name;
  bool integer;
  bool is_signed;
  double largest;  ///< of an integer type
  int bits;        ///< of a height, unless the user asks for others
};

constexpr SampleType kSampleTypes[] = {
    {OIIO::TypeDesc::UINT8, "uint8", true, false, 255.0, 8},
    {OIIO::TypeDesc::UINT16, "uint16", true, false, 65535.0, 16},
    {OIIO::TypeDesc::UINT32, "uint32", true, false, 4294967295.0, 16},
    {OIIO::TypeDesc::INT8, "int8", true, true, 127.0, 8},
    {OIIO::TypeDesc::INT16, "int16", true, true, 32767.0, 16},
    {OIIO::TypeDesc::INT32, "int32", true, true, 2147483647.0, 16},
    {OIIO::TypeDesc::HALF, "half", false, true, 1.0, 16},
    {OIIO::TypeDesc::FLOAT, "float", false, true, 1.0, 16},
    {OIIO::TypeDesc::DOUBLE, "double", false, true, 1.0, 16},
};

const SampleType& sample_type(const ImageFile& file, int channel) {
  for (const SampleType& type : kSampleTypes) {
    if (type.base == file.type(channel)) return type;
  }
  throw input_error(
      "Channel " + file.channels()[channel] + " of the image \"" + file.path() +
      "\" has numbers of an unknown type; integers of 8 to 32 bits, half, float and double are accepted.");
}

/// One channel as float64, strip by strip: `take(first texel's index, values)`.
template <typename T, typename Take>
void each_strip(ImageFile& file, int channel, Base base, Take take) {
  std::vector<T> strip(static_cast<size_t>(file.strip_rows()) * file.width());
  for (int first = 0; first < file.height(); first += file.strip_rows()) {
    int last = std::min(first + file.strip_rows(), file.height());
    file.read_rows(first, last, channel, 1, base, strip.data());
    size_t count = static_cast<size_t>(last - first) * file.width();
    take(static_cast<size_t>(first) * file.width(), strip.data(), count);
  }
}

/// The numbers of a channel. Those of 8 and 16 unsigned bits stay exact in `small`; all others become
/// float32.
struct Numbers {
  std::vector<uint16_t> small;
  std::vector<float> wide;
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();
};

template <typename T>
void read_as(ImageFile& file, int channel, Base base, bool small, Numbers& numbers) {
  size_t count = static_cast<size_t>(file.width()) * file.height();
  if (small) numbers.small.resize(count);
  if (!small) numbers.wide.resize(count);
  each_strip<T>(file, channel, base, [&](size_t first, const T* values, size_t strip_count) {
    for (size_t k = 0; k < strip_count; ++k) {
      double value = static_cast<double>(values[k]);
      if (!small) {
        float rounded = static_cast<float>(value);
        if (!std::isfinite(rounded)) {
          size_t texel = first + k;
          throw input_error("The image \"" + file.path() + "\" holds " +
                            (std::isnan(rounded) ? "NaN" : "infinity") + " in channel " +
                            file.channels()[channel] + " at pixel (" + std::to_string(texel % file.width()) +
                            ", " + std::to_string(texel / file.width()) + "); heights must be finite.");
        }
        value = rounded;
        numbers.wide[first + k] = rounded;
      } else {
        numbers.small[first + k] = static_cast<uint16_t>(values[k]);
      }
      numbers.minimum = std::min(numbers.minimum, value);
      numbers.maximum = std::max(numbers.maximum, value);
    }
  });
}

Numbers read_numbers(ImageFile& file, int channel, const SampleType& type) {
  Numbers numbers;
  switch (type.base) {
    case OIIO::TypeDesc::UINT8:
      read_as<uint8_t>(file, channel, type.base, true, numbers);
      break;
    case OIIO::TypeDesc::UINT16:
      read_as<uint16_t>(file, channel, type.base, true, numbers);
      break;
    case OIIO::TypeDesc::UINT32:
      read_as<uint32_t>(file, channel, type.base, false, numbers);
      break;
    case OIIO::TypeDesc::INT8:
      read_as<int8_t>(file, channel, type.base, false, numbers);
      break;
    case OIIO::TypeDesc::INT16:
      read_as<int16_t>(file, channel, type.base, false, numbers);
      break;
    case OIIO::TypeDesc::INT32:
      read_as<int32_t>(file, channel, type.base, false, numbers);
      break;
    case OIIO::TypeDesc::DOUBLE:
      read_as<double>(file, channel, type.base, false, numbers);
      break;
    default:
      read_as<float>(file, channel, OIIO::TypeDesc::FLOAT, false, numbers);
      break;  // half is exact in float
  }
  return numbers;
}

struct Range {
  double low;
  double high;
};

Range choose_range(const HeightSource& source, const SampleType& type, const Numbers& numbers) {
  bool inside_unit = numbers.minimum >= 0 && numbers.maximum <= 1;
  Normalisation rule = source.normalisation;
  if (rule == Normalisation::kAuto) {
    bool keep = type.integer ? !type.is_signed : inside_unit;
    rule = keep ? Normalisation::kNone : Normalisation::kMinMax;
  }
  if (rule == Normalisation::kRange) return {source.low, source.high};
  std::string found = "The image \"" + source.path + "\" holds heights of " + shortest_text(numbers.minimum) +
                      " to " + shortest_text(numbers.maximum);
  if (rule == Normalisation::kNone) {
    if (numbers.minimum < 0 || numbers.maximum > type.largest) {
      throw input_error(found + "; without normalisation 0 to " + shortest_text(type.largest) +
                        " is accepted.");
    }
    return {0, type.largest};
  }
  // A terrain of metres has no such heights; stretching it to them would leave the rest on a few levels.
  for (double marker : {-9999.0, -99999.0, -32767.0, -32768.0}) {
    if (numbers.minimum == marker && type.largest != 127.0) {
      throw input_error(found + ", and " + shortest_text(marker) +
                        " marks texels without data; give the range of true heights as normalisation.");
    }
  }
  if (numbers.minimum < -1e30 || numbers.maximum > 1e30) {
    throw input_error(found +
                      ", of which the extreme marks texels without data; give the range of true heights as "
                      "normalisation.");
  }
  return {numbers.minimum, numbers.maximum};
}

/// Heights of the range as integers of 0 to full scale, halves up.
class Quantiser {
 public:
  Quantiser(Range range, uint32_t full_scale, bool invert)
      : range_(range), full_scale_(full_scale), invert_(invert) {}

  uint16_t operator()(double value) {
    uint32_t height = 0;
    if (value < range_.low || value > range_.high) ++clamped_;
    if (value >= range_.high && range_.high > range_.low) {
      height = full_scale_;
    } else if (value > range_.low) {
      double share = (value - range_.low) / (range_.high - range_.low);
      height = static_cast<uint32_t>(2 * share * full_scale_ + 1) / 2;  // halves up
    }
    return static_cast<uint16_t>(invert_ ? full_scale_ - height : height);
  }
  uint64_t clamped() const { return clamped_; }

 private:
  Range range_;
  uint32_t full_scale_;
  bool invert_;
  uint64_t clamped_ = 0;
};

int count_levels(const std::vector<uint16_t>& texels) {
  std::vector<bool> seen(65536);
  for (uint16_t texel : texels) seen[texel] = true;
  return static_cast<int>(std::count(seen.begin(), seen.end(), true));
}

void check_source(const HeightSource& source) {
  if (source.bits < 0 || source.bits > 16) {
    throw usage_error("Heights of " + std::to_string(source.bits) +
                      " bits were asked for; 1 to 16, or 0 for as many as the file has, are accepted.");
  }
  bool finite = std::isfinite(source.low) && std::isfinite(source.high);
  if (source.normalisation == Normalisation::kRange && !(finite && source.low < source.high)) {
    throw usage_error("The normalisation range " + shortest_text(source.low) + " to " +
                      shortest_text(source.high) +
                      " is not accepted; two finite numbers, the lower first, are.");
  }
}

LoadedHeights load(const HeightSource& source) {
  check_source(source);
  ImageFile file(source.path);
  ChannelChoice choice = choose_channel(file, source.channel);
  const SampleType& type = sample_type(file, choice.index);
  Numbers numbers = read_numbers(file, choice.index, type);
  Range range = choose_range(source, type, numbers);

  LoadedHeights loaded;
  HeightGrid& grid = loaded.grid;
  grid.width = file.width();
  grid.height = file.height();
  grid.bits = source.bits != 0 ? source.bits : type.bits;
  Quantiser quantise(range, grid.full_scale(), source.invert);
  if (!numbers.small.empty()) {
    grid.texels = std::move(numbers.small);
    for (uint16_t& texel : grid.texels) texel = quantise(texel);
  } else {
    grid.texels.reserve(numbers.wide.size());
    for (float value : numbers.wide) grid.texels.push_back(quantise(value));
  }

  HeightStatement& statement = loaded.statement;
  statement.format = file.format();
  statement.width = grid.width;
  statement.height = grid.height;
  statement.channels = file.channels();
  statement.channel = file.channels()[choice.index];
  statement.channel_reason = choice.reason;
  statement.type = type.name;
  statement.minimum = numbers.minimum;
  statement.maximum = numbers.maximum;
  statement.distinct_levels = count_levels(grid.texels);
  statement.normalisation = shortest_text(range.low) + " .. " + shortest_text(range.high) + " becomes 0 .. " +
                            std::to_string(grid.full_scale());
  statement.notes = file.notes();
  if (range.low == range.high) statement.notes.push_back("The channel is flat; every height becomes 0.");
  if (quantise.clamped() > 0) {
    statement.notes.push_back(std::to_string(quantise.clamped()) +
                              " texels lie outside the range and are clamped.");
  }
  if (source.invert)
    statement.notes.push_back("The file holds depth: a height is full scale minus the value.");
  return loaded;
}

}  // namespace

LoadedHeights load_heights(const HeightSource& source) {
  try {
    return load(source);
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::kResource,
                "The heights of the image \"" + source.path + "\" do not fit into memory.");
  }
}

}  // namespace cuesta
