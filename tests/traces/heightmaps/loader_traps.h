#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "tests/traces/heightmaps/image_test.h"
#include "traces/heightmaps/image_file.h"

namespace cuesta::test {

using OIIO::TypeDesc;

class LoaderTraps : public ImageTest {
 protected:
  static bool noted(const LoadedHeights& loaded, const std::string& words) {
    for (const std::string& note : loaded.statement.notes) {
      if (note.find(words) != std::string::npos) return true;
    }
    return false;
  }
};

template <typename T>
Bytes little_endian(const std::vector<T>& numbers, bool big = false) {
  Bytes bytes;
  for (T number : numbers) {
    Bytes one(sizeof number);
    std::memcpy(one.data(), &number, sizeof number);
    if (big) std::reverse(one.begin(), one.end());
    append(bytes, one);
  }
  return bytes;
}

inline HeightSource with_nodata(const std::string& path, double marker) {
  HeightSource from = source(path);
  from.nodata = marker;
  return from;
}

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace cuesta::test
