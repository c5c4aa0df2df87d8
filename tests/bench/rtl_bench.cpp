#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include "Vhmt_top_bench.h"
#include "Vhmt_top_bench___024root.h"
#include "models/common/elementary.h"
#include "models/common/random.h"
#include "models/heightmap/generator.h"
#include "sim/config/on_architecture.h"
#include "sim/hardware/verilated_hmt_top.h"
#include "sim/machine/cycle_machine.h"

// Simulated cycles per second of one thread: the machine, and the same machine with the Verilated hmt_top in the place
// of its units (mobile, no waves), and their ratio, per workload: rays that come down on the map or graze it; coherent
// (parallel, side by side) or random in place and azimuth; memory that answers quickly or slowly. Both runs count the
// same cycles, or the program stops. CPU time of this process, run by run; the table follows: of every row the median
// run and the best one, the one that its neighbours on the host disturbed least, and the ratio of the medians.

[[gnu::weak]] void Vhmt_top_bench___024root___eval_ico(Vhmt_top_bench___024root* root);
[[gnu::weak]] void Vhmt_top_bench___024root___eval_nba(Vhmt_top_bench___024root* root);

namespace cuesta {

namespace rtl {

/// The one set of this program: mobile without waves. It stands for the sets that are compiled for `cuesta`.
std::span<const RtlSet> rtl_sets() {
  static const RtlSet sets[] = {{"mobile",
                                 {CUESTA_BENCH_VALUES},
                                 [](int seed) -> std::unique_ptr<HmtTopPort> {
                                   return std::make_unique<VerilatedHmtTop<Vhmt_top_bench>>(
                                       rtl_sets()[0].parameters, seed,
                                       VerilatedRegions<Vhmt_top_bench>{Vhmt_top_bench___024root___eval_ico,
                                                                        Vhmt_top_bench___024root___eval_nba});
                                 },
                                 nullptr}};
  return sets;
}

}  // namespace rtl

namespace {

constexpr int kSide = 1024;     // texels
constexpr int kRaySide = 320;   // rays: its square
constexpr double kDepth = 0.1;  // of the slab, in tiles

double median(std::vector<double> of) {
  std::sort(of.begin(), of.end());
  return (of[(of.size() - 1) / 2] + of[of.size() / 2]) / 2;
}

struct Case {
  bool grazing, random, slow;
  std::vector<double> speeds[2] = {};  // cycles per second of each run: model, RTL
  int64_t cycles = 0;

  std::string name() const {
    return std::string(grazing ? "grazing" : "front") + (random ? "/random" : "/coherent") +
           (slow ? "/slow" : "/fast");
  }
  double ratio() const { return median(speeds[0]) / median(speeds[1]); }
  double best(bool rtl) const { return *std::max_element(speeds[rtl].begin(), speeds[rtl].end()); }
};

std::vector<MachineRay> rays_of(const Case& c, const MapShape& map, const NumberFormat& format) {
  Random random(5);
  const double angle = (c.grazing ? 80 : 30) * 3.14159265358979323846 / 180;
  std::vector<MachineRay> rays;
  for (uint32_t k = 0; k < kRaySide * kRaySide; ++k) {
    TracedRay ray;
    ray.id = k;
    const uint32_t row = k / kRaySide, column = k % kRaySide;
    ray.origin[0] = c.random ? random.unit() : (column + 0.5) / kRaySide;
    ray.origin[1] = c.random ? random.unit() : (row + 0.5) / kRaySide;
    ray.origin[2] = 1;
    const double turn = c.random ? random.unit() * 6.283185307179586 : 0.4;
    ray.direction[0] = elementary::sin(angle) * elementary::cos(turn);
    ray.direction[1] = elementary::sin(angle) * elementary::sin(turn);
    ray.direction[2] = -elementary::cos(angle) / kDepth;
    rays.push_back(quantise(ray, map, format));
  }
  return rays;
}

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void run(benchmark::State& state, Case& c, bool rtl) {
  static const Pyramid pyramid = build_max_pyramid(generate("fractal", kSide, kSide, 8, 1));
  const MapShape map{kSide, kSide, pyramid.root_level(), 8, AddressMode::kWrap};
  Architecture architecture;
  architecture.units.hmt_top = rtl ? Implementation::kRtl : Implementation::kModel;
  if (c.slow) {  // half the bus, and a hundred cycles there and back
    architecture.dram.bus_bytes = 4;
    architecture.dram.request_latency_cycles = architecture.dram.response_latency_cycles = 50;
  }
  const NumberFormat format = number_format(architecture.traverse, map);
  const std::vector<MachineRay> rays = rays_of(c, map, format);
  std::vector<uint32_t> pixels(rays.size());
  for (uint32_t k = 0; k < pixels.size(); ++k) pixels[k] = k;
  const Workload work{.pyramid = &pyramid,
                      .map = map,
                      .format = format,
                      .rays = rays,
                      .pixel_of_ray = pixels,
                      .width = kRaySide,
                      .height = kRaySide,
                      .schedule = find_algorithm("yun2013")->schedule};
  CycleHooks hooks;
  hooks.counters_only = true;
  for (auto _ : state) {
    const double begin = cpu_seconds();
    const Outcome outcome = run_cycle_detailed(work, architecture, {}, hooks, nullptr);
    const double seconds = cpu_seconds() - begin;
    const int64_t cycles = outcome.measurements.counters.get("machine.cycles");
    if (c.cycles != 0 && c.cycles != cycles)
      return state.SkipWithError("model and RTL differ in their cycles");
    c.cycles = cycles;
    c.speeds[rtl].push_back(static_cast<double>(cycles) / seconds);
  }
  state.counters["cycles/s"] = c.speeds[rtl].back();
}

/// Clock ticks of all processors since the host's start: what another guest took of them, and all; 0, 0 where the
/// system does not say.
struct HostTicks {
  double stolen = 0, all = 0;

