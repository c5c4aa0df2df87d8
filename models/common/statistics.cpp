#include "models/common/statistics.h"

#include <algorithm>
#include <bit>

#include "models/common/error.h"

namespace cuesta {

int64_t Counters::sum(std::string_view unit, std::string_view statistic) const {
  int64_t total = 0;
  const std::string front = std::string(unit) + "[", back = "]." + std::string(statistic);
  for (const auto& [path, value] : values_) {
    if (path.starts_with(front) && path.ends_with(back)) total += value;
  }
  return total;
}

Histogram make_histogram(std::string name, std::vector<int64_t> values) {
  Histogram histogram;
  histogram.name = std::move(name);
  if (values.empty()) return histogram;
  // Distinct values and how many of each, in order; small values are counted, not sorted.
  std::vector<std::pair<int64_t, int64_t>> distinct;
  const int64_t largest = *std::max_element(values.begin(), values.end());
  if (largest < static_cast<int64_t>(16 * values.size() + 4096)) {
    std::vector<int64_t> counts(static_cast<size_t>(largest) + 1, 0);
    for (int64_t v : values) ++counts[static_cast<size_t>(v)];
    for (int64_t v = 0; v <= largest; ++v) {
      if (counts[static_cast<size_t>(v)] > 0) distinct.emplace_back(v, counts[static_cast<size_t>(v)]);
    }
  } else {
    std::sort(values.begin(), values.end());
    for (int64_t v : values) {
      if (distinct.empty() || distinct.back().first != v) distinct.emplace_back(v, 0);
      ++distinct.back().second;
    }
  }
  auto value_at = [&](int64_t rank) {
    for (const auto& [value, count] : distinct) {
      if (rank < count) return value;
      rank -= count;
    }
    return largest;
  };
  const auto n = static_cast<int64_t>(values.size());
  histogram.median = value_at((n - 1) / 2);
  histogram.p99 = value_at((n - 1) * 99 / 100);
  histogram.max = largest;
  // Bins 0, 1, 2, 3, then each power of two in four.
  auto bin_start = [](int64_t v) -> int64_t {
    if (v < 4) return v;
    const int shift = std::bit_width(static_cast<uint64_t>(v)) - 3;
    return v >> shift << shift;
  };
  for (const auto& [value, count] : distinct) {
    const int64_t start = bin_start(value);
    if (histogram.first.empty() || histogram.first.back() != start) {
      histogram.first.push_back(start);
      histogram.count.push_back(0);
    }
    histogram.count.back() += count;
  }
  return histogram;
}

}  // namespace cuesta
