#include <unistd.h>

#include <filesystem>
#include <functional>

#include "models/common/error.h"
#include "models/work/functional_run.h"
#include "sim/config/architecture_file.h"
#include "sim/config/on_architecture.h"
#include "sim/explore/fidelity/fidelity.h"
#include "sim/explore/study/wall_times.h"
#include "sim/hosts/systemc/systemc_host.h"
#include "sim/machine/cycle_machine.h"
#include "sim/session/job.h"

namespace cuesta {
namespace {

constexpr const char* kAlgorithm = "yun2013";

/// One level over one frame. Throws Error(kMismatch) when it finds other hits than `hits`, which the first
/// level sets.
TimedRun timed(const std::string& machine, const std::string& level, const std::function<Outcome()>& run,
               std::string& hits) {
  TimedRun result{machine, kAlgorithm, level, 0, 0, 0};
  result.seconds = median_seconds([&] {
    const Outcome outcome = run();
    result.rays = static_cast<int64_t>(outcome.hits.size());
    result.cycles = outcome.measurements.counters.get("machine.cycles");
    if (hits.empty()) hits = outcome.hits_digest;
    if (hits != outcome.hits_digest) {
      throw Error(ExitCode::kMismatch,
                  "Level " + level + " on " + machine + " finds other hits than the first one.");
    }
  });
  return result;
}

}  // namespace

StudyTimes fidelity_times(bool quick, const StudyProgress& progress) {
  const int side = quick ? 32 : 128;
  StudyTimes times = times_of_this_host("Scene default, " + std::to_string(side) + " x " +
                                        std::to_string(side) + " pixels, " + kAlgorithm +
                                        "; whole runs with counters, planes and digests; the making of rays "
                                        "left out; median of three.");
  SceneChanges changes;
  changes.size = {side, side};
  const Job job = prepare_job("default", changes);
  SystemCHost systemc("", 8, true);
  const std::filesystem::path waves =
      std::filesystem::temp_directory_path() / ("cuesta-times-" + std::to_string(getpid()) + ".fst");
  const std::vector<std::string> machines = {"tiny", "mobile", "desktop"};
  for (size_t k = 0; k < machines.size(); ++k) {
    const Architecture machine = resolve_architecture(machines[k], {}, true).architecture;
    Architecture hardware = machine;
    hardware.units.hmt_top = Implementation::kRtl;
    const std::vector<MachineRay> rays = machine_rays(job, number_format(machine.traverse, job.map));
    const Workload work = workload_of(job, machine, rays, *find_algorithm(kAlgorithm));
    std::string hits;
    const auto add = [&](const char* level, const std::function<Outcome()>& run) {
      if (progress && !progress(times.runs.size(), 6 * machines.size()))
        throw Error(ExitCode::kIncomplete, "Stopped while wall times were measured.");
      try {
        times.runs.push_back(timed(machines[k], level, run, hits));
      } catch (const Error& error) {
        if (error.code() != ExitCode::kUsage) throw;  // this build has no such hardware
      }
    };
    add("functional", [&] { return run_functional(work); });
    add("transaction", [&] { return run_transaction(work, machine); });
    add("cycle", [&] { return run_cycle(work, machine); });
    add("cycle in SystemC", [&] { return systemc.run(work, job.trace.rays, machine, {}); });
    add("rtl", [&] { return run_cycle(work, hardware); });
    add("rtl with waves", [&] {
      CycleHooks hooks;
      hooks.waves = {waves.string(), 0, 0, kFidelityWaveCycles - 1};
      return run_cycle_detailed(work, hardware, {}, hooks, nullptr);
    });
  }
  std::error_code ignored;
  std::filesystem::remove(waves, ignored);
  return times;
}

}  // namespace cuesta
