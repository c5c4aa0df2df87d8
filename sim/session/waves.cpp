#include "sim/session/waves.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "models/common/error.h"
#include "models/units/ray_dispatch/dispatch_order.h"
#include "sim/machine/cycle_machine.h"

namespace cuesta {
namespace {

constexpr Cycle kFirstCycles = 1000;

/// Gives the cycles from dispatch to completion of the pixel's rays, in the pipeline of the first of them.
WaveWindow window_of_pixel(const WaveRequest& waves, const Workload& work, Architecture model,
                           const Progress& progress) {
  const auto [x, y] = *waves.pixel;
  const auto pixel = static_cast<uint64_t>(y) * static_cast<uint64_t>(work.width) + static_cast<uint64_t>(x);
  const bool inside = x < work.width && y < work.height;
  if (!inside ||
      std::find(work.pixel_of_ray.begin(), work.pixel_of_ray.end(), pixel) == work.pixel_of_ray.end()) {
    throw usage_error("--waves-pixel " + std::to_string(x) + "," + std::to_string(y) +
                      ": no ray is of this pixel of the " + std::to_string(work.width) + " x " +
                      std::to_string(work.height) + "; accepted is one with a ray.");
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
  WaveWindow window{waves.file, -1, kNever, 0};
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

std::string what_was_written(const WaveWindow& window, Cycle cycles) {
  if (!std::filesystem::exists(window.file)) {
    return "cuesta: warning: the hardware stopped before cycle " + std::to_string(window.first) +
           ": no waves were written.";
  }
  return "Waves of pipeline " + std::to_string(window.pipeline) + ", cycles " + std::to_string(window.first) +
         " to " + std::to_string(std::min(window.last, cycles - 1)) + ": " + window.file;
}

}  // namespace

CycleRunner wave_runner(const WaveRequest& waves, Observer& observer) {
  return [waves, &observer](const Workload& work, std::span<const TracedRay>,
                            const Architecture& architecture, const Progress& progress) {
    CycleHooks hooks;
    hooks.waves = {waves.file, waves.pipeline, 0, kFirstCycles - 1};
    if (waves.cycles) std::tie(hooks.waves.first, hooks.waves.last) = *waves.cycles;
    if (waves.pixel) hooks.waves = window_of_pixel(waves, work, architecture, progress);
    if (hooks.waves.pipeline >= architecture.machine.pipelines) {
      throw usage_error("--waves-pipeline " + std::to_string(hooks.waves.pipeline) + ": the machine has " +
                        std::to_string(architecture.machine.pipelines) + "; they are counted from 0.");
    }
    Outcome outcome = run_cycle_detailed(work, architecture, progress, hooks, nullptr);
    observer.on_remark(what_was_written(hooks.waves, outcome.measurements.counters.get("machine.cycles")));
    return outcome;
  };
}

}  // namespace cuesta
