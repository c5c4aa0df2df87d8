#include "traces/heightmaps/image_reader.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <new>

#include "models/common/error.h"
#include "models/common/words.h"
#include "models/heightmap/pyramid.h"
#include "traces/heightmaps/height_survey.h"
#include "traces/heightmaps/image_samples.h"

namespace cuesta {
namespace {

/// Heights of the range as integers of 0 to full scale, halves up; cells without data as 0.
class Quantiser {
 public:
  Quantiser(HeightRange range, uint32_t full_scale, bool invert, const Nodata& nodata)
      : range_(range), full_scale_(full_scale), invert_(invert), nodata_(nodata) {}

  uint16_t operator()(double value, uint64_t count = 1) {
    if (nodata_.is(value)) return 0;
    uint32_t height = 0;
    if (value < range_.low || value > range_.high) clamped_ += count;
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
  HeightRange range_;
  uint32_t full_scale_;
  bool invert_;
  const Nodata& nodata_;
  uint64_t clamped_ = 0;
};

/// Calls take(first texel's index, values, count) strip by strip.
template <typename T, typename Take>
void each_strip(SampleSource& samples, Take take) {
  const auto width = static_cast<size_t>(samples.width());
  const int rows = std::min(samples.strip_rows(), samples.height());
  std::vector<T> strip(static_cast<size_t>(rows) * width);
  for (int first = 0; first < samples.height(); first += rows) {
    const int last = std::min(first + rows, samples.height());
    samples.read_rows(first, last, strip.data());
    take(static_cast<size_t>(first) * width, strip.data(), static_cast<size_t>(last - first) * width);
  }
}

/// Everything that `load` knows of a channel before it is quantised, and after.
struct Reading {
  const HeightSource& source;
  const OpenedHeights& opened;
  const SampleType& type;
  Nodata nodata;
  Survey survey;
  HeightRange range{0, 1};
  uint64_t clamped = 0;
  HeightGrid grid;

