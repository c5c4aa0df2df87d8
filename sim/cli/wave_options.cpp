#include "sim/cli/wave_options.h"

#include <charconv>
#include <filesystem>
#include <limits>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {
namespace {

/// "17,33" at ',': two numbers, 0 at least. Throws usage_error.
std::pair<int64_t, int64_t> two_numbers(const char* option, const std::string& text, char between,
                                        const char* accepted) {
  int64_t numbers[2];
  const char* const end = text.data() + text.size();
  const auto [middle, first_fault] = std::from_chars(text.data(), end, numbers[0]);
  const bool parted = first_fault == std::errc{} && middle != end && *middle == between;
  if (parted) {
    const auto [stop, fault] = std::from_chars(middle + 1, end, numbers[1]);
    if (fault == std::errc{} && stop == end && numbers[0] >= 0 && numbers[1] >= 0)
      return {numbers[0], numbers[1]};
  }
  throw usage_error(std::string(option) + " " + printable(text) + ": accepted is " + accepted + ".");
}

std::pair<int64_t, int64_t> cycles_of(const WaveOptions& options) {
  const auto cycles = two_numbers("--waves-cycles", options.cycles, ':',
                                  "FIRST:LAST, as in 1000:1200, the last not below the first");
  if (cycles.second >= cycles.first) return cycles;
  throw usage_error("--waves-cycles " + options.cycles + ": the last cycle is below the first.");
}

std::pair<int64_t, int64_t> pixel_of(const WaveOptions& options) {
  return two_numbers("--waves-pixel", options.pixel, ',', "X,Y, as in 17,33, counted from the upper left");
}

}  // namespace

void WaveOptions::declare(Options& options) {
  options.add(
      "--waves", file,
      "With hardware (--fidelity rtl): the signals of one pipeline into an FST file, for GTKWave or Surfer");
  options.add("--waves-cycles", cycles, "FIRST:LAST cycle of the waves; default: the first 1000");
  options.add("--waves-pixel", pixel, "X,Y: from dispatch to completion of this pixel's rays");
  pipeline_option = options
                        .add("--waves-pipeline", pipeline,
                             "Whose hardware; not with --waves-pixel, which is shown in the pixel's")
                        .range(0, std::numeric_limits<int>::max());
}

void WaveOptions::check() const {
  if (!wanted()) {
    if (!cycles.empty() || !pixel.empty() || pipeline_option.count() > 0)
      throw usage_error("--waves-cycles, --waves-pixel and --waves-pipeline need --waves FILE.fst.");
    return;
  }
  if (!cycles.empty() && !pixel.empty())
    throw usage_error("--waves-cycles and --waves-pixel: accepted is one of the two.");
  if (!pixel.empty() && pipeline_option.count() > 0) {
    throw usage_error(
        "--waves-pixel and --waves-pipeline: accepted is one of the two; a pixel is shown in its own "
        "pipeline.");
  }
  if (!cycles.empty()) cycles_of(*this);
  if (!pixel.empty()) pixel_of(*this);
  if (!file.ends_with(".fst"))
    throw usage_error("--waves " + printable(file) + ": accepted is a file whose name ends in .fst.");
  std::error_code fault;
  const std::filesystem::file_type type = std::filesystem::symlink_status(file, fault).type();
  if (type == std::filesystem::file_type::not_found) return;
  if (type == std::filesystem::file_type::none) {  // a name too long, no permission
    throw usage_error("--waves " + printable(file, 200) + " cannot be written: " + fault.message() +
                      "; accepted is a new file in a folder that can be written.");
  }
  throw usage_error("--waves " + printable(file, 200) +
                    " exists and stays as it is; accepted is a new file.");
}

WaveRequest WaveOptions::request() const {
  check();
  WaveRequest request;
  request.file = file;
  request.pipeline = pipeline;
  if (!cycles.empty()) request.cycles = cycles_of(*this);
  if (!pixel.empty()) request.pixel = pixel_of(*this);
  return request;
}

}  // namespace cuesta
