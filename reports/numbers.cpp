#include "reports/numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace cuesta {
namespace {

std::string group_digits(std::string digits) {
  const size_t start = digits.starts_with('-') ? 1 : 0;
  size_t end = digits.find('.');
  if (end == std::string::npos) end = digits.size();
  while (end > start + 3) {
    end -= 3;
    digits.insert(end, 1, ',');
  }
  return digits;
}

}  // namespace

std::string grouped(int64_t value) { return group_digits(fmt::format("{}", value)); }

std::string significant(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  if (value == 0) return "0";
  const std::string rounded =
      fmt::format("{:.{}e}", value, digits - 1);  // 9.999 has two digits before the point
  const int magnitude = std::stoi(rounded.substr(rounded.find('e') + 1));
  const int decimals = std::max(0, digits - 1 - magnitude);
  return group_digits(fmt::format("{:.{}f}", value, decimals));
}

std::string with_prefix(double value, const std::string& unit, int digits) {
  static constexpr const char* kPrefixes[] = {"", "k", "M", "G", "T", "P"};
  int index = 0;
  double scaled = value;
  while (std::fabs(scaled) >= 999.5 && index < 5) {
    scaled /= 1000;
    ++index;
  }
  const bool whole = index == 0 && scaled == std::floor(scaled);
  return (whole ? fmt::format("{:.0f}", scaled) : significant(scaled, digits)) + " " + kPrefixes[index] +
         unit;
}

std::string readable(double value, const std::string& unit) {
  if (unit == "fraction") return fmt::format("{:.1f} %", value * 100);
  if (unit == "bytes") return with_prefix(value, "B");
  if (unit == "bytes/s") return with_prefix(value, "B/s");
  if (unit == "rays/s" || unit == "steps/s" || unit == "frames/s") return with_prefix(value, unit);
  const bool whole =
      value == std::floor(value) && std::fabs(value) < 1e15 && unit.find('/') == std::string::npos;
  const std::string number = whole ? grouped(static_cast<int64_t>(value)) : significant(value, 4);
  return unit.empty() ? number : number + " " + unit;
}

std::string signed_percent(double fraction) {
  const double percent = fraction * 100;
  return std::fabs(percent) < 0.05 ? "0.0 %" : fmt::format("{:+.1f} %", percent);
}

double round_up_nicely(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (double step : {1.0, 2.0, 2.5, 5.0}) {
    if (step * decade >= value * (1 - 1e-12)) return step * decade;
  }
  return 10 * decade;
}

}  // namespace cuesta
