#include "sim/cli/seed_option.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <limits>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {
namespace {

uint64_t parse_seed(const std::string& text) {
  uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, seed);
  if (fault == std::errc{} && stop == end) return seed;
  throw usage_error("--seed " + printable(text) + " is not accepted; accepted is a whole number from 0 to " +
                    std::to_string(std::numeric_limits<uint64_t>::max()) + ".");
}

}  // namespace

CLI::Option* add_seed_option(CLI::App& app, uint64_t& seed, const std::string& meaning) {
  // Not CLI11's own reading of numbers: it takes -1 for the largest number, and numbers too large as well.
  return app
      .add_option_function<std::string>(
          "--seed", [&seed](const std::string& text) { seed = parse_seed(text); }, meaning)
      ->type_name("UINT")
      ->default_str(std::to_string(seed));
}

}  // namespace cuesta
