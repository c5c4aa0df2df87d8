#pragma once

namespace cuesta {

__extension__ typedef __int128 Int128;

/// A time as a fraction, compared by cross-multiplying and never divided. den >= 0; den = 0 is -infinity or
/// +infinity by the sign of num. `Int` is any signed integer that holds the products: Int128 for machine rays,
/// a multiple-precision integer for rays as traced.
template <class Int>
struct ExactTime {
  Int num{0};
  Int den{1};

  static ExactTime infinity() { return {Int(1), Int(0)}; }
  static ExactTime minus_infinity() { return {Int(-1), Int(0)}; }
  bool is_finite() const { return den != 0; }

  friend bool operator<(const ExactTime& a, const ExactTime& b) {
    if (a.den == 0 && b.den == 0) return a.num < b.num;
    return Int(a.num * b.den) < Int(b.num * a.den);
  }
  friend bool operator==(const ExactTime& a, const ExactTime& b) { return !(a < b) && !(b < a); }
  friend bool operator<=(const ExactTime& a, const ExactTime& b) { return !(b < a); }
  friend bool operator>=(const ExactTime& a, const ExactTime& b) { return !(a < b); }
  friend bool operator>(const ExactTime& a, const ExactTime& b) { return b < a; }
};

template <class Int>
const ExactTime<Int>& later(const ExactTime<Int>& a, const ExactTime<Int>& b) {
  return a < b ? b : a;
}

template <class Int>
const ExactTime<Int>& earlier(const ExactTime<Int>& a, const ExactTime<Int>& b) {
  return b < a ? b : a;
}

/// Largest integer <= num / den, den > 0.
template <class Int>
Int floor_divide(const Int& num, const Int& den) {
  Int quotient = num / den;
  if (Int(quotient * den) > num) quotient -= 1;
  return quotient;
}

}  // namespace cuesta