  static HostTicks now() {
    HostTicks ticks;
    std::ifstream file("/proc/stat");
    std::string cpu;
    file >> cpu;
    constexpr int kStolen = 7, kColumns = 8;  // user, nice, system, idle, iowait, irq, softirq, steal
    double column = 0;
    for (int k = 0; k < kColumns && file >> column; ++k) {
      ticks.all += column;
      if (k == kStolen) ticks.stolen = column;
    }
    return ticks;
  }
};

void print_table(const std::vector<Case>& cases) {
  std::printf("\nSimulated Mcycles/s of one thread, hmt_top as mobile, no waves\n");
  std::printf("%-22s %9s %5s | model %6s %6s | RTL %6s %6s | %9s\n", "workload", "cycles", "runs", "median",
              "best", "median", "best", "model/RTL");
  std::vector<double> ratios, medians, bests;
  for (const Case& c : cases) {
    if (c.speeds[0].empty() || c.speeds[1].empty()) continue;  // filtered out, or failed
    medians.push_back(median(c.speeds[1]));
    bests.push_back(c.best(true));
    ratios.push_back(c.ratio());
    std::printf("%-22s %9lld %5zu | %12.2f %6.2f | %10.2f %6.2f | %9.2f\n", c.name().c_str(),
                static_cast<long long>(c.cycles), c.speeds[1].size(), median(c.speeds[0]) / 1e6,
                c.best(false) / 1e6, medians.back() / 1e6, bests.back() / 1e6, ratios.back());
  }
  if (ratios.empty()) return;
  std::printf(
      "model/RTL: median %.2f, worst %.2f; slowest row of the RTL: median %.2f, best %.2f Mcycles/s\n",
      median(ratios), *std::min_element(ratios.begin(), ratios.end()),
      *std::min_element(medians.begin(), medians.end()) / 1e6,
      *std::min_element(bests.begin(), bests.end()) / 1e6);
}

}  // namespace
}  // namespace cuesta

int main(int argc, char** argv) {
  std::vector<cuesta::Case> cases;
  for (const bool grazing : {false, true}) {
    for (const bool random : {false, true}) {
      for (const bool slow : {false, true}) cases.push_back({grazing, random, slow});
    }
  }
  for (cuesta::Case& c : cases) {
    for (const bool rtl : {false, true}) {
      benchmark::RegisterBenchmark(((rtl ? "rtl/" : "model/") + c.name()).c_str(),
                                   [&c, rtl](benchmark::State& state) { run(state, c, rtl); })
          ->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const auto before = cuesta::HostTicks::now();
  benchmark::RunSpecifiedBenchmarks();
  cuesta::print_table(cases);
  const auto after = cuesta::HostTicks::now();
  if (after.stolen > before.stolen) {
    std::printf("other guests of this host took %.0f %% of the processors' time\n",
                100 * (after.stolen - before.stolen) / (after.all - before.all));
  }
  return 0;
}
