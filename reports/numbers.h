#pragma once

#include <cstdint>
#include <string>

namespace cuesta {

/// 1234567 -> "1,234,567".
std::string grouped(int64_t value);

/// About `digits` significant digits, thousands grouped, no exponent: 12.345 -> "12.3", 0.00123 -> "0.00123".
std::string significant(double value, int digits = 3);

/// With an SI prefix: 2.5e6, "B" -> "2.50 MB". Powers of 1000.
std::string with_prefix(double value, const std::string& unit, int digits = 3);

/// What a person reads for a value of that unit: a fraction as "87.2 %", bytes and rates with a prefix.
std::string readable(double value, const std::string& unit);

/// A percentage with its sign: -0.382 -> "-38.2 %".
std::string signed_percent(double fraction);

/// The smallest of 1, 2, 2.5, 5 times a power of ten that is >= value (value > 0): a plot's round limit.
double round_up_nicely(double value);

}  // namespace cuesta
