#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace cuesta {

/// One option or argument of a verb: what CLI11 knows of it. Each call gives the same option back.
class Option {
 public:
  Option() = default;
  explicit Option(CLI::Option* option) : option_(option) {}

  Option required();
  /// --help says the value that it has now.
  Option with_default();
  /// Both ends included; others are refused with the ends.
  Option range(int low, int high);
  Option range(int64_t low, int64_t high);
  Option range(uint64_t low, uint64_t high);
  Option range(double low, double high);
  /// Not beside that one.
  Option excludes(Option other);
  /// How often the command line gives it.
  size_t count() const;

 private:
  CLI::Option* option_ = nullptr;
};

/// The options and arguments of a verb. `names`: "-o,--output", or without dashes an argument by its place, or both. A
/// value is what it is when its option is not given. Here so that one file compiles CLI11 for all verbs.
class Options {
 public:
  explicit Options(CLI::App& app) : app_(app) {}

  Option add(const std::string& names, std::string& value, const std::string& meaning);
  Option add(const std::string& names, int& value, const std::string& meaning);
  Option add(const std::string& names, int64_t& value, const std::string& meaning);
  /// Anything but a whole number of 64 bits, -1 and larger ones among it, is refused with
  /// usage_error when the line is read.
  Option add(const std::string& names, uint64_t& value, const std::string& meaning);
  Option add(const std::string& names, double& value, const std::string& meaning);
  Option add(const std::string& names, std::optional<int>& value, const std::string& meaning);
  Option add(const std::string& names, std::optional<double>& value, const std::string& meaning);
  /// With dashes: one value each time that the option is given; without: several in a row.
  Option add(const std::string& names, std::vector<std::string>& value, const std::string& meaning);
  Option add_flag(const std::string& names, bool& value, const std::string& meaning);

 private:
  CLI::App& app_;
};

}  // namespace cuesta
