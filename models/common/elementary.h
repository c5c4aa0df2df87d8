#pragma once

#include <numbers>

/// Elementary functions that give the same bits with every compiler, library and optimisation level: polynomials
/// in double built from +, -, *, / alone. libm's own differ from one version to the next, so code whose numbers
/// end in a result calls these (and sqrt, which IEEE 754 defines exactly).
namespace cuesta::elementary {

/// Radians; |x| <= 1e6, NaN beyond. Absolute error below 2e-16 (a little more than half a unit in the last place
/// of 1); relative error below 1e-15 for |x| <= 100.
double sin(double x);
double cos(double x);
double tan(double x);

/// 2^x, relative error below 1e-15; 0 and infinity where double ends, gradual underflow kept.
double exp2(double x);

/// Binary logarithm, relative error below 1e-15. -infinity for 0, NaN below.
double log2(double x);

inline double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }

}  // namespace cuesta::elementary
