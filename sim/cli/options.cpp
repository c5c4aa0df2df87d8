#include "sim/cli/options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <limits>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {
namespace {

/// Not CLI11's own reading of numbers: it takes -1 for the largest number, and numbers too large as well.
void require_whole(const std::string& option, const std::string& text) {
  uint64_t whole = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, whole);
  if (fault == std::errc{} && stop == end) return;
  throw usage_error(option + " " + printable(text) +
                    " is not accepted; accepted is a whole number from 0 to " +
                    std::to_string(std::numeric_limits<uint64_t>::max()) + ".");
}

}  // namespace

Option Option::required() { return Option(option_->required()); }
Option Option::with_default() { return Option(option_->capture_default_str()); }
Option Option::range(int low, int high) { return Option(option_->check(CLI::Range(low, high))); }
Option Option::range(int64_t low, int64_t high) { return Option(option_->check(CLI::Range(low, high))); }
Option Option::range(uint64_t low, uint64_t high) { return Option(option_->check(CLI::Range(low, high))); }
Option Option::range(double low, double high) { return Option(option_->check(CLI::Range(low, high))); }
Option Option::excludes(Option other) { return Option(option_->excludes(other.option_)); }
size_t Option::count() const { return option_->count(); }

Option Options::add(const std::string& names, std::string& value, const std::string& meaning) {
  return Option(app_.add_option(names, value, meaning));
}
Option Options::add(const std::string& names, int& value, const std::string& meaning) {
  return Option(app_.add_option(names, value, meaning));
}
Option Options::add(const std::string& names, int64_t& value, const std::string& meaning) {
  return Option(app_.add_option(names, value, meaning));
}
Option Options::add(const std::string& names, uint64_t& value, const std::string& meaning) {
  CLI::Option* const option = app_.add_option(names, value, meaning);
  option->check([names](const std::string& text) {
    require_whole(names, text);
    return std::string();
  });
  return Option(option);
}
Option Options::add(const std::string& names, double& value, const std::string& meaning) {
  return Option(app_.add_option(names, value, meaning));
}
Option Options::add(const std::string& names, std::optional<int>& value, const std::string& meaning) {
  return Option(app_.add_option(names, value, meaning));
}
Option Options::add(const std::string& names, std::optional<double>& value, const std::string& meaning) {
  return Option(app_.add_option(names, value, meaning));
}
Option Options::add(const std::string& names, std::vector<std::string>& value, const std::string& meaning) {
  CLI::Option* const option = app_.add_option(names, value, meaning);
  if (names.starts_with("-")) option->allow_extra_args(false);
  return Option(option);
}
Option Options::add_flag(const std::string& names, bool& value, const std::string& meaning) {
  return Option(app_.add_flag(names, value, meaning));
}

}  // namespace cuesta
