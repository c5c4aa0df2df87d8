#include "reports/heat_map.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "tests/support/example_result.h"

namespace cuesta {
namespace {

Result planes_of(std::vector<std::vector<uint32_t>> runs) {
  Result result;
  for (std::vector<uint32_t>& values : runs) {
    RunEntry run;
    run.measurements.plane_width = static_cast<int>(values.size());
    run.measurements.plane_height = 1;
    run.measurements.planes.push_back({"plane.steps", std::move(values), 0, true});
    result.runs.push_back(run);
  }
  return result;
}

TEST(HeatMap, CountsBelow254AreExact) {
  const HeatScale scale = make_heat_scale(planes_of({{0, 7, 253}, {250, 9}}), "plane.steps");
  EXPECT_EQ(scale.maximum, 253);
  for (int64_t value = 0; value <= 253; ++value) EXPECT_EQ(scale.first[scale.bin_of(value)], value);
}

TEST(HeatMap, GoesByLogarithmWhereARunWouldLieInTheLowestThird) {
  EXPECT_FALSE(make_heat_scale(planes_of({{100, 100}, {40, 40}}), "plane.steps").logarithmic);
  EXPECT_FALSE(make_heat_scale(planes_of({{100, 100}, {34, 34}}), "plane.steps").logarithmic);
  EXPECT_TRUE(make_heat_scale(planes_of({{100, 100}, {33, 33}}), "plane.steps").logarithmic);
}

TEST(HeatMap, EveryCountIsInTheBinThatHoldsIt) {
  const HeatScale scale = make_heat_scale(planes_of({{3, 4, 5}, {100000, 4000000000u}}), "plane.steps");
  EXPECT_TRUE(scale.logarithmic);
  EXPECT_LE(scale.first.size(), 254u);
  for (int64_t value : {int64_t{0}, int64_t{1}, int64_t{5}, int64_t{99999}, int64_t{4000000000}}) {
    const size_t bin = scale.bin_of(value);
    EXPECT_LE(scale.first[bin], value);
    if (bin + 1 < scale.first.size()) EXPECT_GT(scale.first[bin + 1], value);
  }
}

TEST(HeatMap, AllRunsShareOneScale) {
  const Result result = tests::example_result();
  const HeatScale scale = make_heat_scale(result, "plane.steps");
  uint32_t largest = 0;
  for (const RunEntry& run : result.runs) {
    for (uint32_t value : run.measurements.planes[0].values) largest = std::max(largest, value);
  }
  EXPECT_EQ(scale.maximum, largest);
  EXPECT_EQ(scale.unit, "steps");
}

TEST(HeatMap, AFlatPlaneOfZerosHasAPicture) {
  const Result result = planes_of({{0, 0, 0}});
  const HeatScale scale = make_heat_scale(result, "plane.steps");
  const Picture picture = heat_map(result.runs[0].measurements.planes[0], 3, 1, scale, "steps", "dda");
  EXPECT_EQ(picture.pixels.size(), static_cast<size_t>(picture.width) * static_cast<size_t>(picture.height));
}

TEST(HeatMap, ReductionTakesTheMean) {
  const Plane plane{"plane.steps", {1, 3, 5, 7, 9, 11, 13, 15}, 0, true};
  const HeatScale scale = make_heat_scale(planes_of({{15}}), "plane.steps");
  const PlanePicture small = plane_picture(plane, 4, 2, scale, 2);
  EXPECT_EQ(small.reduction, 2);
  EXPECT_EQ(small.picture.width, 2);
  EXPECT_EQ(small.picture.height, 1);
  EXPECT_EQ(scale.first[small.picture.pixels[0]], 6);   // 1, 3, 9, 11
  EXPECT_EQ(scale.first[small.picture.pixels[1]], 10);  // 5, 7, 13, 15
}

TEST(HeatMap, NoTwoBinsShareAColour) {
  for (uint32_t maximum : {1u, 100u, 253u, 254u, 1000u, 4000000000u}) {
    for (uint32_t other : {1u, maximum}) {  // logarithmic, linear
      const HeatScale scale = make_heat_scale(planes_of({{maximum}, {other}}), "plane.steps");
      std::set<std::tuple<int, int, int>> colours;
      for (const Colour& colour : palette_of(scale)) colours.insert({colour.r, colour.g, colour.b});
      EXPECT_EQ(colours.size(), scale.first.size()) << maximum;
      EXPECT_LE(scale.first.size(), 254u);
      EXPECT_GE(scale.first.size(), std::min(254u, maximum + 1) * 9 / 10) << maximum;
    }
  }
}

TEST(HeatMap, ColoursGrowLighterWithTheCount) {
  double before = -1;
  for (int k = 0; k <= 32; ++k) {
    const Colour colour = viridis(k / 32.0);
    const double luma = 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
    EXPECT_GT(luma, before);
    before = luma;
  }
}

}  // namespace
}  // namespace cuesta
