#pragma once

#include <cstdint>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cuesta {

/// "--seed" of a verb: a whole number of 64 bits, `seed` by default. Anything else, -1 and numbers beyond 64 bits
/// among it, is refused with usage_error when the line is read.
CLI::Option* add_seed_option(CLI::App& app, uint64_t& seed, const std::string& meaning);

}  // namespace cuesta
