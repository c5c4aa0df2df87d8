#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "models/units/ray_dispatch/dispatch_order.h"
#include "models/work/step_source.h"
#include "sim/config/architecture_file.h"
#include "sim/config/on_architecture.h"
#include "sim/machine/cycle_machine.h"
#include "sim/session/job.h"
#include "traces/scene_library.h"

// Fidelity transaction against cycle, in one process, one run after the other: error of the cycle estimate and of the
// traffic, and the wall time of each, over built-in scenes, published algorithms and machines.
//   transaction_bench [scene,... [machine:section.key=value:...,...]]

namespace cuesta {
namespace {

struct Timed {
  Outcome outcome;
  double seconds;
};

/// Of this process alone, so that what else the host does tells less.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Value alone: every ray's steps and lines, from which both fidelities begin.
double source_seconds(const Workload& work, const Architecture& machine) {
  const TexelLayout layout(machine.texels.layout, *work.pyramid);
  const std::vector<uint32_t> order = dispatch_order(
      work.pixel_of_ray, work.width, machine.ray_dispatch.order, machine.ray_dispatch.tile_size);
  const double start = cpu_seconds();
  StepSource source(work, layout, machine.height_l1.line_bytes, order);
  HitRecord hit;
  for (uint32_t ray = 0; ray < order.size(); ++ray) {
    source.steps(ray);
    source.finish(ray, hit);
  }
  return cpu_seconds() - start;
}

Timed timed(const Workload& work, const Architecture& machine, bool loosely) {
  CycleHooks hooks;
  hooks.counters_only = true;
  hooks.loosely_timed = loosely;
  const double start = cpu_seconds();
  Timed run{run_cycle_detailed(work, machine, {}, hooks, nullptr), 0};
  run.seconds = cpu_seconds() - start;
  return run;
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  for (size_t start = 0; start <= text.size();) {
    const size_t end = std::min(text.find(at, start), text.size());
    if (end > start) parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

void summarise(const char* what, std::vector<double> values) {
  if (values.empty()) return;
  std::sort(values.begin(), values.end());
  std::printf("%s: median %.3f, p90 %.3f, least %.3f, most %.3f over %zu\n", what, values[values.size() / 2],
              values[values.size() * 9 / 10], values.front(), values.back(), values.size());
}

}  // namespace

int bench(const std::vector<std::string>& scenes, const std::vector<std::string>& machines) {
  std::vector<double> error, traffic, speed, step_rate;
  double cycle_seconds = 0, loose_seconds = 0;
  std::printf(
      "scene algorithm machine | cycles error %% | reads error %% | hit rate | full no_ray stall %% | "
      "steps/cycle | ns/step value, cycle, transaction | ratio\n");
  for (const std::string& scene : scenes) {
    SceneChanges changes;
    const Job job = prepare_job(scene, changes);
    for (const std::string& named : machines) {
      std::vector<std::string> settings = split(named, ':');
      const std::string preset = settings.front();
      settings.erase(settings.begin());
      const Architecture machine = resolve_architecture(preset, settings, true).architecture;
      const NumberFormat format = number_format(machine.traverse, job.map);
      std::vector<MachineRay> rays;
      for (const TracedRay& ray : job.trace.rays) rays.push_back(quantise(ray, job.map, format));
      for (const Algorithm& algorithm : algorithms()) {
        const Workload work = workload_of(job, machine, rays, algorithm);
        const Timed cycle = timed(work, machine, false), loose = timed(work, machine, true);
        const Counters& c = cycle.outcome.measurements.counters;
        const Counters& l = loose.outcome.measurements.counters;
        const auto of = [](const Counters& counters, const char* statistic) {
          return static_cast<double>(counters.sum("traverse", statistic));
        };
        const double cycles = static_cast<double>(c.get("machine.cycles"));
        const double e = (static_cast<double>(l.get("machine.cycles")) / cycles - 1) * 100;
        const double reads = static_cast<double>(c.get("dram.reads"));
        const double t = (static_cast<double>(l.get("dram.reads")) / reads - 1) * 100;
        const double steps = of(c, "slots_step"), all = of(c, "cycles");
        error.push_back(std::abs(e));
        traffic.push_back(std::abs(t));
        speed.push_back(cycle.seconds / loose.seconds);
        step_rate.push_back(steps / loose.seconds / 1e6);
        cycle_seconds += cycle.seconds;
        loose_seconds += loose.seconds;
        std::printf("%s %s %s | %+.2f | %+.2f | %.4f | %.1f %.1f %.1f | %.3f | %.1f %.1f %.1f | %.2f\n",
                    scene.c_str(), algorithm.id.c_str(), named.c_str(), e, t,
                    static_cast<double>(c.sum("height_l1", "hits")) /
                        static_cast<double>(c.sum("height_l1", "accesses")),
                    of(c, "bubble_contexts_full") / all * 100, of(c, "bubble_no_ray") / all * 100,
                    of(c, "stall_hit_queue") / all * 100, steps / all,
                    source_seconds(work, machine) / steps * 1e9, cycle.seconds / steps * 1e9,
                    loose.seconds / steps * 1e9, cycle.seconds / loose.seconds);
        std::fflush(stdout);
      }
    }
  }
  summarise("error of machine.cycles, %", error);
  summarise("error of dram.reads, %", traffic);
  summarise("wall time of cycle over transaction", speed);
  summarise("steps of transaction, M/s", step_rate);
  std::printf("whole: cycle %.2f s, transaction %.2f s, ratio %.2f\n", cycle_seconds, loose_seconds,
              cycle_seconds / loose_seconds);
  return 0;
}

}  // namespace cuesta

int main(int argc, char** argv) {
  std::vector<std::string> scenes, machines = {"tiny", "mobile", "desktop"};
  for (const cuesta::BuiltInScene& scene : cuesta::built_in_scenes()) scenes.emplace_back(scene.name);
  if (argc > 1 && std::string(argv[1]) != "all") scenes = cuesta::split(argv[1], ',');
  if (argc > 2) machines = cuesta::split(argv[2], ',');
  return cuesta::bench(scenes, machines);
}
