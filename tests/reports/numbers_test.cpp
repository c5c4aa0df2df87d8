#include "reports/numbers.h"

#include <gtest/gtest.h>

namespace cuesta {
namespace {

TEST(Numbers, ThousandsAreGroupedFromTheRight) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1,000");
  EXPECT_EQ(grouped(-1234567), "-1,234,567");
  EXPECT_EQ(grouped(INT64_MIN), "-9,223,372,036,854,775,808");
}

TEST(Numbers, SignificantDigitsNeverCutTheWholePart) {
  EXPECT_EQ(significant(12.345), "12.3");
  EXPECT_EQ(significant(0.00123), "0.00123");
  EXPECT_EQ(significant(123456.7), "123,457");
  EXPECT_EQ(significant(0), "0");
  EXPECT_EQ(significant(9.9996), "10.0");
  EXPECT_EQ(significant(-999.6), "-1,000");
}

TEST(Numbers, PrefixesArePowersOfAThousand) {
  EXPECT_EQ(with_prefix(2.5e6, "B"), "2.50 MB");
  EXPECT_EQ(with_prefix(999, "B"), "999 B");
  EXPECT_EQ(with_prefix(1000, "B"), "1.00 kB");
}

TEST(Numbers, FractionsReadAsPerCent) {
  EXPECT_EQ(readable(0.872, "fraction"), "87.2 %");
  EXPECT_EQ(signed_percent(-0.3821), "-38.2 %");
  EXPECT_EQ(signed_percent(0.1), "+10.0 %");
  EXPECT_EQ(signed_percent(-0.0001), "0.0 %");
}

TEST(Numbers, RoundLimitsAreNeverBelowTheValue) {
  EXPECT_EQ(round_up_nicely(1), 1);
  EXPECT_EQ(round_up_nicely(1.01), 2);
  EXPECT_EQ(round_up_nicely(21), 25);
  EXPECT_EQ(round_up_nicely(0.6), 1);
  EXPECT_EQ(round_up_nicely(5001), 10000);
}

}  // namespace
}  // namespace cuesta
