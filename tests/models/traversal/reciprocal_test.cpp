#include "models/traversal/reciprocal.h"

#include <gtest/gtest.h>

#include "models/common/random.h"
#include "models/oracle/exact_ray.h"

namespace cuesta {
namespace {

void expect_same_as_oracle(int64_t d, const NumberFormat& format) {
  const Reciprocal found = reciprocal(d, format);
  const OracleReciprocal expected = oracle_reciprocal(d, format);
  ASSERT_EQ(found.mantissa, expected.mantissa)
      << "d " << d << ", D " << format.direction_bits << ", M " << format.mantissa_bits;
  ASSERT_EQ(found.exponent, expected.exponent) << "d " << d;
}

TEST(Reciprocal, IsWhatHandsCompute) {
  const NumberFormat format{.fraction_bits = 8, .direction_bits = 8, .mantissa_bits = 4, .tile_bits = 4};
  EXPECT_EQ(reciprocal(128, format).mantissa, 16);  // 2^11 / 128
  EXPECT_EQ(reciprocal(128, format).exponent, 0);
  EXPECT_EQ(reciprocal(255, format).mantissa, 8);  // 2^11 / 255 = 8.03
  EXPECT_EQ(reciprocal(96, format).mantissa, 11);  // 2^10 / 96 = 10.67
  EXPECT_EQ(reciprocal(96, format).exponent, 1);
  EXPECT_EQ(reciprocal(1, format).mantissa, 16);
  EXPECT_EQ(reciprocal(1, format).exponent, 7);
}

TEST(Reciprocal, RoundsHalfUpForEveryDirectionOfTwelveBits) {
  for (int mantissa_bits = 2; mantissa_bits <= 24; ++mantissa_bits) {
    const NumberFormat format{.fraction_bits = 8, .direction_bits = 12, .mantissa_bits = mantissa_bits};
    for (int64_t d = 1; d < 4096; ++d) expect_same_as_oracle(d, format);
  }
}

TEST(Reciprocal, KeepsItsRangeAndItsErrorBoundAtAllWidths) {
  Random random(11);
  for (int n = 0; n < 200000; ++n) {
    const NumberFormat format{.fraction_bits = 8,
                              .direction_bits = static_cast<int>(random.between(8, 32)),
                              .mantissa_bits = static_cast<int>(random.between(2, 24))};
    const int bits = static_cast<int>(random.between(1, format.direction_bits));
    int64_t d = random.between(int64_t{1} << (bits - 1), (int64_t{1} << bits) - 1);
    if (random.chance(0.1)) d = (int64_t{1} << bits) - 1;
    const Reciprocal r = reciprocal(d, format);
    ASSERT_GE(r.mantissa, int64_t{1} << (format.mantissa_bits - 1));
    ASSERT_LE(r.mantissa, int64_t{1} << format.mantissa_bits);
    ASSERT_EQ(r.exponent, format.direction_bits - bits);
    // |m * d - 2^(b-1+M)| <= d / 2: nearest; in units of the value, at most 2^-M.
    const Int128 error = Int128{r.mantissa} * d - (Int128{1} << (bits - 1 + format.mantissa_bits));
    ASSERT_LE(2 * (error < 0 ? -error : error), Int128{d});
    expect_same_as_oracle(d, format);
  }
}

}  // namespace
}  // namespace cuesta