  void decide_range() { range = choose_range(source, opened.channel, type, survey, grid.width); }
  Quantiser quantiser() const { return {range, grid.full_scale(), source.invert, nodata}; }
};

/// Unsigned integers of 8 and 16 bits go straight into the grid; what becomes of each of the at most 65536 different
/// numbers is then computed once.
template <typename T>
void read_small(SampleSource& samples, Reading& reading) {
  std::vector<uint64_t> counts(65536);
  std::vector<uint16_t>& texels = reading.grid.texels;
  each_strip<T>(samples, [&](size_t, const T* values, size_t count) {
    for (size_t k = 0; k < count; ++k) ++counts[values[k]];
    texels.insert(texels.end(), values, values + count);
  });
  for (size_t value = 0; value < counts.size(); ++value) {
    if (counts[value] != 0) reading.survey.take(static_cast<double>(value), 0, counts[value], reading.nodata);
  }
  reading.decide_range();
  Quantiser quantise = reading.quantiser();
  std::vector<uint16_t> becomes(65536);
  bool same = true;
  for (size_t value = 0; value < counts.size(); ++value) {
    if (counts[value] == 0) continue;
    becomes[value] = quantise(static_cast<double>(value), counts[value]);
    same = same && becomes[value] == value;
  }
  reading.clamped = quantise.clamped();
  if (same) return;
  for (uint16_t& texel : texels) texel = becomes[texel];
}

/// All other numbers are read twice, first for what there is: a copy of them would be larger than the map.
template <typename T>
void read_wide(SampleSource& samples, Reading& reading) {
  each_strip<T>(samples, [&](size_t first, const T* values, size_t count) {
    for (size_t k = 0; k < count; ++k) {
      reading.survey.take(static_cast<double>(values[k]), first + k, 1, reading.nodata);
    }
  });
  reading.decide_range();
  Quantiser quantise = reading.quantiser();
  std::vector<uint16_t>& texels = reading.grid.texels;
  each_strip<T>(samples, [&](size_t, const T* values, size_t count) {
    for (size_t k = 0; k < count; ++k) texels.push_back(quantise(static_cast<double>(values[k])));
  });
  reading.clamped = quantise.clamped();
}

void read_all(SampleSource& samples, Reading& reading) {
  switch (samples.kind()) {
    case SampleKind::kUint8:
      return read_small<uint8_t>(samples, reading);
    case SampleKind::kUint16:
      return read_small<uint16_t>(samples, reading);
    case SampleKind::kUint32:
      return read_wide<uint32_t>(samples, reading);
    case SampleKind::kInt8:
      return read_wide<int8_t>(samples, reading);
    case SampleKind::kInt16:
      return read_wide<int16_t>(samples, reading);
    case SampleKind::kInt32:
      return read_wide<int32_t>(samples, reading);
    case SampleKind::kHalf:
    case SampleKind::kFloat:
      return read_wide<float>(samples, reading);
    case SampleKind::kDouble:
      return read_wide<double>(samples, reading);
  }
}

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

/// "depth" or "Z" as the last part of a channel's name.
bool called_depth(const std::string& channel) {
  std::string name = channel.substr(channel.rfind('.') + 1);
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name == "depth" || name == "z";
}

void add_notes(const Reading& reading, HeightStatement& statement) {
  std::vector<std::string>& notes = statement.notes;
  const bool flat = reading.range.low == reading.range.high;
  if (flat) notes.push_back("The channel is flat; every height becomes 0.");
  if (!flat && statement.distinct_levels > 1 && statement.distinct_levels <= 256 && reading.grid.bits > 8 &&
      reading.grid.texels.size() >= 4096) {
    notes.push_back("The " + std::to_string(reading.grid.bits) + "-bit heights take only " +
                    std::to_string(statement.distinct_levels) + " different values: 8 bits would hold them.");
  }
  if (reading.clamped > 0) {
    notes.push_back(std::to_string(reading.clamped) + " texels lie outside the range and are clamped.");
  }
  if (statement.nodata_cells > 0) {
    notes.push_back(std::to_string(statement.nodata_cells) + " cells hold no data and become height 0.");
  } else if (reading.source.nodata) {
    notes.push_back("No cell holds " + shortest_text(*reading.source.nodata) +
                    ", which is said to mark cells without data.");
  }
  if (reading.source.invert) {
    notes.push_back("The file holds depth: a height is full scale minus the value.");
  } else if (called_depth(statement.channel)) {
    notes.push_back("The channel is called " + printable(statement.channel) +
                    " and is read as heights; values = \"depth\" turns it over.");
  }
}

LoadedHeights load(const HeightSource& source, const SizeCheck& before) {
  check_source(source);
  OpenedHeights opened = open_heights(source);
  SampleSource& samples = *opened.samples;
  const SampleType& type = sample_type(samples.kind());
  if (before) before(samples.width(), samples.height());
  Reading reading{source, opened, type, {}, {}, {0, 1}, 0, {}};
  if (source.nodata) {
    reading.nodata = Nodata(*source.nodata, type.kind, "asked for");
  } else if (opened.facts.has_nodata) {
    reading.nodata = Nodata(opened.facts.nodata, type.kind, opened.facts.nodata_reason);
  }
  HeightGrid& grid = reading.grid;
  grid.width = samples.width();
  grid.height = samples.height();
  grid.bits = source.bits != 0 ? source.bits : type.bits;
  grid.texels.reserve(pyramid_storage(grid.width, grid.height));
  read_all(samples, reading);

  LoadedHeights loaded;
  HeightStatement& statement = loaded.statement;
  statement.format = opened.facts.format;
  statement.width = grid.width;
  statement.height = grid.height;
  statement.channels = opened.channels;
  statement.channel = opened.channel;
  statement.channel_reason = opened.channel_reason;
  statement.type = type.name;
  statement.minimum = reading.survey.minimum;
  statement.maximum = reading.survey.maximum;
  statement.distinct_levels = count_levels(grid.texels);
  statement.nodata_cells = reading.survey.nodata_cells;
  if (reading.nodata.given()) {
    statement.nodata = shortest_text(reading.nodata.marker()) + " (" + reading.nodata.reason() + ")";
  }
  statement.normalisation = shortest_text(reading.range.low) + " .. " + shortest_text(reading.range.high) +
                            " becomes 0 .. " + std::to_string(grid.full_scale());
  statement.notes = opened.facts.notes;
  add_notes(reading, statement);
  loaded.grid = std::move(grid);
  return loaded;
}

}  // namespace

LoadedHeights load_heights(const HeightSource& source, const SizeCheck& before) {
  try {
    return load(source, before);
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::kResource,
                "The heights of the image \"" + source.path + "\" do not fit into memory.");
  }
}

}  // namespace cuesta
