#include "models/common/elementary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "models/common/random.h"

namespace cuesta {
namespace {

/// |value - truth| over |truth|, in long double.
double relative_error(double value, long double truth) {
  if (truth == 0) return value == 0 ? 0 : 1;
  return static_cast<double>(std::fabs((value - truth) / truth));
}

TEST(Elementary, SineCosineTangentAreWithin1e15OfLongDoubleUpTo100Radians) {
  Random random(1);
  for (int n = 0; n < 300000; ++n) {
    const double x = (2 * random.unit() - 1) * (n % 3 == 0 ? 0.01 : n % 3 == 1 ? 3.2 : 100.0);
    ASSERT_LT(relative_error(elementary::sin(x), std::sin(static_cast<long double>(x))), 1e-15) << x;
    ASSERT_LT(relative_error(elementary::cos(x), std::cos(static_cast<long double>(x))), 1e-15) << x;
    ASSERT_LT(relative_error(elementary::tan(x), std::tan(static_cast<long double>(x))), 1e-15) << x;
  }
}

TEST(Elementary, SineStaysWithin2e16UpToAMillionRadians) {
  Random random(2);
  for (int n = 0; n < 300000; ++n) {
    const double x = (2 * random.unit() - 1) * 1e6;
    ASSERT_LT(std::fabs(elementary::sin(x) - std::sin(static_cast<long double>(x))), 2e-16L) << x;
    ASSERT_LT(std::fabs(elementary::cos(x) - std::cos(static_cast<long double>(x))), 2e-16L) << x;
  }
}

TEST(Elementary, SineIsAccurateBesideMultiplesOfPi) {
  for (int k = -60; k <= 60; ++k) {
    const double x = k * 3.14159265358979323846 / 2;
    for (double y : {x, std::nextafter(x, 1e9), std::nextafter(x, -1e9)}) {
      // x87's long double reduction is itself limited here: compare absolutely, and relatively where it can.
      EXPECT_LT(std::fabs(elementary::sin(y) - std::sin(static_cast<long double>(y))), 2e-16L) << y;
      EXPECT_LT(relative_error(elementary::sin(y), std::sin(static_cast<long double>(y))), 1e-15) << y;
    }
  }
}

TEST(Elementary, AnglesBeyondTheReductionAreNotANumber) {
  EXPECT_FALSE(std::isnan(elementary::sin(1e6)));
  EXPECT_TRUE(std::isnan(elementary::sin(std::nextafter(1e6, 2e6))));
  EXPECT_TRUE(std::isnan(elementary::cos(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(elementary::tan(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Elementary, Exp2AndLog2AreWithin1e15OfLongDouble) {
  Random random(3);
  for (int n = 0; n < 300000; ++n) {
    const double x = (2 * random.unit() - 1) * (n % 2 ? 1.0 : 1022.0);
    ASSERT_LT(relative_error(elementary::exp2(x), std::exp2(static_cast<long double>(x))), 1e-15) << x;
    const double y =
        n % 2 ? 0.5 + 2 * random.unit() : std::ldexp(1 + random.unit(), int(random.between(-1074, 1022)));
    ASSERT_LT(relative_error(elementary::log2(y), std::log2(static_cast<long double>(y))), 1e-15) << y;
  }
}

TEST(Elementary, Exp2AndLog2AreExactAtPowersOfTwo) {
  for (int k = -1074; k <= 1023; ++k) {
    EXPECT_EQ(elementary::exp2(k), std::ldexp(1.0, k));
    EXPECT_EQ(elementary::log2(std::ldexp(1.0, k)), k);
  }
  EXPECT_EQ(elementary::exp2(1024), std::numeric_limits<double>::infinity());
  EXPECT_EQ(elementary::exp2(-1076), 0);
  EXPECT_EQ(elementary::log2(0), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(elementary::log2(-1)));
}

}  // namespace
}  // namespace cuesta
