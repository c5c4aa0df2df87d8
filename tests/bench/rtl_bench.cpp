#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include "Vhmt_top_bench.h"
#include "Vhmt_top_bench___024root.h"
#include "models/common/elementary.h"
#include "models/common/random.h"
#include "models/heightmap/generator.h"
#include "sim/cycle_machine.h"
#include "sim/rtl/verilated_hmt_top.h"

// Simulated cycles per second of one thread: the machine, and the same machine with the Verilated hmt_top in the place
// of its units (mobile, no waves), and their ratio, per workload: rays that come down on the map or graze it; coherent
// (parallel, side by side) or random in place and azimuth; memory that answers quickly or slowly. Both runs count the
// same cycles, or the program stops. CPU time of this process; the table follows the runs.

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

struct Case {
  bool grazing, random, slow;
  double cycles_per_second[2] = {};  // model, RTL
  int64_t cycles = 0;

  std::string name() const {
    return std::string(grazing ? "grazing" : "front") + (random ? "/random" : "/coherent") +
           (slow ? "/slow" : "/fast");
  }
  double ratio() const { return cycles_per_second[0] / cycles_per_second[1]; }
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
  const std::vector<MachineRay> rays = rays_of(c, map, number_format(architecture.traverse, map));
  std::vector<uint32_t> pixels(rays.size());
  for (uint32_t k = 0; k < pixels.size(); ++k) pixels[k] = k;
  const Workload work{&pyramid, map, rays, pixels, kRaySide, kRaySide, find_algorithm("yun2013")->schedule};
  CycleHooks hooks;
  hooks.counters_only = true;
  double seconds = 0;
  int64_t all = 0;
  for (auto _ : state) {
    const double begin = cpu_seconds();
    const Outcome outcome = run_cycle_detailed(work, architecture, {}, hooks, nullptr);
    seconds += cpu_seconds() - begin;
    const int64_t cycles = outcome.measurements.counters.get("machine.cycles");
    if (c.cycles != 0 && c.cycles != cycles)
      return state.SkipWithError("model and RTL differ in their cycles");
    c.cycles = cycles;
    all += cycles;
  }
  c.cycles_per_second[rtl] = static_cast<double>(all) / seconds;
  state.counters["cycles/s"] = c.cycles_per_second[rtl];
}

void print_table(const std::vector<Case>& cases) {
  std::printf("\nSimulated Mcycles/s of one thread, hmt_top as mobile, no waves\n");
  std::printf("%-24s %10s %8s %8s %10s\n", "workload", "cycles", "model", "RTL", "model/RTL");
  std::vector<double> ratios;
  double slowest = 0;
  for (const Case& c : cases) {
    if (c.cycles_per_second[0] == 0 || c.cycles_per_second[1] == 0) continue;  // filtered out, or failed
    std::printf("%-24s %10lld %8.2f %8.2f %10.2f\n", c.name().c_str(), static_cast<long long>(c.cycles),
                c.cycles_per_second[0] / 1e6, c.cycles_per_second[1] / 1e6, c.ratio());
    ratios.push_back(c.ratio());
    if (slowest == 0 || c.cycles_per_second[1] < slowest) slowest = c.cycles_per_second[1];
  }
  if (ratios.empty()) return;
  std::sort(ratios.begin(), ratios.end());
  const size_t n = ratios.size();
  std::printf("model/RTL: median %.2f, worst %.2f; slowest RTL %.2f Mcycles/s\n",
              (ratios[(n - 1) / 2] + ratios[n / 2]) / 2, ratios.front(), slowest / 1e6);
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
  benchmark::RunSpecifiedBenchmarks();
  cuesta::print_table(cases);
  return 0;
}
