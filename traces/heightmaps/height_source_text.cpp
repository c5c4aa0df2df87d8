#include "traces/heightmaps/height_source_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>
#include <string_view>
#include <vector>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {
namespace {

constexpr std::string_view kKeys[] = {"values", "bits", "normalise", "range", "nodata", "raw"};

bool is_there(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

bool parse_real(std::string_view text, double& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size();
}

void apply(const std::string& key, const std::string& value, HeightSource& source) {
  const std::string origin = key + "=";
  if (key == "values") {
    source.invert = parse_depth(value, origin);
  } else if (key == "bits") {
    const auto [end, fault] = std::from_chars(value.data(), value.data() + value.size(), source.bits);
    if (fault != std::errc() || end != value.data() + value.size() || source.bits < 1 || source.bits > 16) {
      throw usage_error("bits=" + printable(value) + " is not accepted; 1 to 16 bits are.");
    }
  } else if (key == "normalise") {
    source.normalisation = parse_normalisation(value, origin);
  } else if (key == "range") {
    source.normalisation = Normalisation::kRange;
    parse_height_range(value, origin, source.low, source.high);
  } else if (key == "nodata") {
    source.nodata = parse_nodata(value, origin);
  } else {
    source.raw = parse_raw_shape(value, origin);
  }
}

}  // namespace

bool parse_depth(const std::string& text, const std::string& origin) {
  if (text == "height" || text == "depth") return text == "depth";
  throw usage_error(origin + " " + printable(text) + " is not known; accepted are height, depth.");
}

Normalisation parse_normalisation(const std::string& text, const std::string& origin) {
  if (text == "auto") return Normalisation::kAuto;
  if (text == "none") return Normalisation::kNone;
  if (text == "min_max") return Normalisation::kMinMax;
  throw usage_error(origin + " " + printable(text) + " is not known; accepted are auto, none, min_max.");
}

void parse_height_range(const std::string& text, const std::string& origin, double& low, double& high) {
  const std::string_view whole = text;
  size_t mark = whole.find(".."), length = 2;
  if (mark == std::string_view::npos) {
    mark = whole.find(',');
    length = 1;
  }
  const bool known = mark != std::string_view::npos && parse_real(whole.substr(0, mark), low) &&
                     parse_real(whole.substr(mark + length), high) && std::isfinite(low) &&
                     std::isfinite(high) && low < high;
  if (!known) {
    throw usage_error(origin + " " + printable(text) +
                      " is not a range; accepted are two numbers, the lower first, as -4.5..921.");
  }
}

double parse_nodata(const std::string& text, const std::string& origin) {
  double value = 0;
  if (parse_real(text, value)) return value;
  throw usage_error(origin + " " + printable(text) +
                    " is not a number; accepted are numbers, nan, inf and -inf.");
}

HeightSource parse_height_source(const std::string& text) {
  HeightSource source;
  source.path = text;
  if (is_there(text)) return source;
  std::vector<std::string> parts;
  for (size_t start = 0; start <= text.size();) {
    const size_t comma = std::min(text.find(',', start), text.size());
    parts.push_back(text.substr(start, comma - start));
    start = comma + 1;
  }
  // What follows the last part without `=` are keys; commas before belong to the file's name.
  size_t first_key = parts.size();
  while (first_key > 1 && parts[first_key - 1].find('=') != std::string::npos) --first_key;
  std::string file = parts[0];
  for (size_t k = 1; k < first_key; ++k) file += "," + parts[k];
  std::set<std::string> given;
  for (size_t k = first_key; k < parts.size(); ++k) {
    const size_t equals = parts[k].find('=');
    const std::string key = parts[k].substr(0, equals);
    if (std::find(std::begin(kKeys), std::end(kKeys), key) == std::end(kKeys)) {
      const std::string near = did_you_mean(key, kKeys);
      throw usage_error("--heightmap " + printable(text, 200) + " gives `" + printable(key) +
                        "`; accepted behind the file are " + joined(kKeys) + (near.empty() ? "." : near));
    }
    if (!given.insert(key).second) {
      throw usage_error("--heightmap " + printable(text, 200) + " gives " + key +
                        " twice; accepted is once.");
    }
    apply(key, parts[k].substr(equals + 1), source);
  }
  if (given.count("range") != 0 && given.count("normalise") != 0) {
    throw usage_error("--heightmap gives both range and normalise; accepted is one of them.");
  }
  source.path = file;
  const size_t colon = file.rfind(':');
  if (colon != std::string::npos && !is_there(file)) {
    source.path = file.substr(0, colon);
    source.channel = file.substr(colon + 1);
  }
  return source;
}

}  // namespace cuesta
