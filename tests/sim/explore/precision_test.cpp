#include "sim/explore/precision/precision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "models/common/random.h"
#include "models/heightmap/generator.h"
#include "models/heightmap/pyramid.h"
#include "reports/study/study_data.h"
#include "sim/explore/precision/exact_skipping_walk.h"
#include "sim/explore/precision/half_precision.h"
#include "sim/explore/study/study_runner.h"

namespace cuesta {
namespace {

TEST(ExactSkippingWalk, FindsWhatTheLeafWalkFinds) {
  for (const char* kind : {"fractal", "spikes", "noise", "steps"}) {
    const Pyramid pyramid = build_max_pyramid(generate(kind, 32, 32, 8, 3));
    const MapShape shape{32, 32, pyramid.root_level(), 8, AddressMode::kWrap};
    std::vector<OracleMap> levels;
    for (int level = 0; level <= pyramid.root_level(); ++level) {
      levels.push_back(
          oracle_map(pyramid.level(level), pyramid.width(level), pyramid.height(level), level, shape));
      levels.back().highest = pyramid.highest();
    }
    Random random(8);
    int hits = 0;
    for (int k = 0; k < 150; ++k) {
      TracedRay ray;
      for (int a = 0; a < 2; ++a) {
        ray.origin[a] = k % 5 == 0 ? static_cast<double>(random.below(33)) / 32 : random.unit();
        ray.direction[a] = k % 7 == 0 ? 0 : 2 * random.unit() - 1;
      }
      ray.origin[2] = 1;
      ray.direction[2] = -random.unit() * (k % 2 == 0 ? 2 : 0.2);
      const auto exact = exact_traced_ray(ray, shape, {8, 32, 12, 4}, false);
      ASSERT_TRUE(exact);
      const auto leaves = oracle_leaf_walk(*exact, levels[0]), skipping = exact_skipping_walk(*exact, levels);
      ASSERT_EQ(leaves.hit, skipping.hit) << kind << " " << k;
      if (!leaves.hit) continue;
      ++hits;
      ASSERT_EQ(leaves.i, skipping.i) << kind << " " << k;
      ASSERT_EQ(leaves.j, skipping.j) << kind << " " << k;
      ASSERT_EQ(leaves.face, skipping.face) << kind << " " << k;
      ASSERT_TRUE(leaves.t == skipping.t) << kind << " " << k;
    }
    EXPECT_GT(hits, 100) << kind;
  }
}

TEST(PrecisionPage, OfASingleSizeComparesItWithNoOtherAndHasNoEmptySection) {
  const auto data_of = [](bool quick, size_t most_sizes) {
    const Study study = precision_study();
    StudyData data = study.plan(quick);
    data.axes[0].values.resize(std::min(most_sizes, data.axes[0].values.size()));
    for (const StudyPlace& place : planned_places(study, data))
      data.cases.push_back({place, std::vector<int64_t>(data.counters.size(), 6554 * (1 + place[0]))});
    data.planned = data.cases.size();
    return data;
  };
  const auto times_in = [](const std::string& text, const std::string& part) {
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
  };
  for (const bool quick : {true, false}) {
    const StudyData data = data_of(quick, 1);
    const std::string headline = precision_headline(data), page = precision_page(data);
    EXPECT_EQ(times_in(headline, "256"), 1u) << headline;
    EXPECT_EQ(headline.find("whatever the map's size"), std::string::npos) << headline;
    EXPECT_EQ(page.find("LSB by size"), std::string::npos);
    EXPECT_EQ(page.find("<div class=\"grid wide\"></div>"), std::string::npos);
    EXPECT_EQ(times_in(page, "Error against each width"), quick ? 0u : 1u);
    EXPECT_EQ(times_in(page, "Of the 4 sets of widths"), quick ? 1u : 0u);
    EXPECT_EQ(times_in(page, "Of the 125 sets"), quick ? 0u : 1u);
  }
  const StudyData two = data_of(false, 2);
  EXPECT_NE(precision_headline(two).find("0.10 texels at 256 texels a side and within 0.20 at 1024"),
            std::string::npos)
      << precision_headline(two);
  EXPECT_NE(precision_page(two).find("0.10 to 0.20 LSB by size"), std::string::npos);
}

TEST(HalfPrecision, IsTheNearestNumberOfElevenSignificantBits) {
  // Every number that half precision has up to 2^16, whatever the scale by a power of two.
  std::vector<int64_t> numbers;
  for (int64_t exponent = 0; exponent <= 5; ++exponent) {
    for (int64_t mantissa = exponent == 0 ? 0 : 1024; mantissa < 2048; ++mantissa)
      numbers.push_back(mantissa << exponent);
  }
  size_t above = 0;
  for (int64_t height = 0; height <= 65535; ++height) {
    while (above < numbers.size() && numbers[above] < height) ++above;
    int64_t expected = height;
    if (above == numbers.size()) {
      expected = numbers.back();  // the next one is above full scale
    } else if (numbers[above] != height) {
      const int64_t up = numbers[above] - height, down = height - numbers[above - 1];
      expected = up < down ? numbers[above] : numbers[above - 1];
      if (up == down) {  // to the even mantissa: a multiple of twice the step
        const int64_t step = numbers[above] - numbers[above - 1];
        expected = numbers[above] % (2 * step) == 0 ? numbers[above] : numbers[above - 1];
      }
    }
    ASSERT_EQ(in_half_precision(height, 65535), expected) << height;
  }
  for (int64_t height = 0; height < 2048; ++height) ASSERT_EQ(in_half_precision(height, 2047), height);
}

/// A reciprocal rounded to M bits is off by 2^-M of itself at most, and so is the time of a height; no ray
/// falls further than 2^B LSBs. What the direction's own D bits and the grid of times add is below a
/// hundredth of an LSB at D = 32.
TEST(PublishedPrecision, HeightsAreOffByNoMoreThanTheReciprocalsRounding) {
  std::ifstream file("reports/published/precision/data.json", std::ios::binary);
  const StudyData data = parse_study_json({std::istreambuf_iterator<char>(file), {}}, "data.json");
  const StudyTable table(data);
  size_t cases = 0;
  for (int over = 0; over <= 8; over += 2) {
    const auto format = table.find("format", "f12/M+" + std::to_string(over) + "/D32");
    ASSERT_TRUE(format) << over;
    for (const StudyCase& one : data.cases) {
      if (one.place[axis_index(data, "format")] != *format) continue;
      const auto error = table.value(one.place, "top_max");
      ASSERT_TRUE(error);
      EXPECT_LE(static_cast<double>(*error) / 65536, std::ldexp(1.0, -over) + 0.01) << over;
      ++cases;
    }
  }
  EXPECT_GT(cases, 200u);
}

}  // namespace
}  // namespace cuesta
