#include "models/common/elementary.h"

#include <bit>
#include <cstdint>
#include <limits>

namespace cuesta::elementary {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// x = quadrant * pi / 2 + high + low, |high| <= pi / 4 and a little.
struct Reduced {
  double high, low;
  int quadrant;  ///< 0 to 3
};

/// Cody and Waite 1980: pi / 2 in parts of 33 bits, so that n * part is exact for |n| < 2^20.
Reduced reduce(double x) {
  constexpr double kPart1 = 0x1.921fb544p+0;
  constexpr double kPart2 = 0x1.0b4611a6p-34;
  constexpr double kPart3 = 0x1.3198a2ep-69;
  constexpr double kPart4 = 0x1.b839a252049c1p-104;
  const double quotient = x * (2.0 / std::numbers::pi);
  const int64_t n = static_cast<int64_t>(quotient + (quotient < 0 ? -0.5 : 0.5));
  const double count = static_cast<double>(n);
  // Exact: both operands are near each other. What follows is a sum of two doubles kept with its rounding error.
  const double first = x - count * kPart1;
  const double step = count * kPart2;
  const double second = first - step;
  const double lost = (first - second) - step;
  const double step3 = count * kPart3;
  const double third = second - step3;
  const double lost3 = (second - third) - step3;
  const double rest = (lost + lost3) - count * kPart4;
  const double high = third + rest;
  const double low = (third - high) + rest;
  return {high, low, static_cast<int>(n & 3)};
}

/// Minimax coefficients on [-pi/4, pi/4] of fdlibm's __kernel_sin (Sun Microsystems 1993).
double kernel_sin(double x, double low) {
  const double z = x * x;
  const double v = z * x;
  const double r = 8.33333333332248946124e-03 +
                   z * (-1.98412698298579493134e-04 +
                        z * (2.75573137070700676789e-06 +
                             z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  return x - ((z * (0.5 * low - v * r) - low) - v * -1.66666666666666324348e-01);
}

/// fdlibm's __kernel_cos.
double kernel_cos(double x, double low) {
  const double z = x * x;
  const double r = z * (4.16666666666666019037e-02 +
                        z * (-1.38888888888741095749e-03 +
                             z * (2.48015872894767294178e-05 +
                                  z * (-2.75573143513906633035e-07 +
                                       z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const double half = 0.5 * z;
  const double w = 1.0 - half;
  return w + (((1.0 - w) - half) + (z * r - x * low));
}

bool in_range(double x) { return x >= -1e6 && x <= 1e6; }

}  // namespace

double sin(double x) {
  if (!in_range(x)) return kNan;
  if (x == 0) return x;
  const Reduced r = reduce(x);
  const double value = r.quadrant & 1 ? kernel_cos(r.high, r.low) : kernel_sin(r.high, r.low);
  return r.quadrant & 2 ? -value : value;
}

double cos(double x) {
  if (!in_range(x)) return kNan;
  const Reduced r = reduce(x);
  const double value = r.quadrant & 1 ? kernel_sin(r.high, r.low) : kernel_cos(r.high, r.low);
  return r.quadrant == 1 || r.quadrant == 2 ? -value : value;
}

double tan(double x) {
  if (!in_range(x)) return kNan;
  if (x == 0) return x;
  const Reduced r = reduce(x);
  const double sine = kernel_sin(r.high, r.low);
  const double cosine = kernel_cos(r.high, r.low);
  return r.quadrant & 1 ? -cosine / sine : sine / cosine;
}

double exp2(double x) {
  if (x != x) return x;
  if (x >= 1024) return kInfinity;
  if (x < -1075) return 0;
  const int n = static_cast<int>(x + (x < 0 ? -0.5 : 0.5));
  const double y = (x - n) * std::numbers::ln2;
  double sum =
      0;  // Taylor series of e^y - 1 - y over y^2, |y| <= 0.347: the first term left out is 2^-58 of 1
  constexpr double kInverseFactorial[] = {1.0 / 2,       1.0 / 6,        1.0 / 24,        1.0 / 120,
                                          1.0 / 720,     1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                                          1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800};
  for (int k = 11; k >= 0; --k) sum = sum * y + kInverseFactorial[k];
  const double power = 1.0 + (y + y * y * sum);
  // Two factors, each within double's range: the last product rounds once, into the subnormals too.
  const int first = n / 2;
  const auto two_to = [](int e) { return std::bit_cast<double>(static_cast<uint64_t>(e + 1023) << 52); };
  return power * two_to(first) * two_to(n - first);
}

double log2(double x) {
  if (x != x || x < 0) return kNan;
  if (x == 0) return -kInfinity;
  if (x == kInfinity) return x;
  int exponent = 0;
  if (x < 0x1p-1022) {
    x *= 0x1p54;
    exponent = -54;
  }
  const uint64_t bits = std::bit_cast<uint64_t>(x);
  exponent += static_cast<int>(bits >> 52) - 1023;
  double m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFull) | 0x3FF0000000000000ull);
  if (m > std::numbers::sqrt2) {
    m *= 0.5;
    ++exponent;
  }
  // ln m = 2 atanh(s), |s| <= 0.172.
  const double s = (m - 1) / (m + 1);
  const double z = s * s;
  double sum = 0;
  for (int k = 11; k >= 1; --k) sum = sum * z + 1.0 / (2 * k + 1);
  const double logarithm = 2 * s + 2 * s * (z * sum);
  return exponent + logarithm * (1.0 / std::numbers::ln2);
}

}  // namespace cuesta::elementary
