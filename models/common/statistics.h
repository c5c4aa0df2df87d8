#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cuesta {

/// What a statistic means. Its name is the last part of a counter's path: `height_l1[0].misses` is defined by
/// `height_l1.misses`; the index of the pipeline is not part of the definition.
struct StatisticDefinition {
  std::string_view name;      ///< "unit.statistic"
  std::string_view unit;      ///< "cycles", "bytes", "rays", "lines" ...
  std::string_view sentence;  ///< what is counted, when, what is left out
};

/// 64-bit integer counters by path. Ratios are computed when read.
class Counters {
 public:
  void set(const std::string& path, int64_t value) { values_[path] = value; }
  void add(const std::string& path, int64_t value) { values_[path] += value; }
  /// 0 where nothing was counted.
  int64_t get(const std::string& path) const {
    auto found = values_.find(path);
    return found == values_.end() ? 0 : found->second;
  }
  /// Sum of `unit[*].statistic` over all instances of a unit.
  int64_t sum(std::string_view unit, std::string_view statistic) const;
  /// Sorted by path.
  const std::map<std::string, int64_t>& all() const { return values_; }

 private:
  std::map<std::string, int64_t> values_;
};

/// Bin k counts count[k] values, the smallest of them >= first[k]. Bins are single values below 4, then powers of
/// two in four: the bin of first = 2^m + q 2^(m-2) ends below first + 2^(m-2). Empty bins are left out.
struct Histogram {
  std::string name;  ///< defined like a counter
  std::vector<int64_t> first;
  std::vector<int64_t> count;
  int64_t median = 0, p99 = 0, max = 0;  ///< exact, over the values, not the bins
};

/// Values >= 0; exact median (lower), p99 and maximum.
Histogram make_histogram(std::string name, std::vector<int64_t> values);

/// One unsigned integer per pixel, row by row, `width * height` of them.
struct Plane {
  std::string name;  ///< defined like a counter: "plane.steps"
  std::vector<uint32_t> values;
  int64_t nobody = 0;   ///< what no pixel owns: plane + nobody = the total
  bool adds_up = true;  ///< false: a latency, of which no total is kept
};

/// What one run of one algorithm on one machine gives back, besides the hit records.
struct Measurements {
  Counters counters;
  std::vector<Histogram> histograms;
  int plane_width = 0;
  int plane_height = 0;
  std::vector<Plane> planes;
};

}  // namespace cuesta
