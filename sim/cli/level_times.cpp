#include "sim/cli/level_times.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>

#include "models/common/build_info.h"
#include "models/common/error.h"
#include "sim/cli/progress.h"
#include "sim/config/architecture_file.h"
#include "sim/cycle_machine.h"
#include "sim/hosts/systemc/systemc_host.h"
#include "sim/job.h"

namespace cuesta {
namespace {

constexpr int kSide = 128;
constexpr Cycle kWaveCycles = 20'000;

std::string first_line_with(const char* file, const std::string& key) {
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with(key)) {
      const size_t colon = line.find(':');
      return colon == std::string::npos ? line : line.substr(std::min(colon + 2, line.size()));
    }
  }
  return "unknown";
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d", &parts);
  return text;
}

using Run = std::function<Outcome()>;

/// The median of three; nothing where this build has no such hardware.
bool add_level(const std::string& machine, const std::string& level, const Run& run, std::string& hits,
               StudyTimes& times) {
  std::array<double, 3> seconds{};
  TimedRun timed{machine, level, 0, 0, 0};
  for (double& one : seconds) {
    const auto start = std::chrono::steady_clock::now();
    Outcome outcome;
    try {
      outcome = run();
    } catch (const Error& error) {
      if (error.code() == ExitCode::kUsage) return false;
      throw;
    }
    one = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    timed.rays = static_cast<int64_t>(outcome.hits.size());
    timed.cycles = outcome.measurements.counters.get("machine.cycles");
    if (hits.empty()) hits = outcome.hits_digest;
    if (hits != outcome.hits_digest)
      throw Error(ExitCode::kMismatch,
                  "Level " + level + " on " + machine + " finds other hits than the first one.");
  }
  std::sort(seconds.begin(), seconds.end());
  timed.seconds = seconds[1];
  times.runs.push_back(timed);
  return true;
}

}  // namespace

StudyTimes measure_levels(const Session& session) {
  StudyTimes times;
  char host[256] = {};
  times.host = gethostname(host, sizeof host - 1) == 0 ? host : "unknown";
  times.processor = first_line_with("/proc/cpuinfo", "model name");
  times.load = first_line_with("/proc/loadavg", "");
  times.date = today();
  times.build = std::string(build_info().compiler) + ", " + std::string(build_info().flags);
  times.frame = "Scene default, " + std::to_string(kSide) + " x " + std::to_string(kSide) +
                " pixels, yun2013; whole runs with counters, planes and digests; the making of "
                "rays left out; "
                "median of three.";
  SceneChanges changes;
  changes.size = {kSide, kSide};
  const Job job = prepare_job("default", changes);
  SystemCHost systemc("", 8, true);
  const std::filesystem::path waves =
      std::filesystem::temp_directory_path() / ("cuesta-times-" + std::to_string(getpid()) + ".fst");
  const std::vector<std::string> machines = {"tiny", "mobile", "desktop"};
  ProgressBar bar(session, "wall times", "machines", machines.size());
  for (size_t k = 0; k < machines.size(); ++k) {
    if (!bar.update(k)) throw Error(ExitCode::kIncomplete, "Stopped while wall times were measured.");
    const Architecture machine = resolve_architecture(machines[k], {}, true).architecture;
    Architecture hardware = machine;
    hardware.units.hmt_top = Implementation::kRtl;
    const NumberFormat format = number_format(machine.traverse, job.map);
    std::vector<MachineRay> rays;
    for (const TracedRay& ray : job.trace.rays) rays.push_back(quantise(ray, job.map, format));
    const Workload work{&job.pyramid,
                        job.map,
                        rays,
                        job.pixel_of_ray,
                        job.trace.width,
                        job.trace.height,
                        parse_algorithm("yun2013").schedule};
    std::string hits;
    const auto add = [&](const char* level, const Run& run) {
      add_level(machines[k], level, run, hits, times);
    };
    add("functional", [&] { return run_functional(work, machine); });
    add("transaction", [&] { return run_transaction(work, machine); });
    add("cycle", [&] { return run_cycle(work, machine); });
    add("cycle in SystemC", [&] { return systemc.run(work, job.trace.rays, machine, {}); });
    add("rtl", [&] { return run_cycle(work, hardware); });
    add("rtl with waves", [&] {
      CycleHooks hooks;
      hooks.waves = {waves.string(), 0, 0, kWaveCycles - 1};
      return run_cycle_detailed(work, hardware, {}, hooks, nullptr);
    });
  }
  std::error_code ignored;
  std::filesystem::remove(waves, ignored);
  return times;
}

}  // namespace cuesta
