#include "sim/cli/wave_options.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <limits>

#include "models/common/error.h"
#include "models/common/words.h"
#include "models/units/ray_dispatch/dispatch_order.h"
#include "sim/cli/options.h"
#include "sim/machine/cycle_machine.h"

namespace cuesta {
namespace {

constexpr Cycle kFirstCycles = 1000;

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

/// From dispatch to completion of the pixel's rays, in the pipeline of the first of them.
WaveWindow window_of_pixel(const WaveOptions& options, const Workload& work, Architecture model,
                           const Progress& progress) {
  const auto [x, y] = pixel_of(options);
  const auto pixel = static_cast<uint64_t>(y) * static_cast<uint64_t>(work.width) + static_cast<uint64_t>(x);
  const bool inside = x < work.width && y < work.height;
  if (!inside ||
      std::find(work.pixel_of_ray.begin(), work.pixel_of_ray.end(), pixel) == work.pixel_of_ray.end()) {
    throw usage_error("--waves-pixel " + options.pixel + ": no ray is of this pixel of the " +
                      std::to_string(work.width) + " x " + std::to_string(work.height) +
                      "; accepted is one with a ray.");
  }
  model.units = {};
  std::vector<PortLog> logs;
  CycleHooks hooks;
  hooks.counters_only = true;
  hooks.port_logs = &logs;
  CycleMachine machine(work, model, hooks);
  machine.run(progress);
  const std::vector<uint32_t> order =
      dispatch_order(work.pixel_of_ray, work.width, model.ray_dispatch.order, model.ray_dispatch.tile_size);
  WaveWindow window{options.file, -1, kNever, 0};
  for (size_t p = 0; p < logs.size(); ++p) {
    for (const PortLog::Hit& hit : logs[p].hits) {
      const uint32_t trace = order[hit.ray];
      if (work.pixel_of_ray[trace] != pixel) continue;
      if (window.pipeline < 0) window.pipeline = static_cast<int>(p);
      if (window.pipeline != static_cast<int>(p)) continue;
      window.first = std::min(window.first, hit.cycle - static_cast<Cycle>(machine.timing(trace).latency));
      window.last = std::max(window.last, hit.cycle);
    }
  }
  return window;
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

CycleRunner wave_runner(const WaveOptions& options, bool quiet) {
  return [options, quiet](const Workload& work, std::span<const TracedRay>, const Architecture& architecture,
                          const Progress& progress) {
    CycleHooks hooks;
    hooks.waves = {options.file, options.pipeline, 0, kFirstCycles - 1};
    if (!options.cycles.empty()) std::tie(hooks.waves.first, hooks.waves.last) = cycles_of(options);
    if (!options.pixel.empty()) hooks.waves = window_of_pixel(options, work, architecture, progress);
    if (hooks.waves.pipeline >= architecture.machine.pipelines) {
      throw usage_error("--waves-pipeline " + std::to_string(hooks.waves.pipeline) + ": the machine has " +
                        std::to_string(architecture.machine.pipelines) + "; they are counted from 0.");
    }
    Outcome outcome = run_cycle_detailed(work, architecture, progress, hooks, nullptr);
    if (quiet) return outcome;
    if (std::filesystem::exists(options.file)) {
      std::cerr << "Waves of pipeline " << hooks.waves.pipeline << ", cycles " << hooks.waves.first << " to "
                << std::min(hooks.waves.last, outcome.measurements.counters.get("machine.cycles") - 1) << ": "
                << options.file << "\n";
    } else {
      std::cerr << "cuesta: warning: the hardware stopped before cycle " << hooks.waves.first
                << ": no waves were written.\n";
    }
    return outcome;
  };
}

}  // namespace cuesta
