#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "Vhmt_top_mobile.h"
#include "Vhmt_top_tiny.h"
#include "models/common/random.h"
#include "models/oracle/random_cases.h"
#include "sim/cycle_machine.h"
#include "tests/rtl/rtl_machine.h"

// rtl/hmt_top.sv in the machine's place of ray_setup, traverse and height_l1, with ticking twins around it, against
// the machine of sim/cycle_machine.cpp: every hit, every ray's completion cycle, every counter, under random
// stalls on every outer port.

namespace cuesta::rtl {
namespace {

using twins::RandomMachine;

/// A random machine that the set can be.
RandomMachine machine_for(const HmtTopSet& set, uint64_t seed) {
  RandomMachine machine = twins::random_machine(seed, 1);
  Random random(seed * 77 + 5);
  Architecture& a = machine.architecture;
  a.machine.pipelines = static_cast<int>(random.between(1, 2));
  a.ray_setup = {set.setup_latency, set.setup_interval, set.setup_queue};
  a.traverse.arithmetic = Arithmetic::kFixed;
  a.traverse.stages = set.stages;
  a.traverse.contexts = set.contexts;
  a.traverse.fraction_bits = set.fraction_bits;
  a.traverse.direction_bits = set.direction_bits;
  a.traverse.mantissa_bits = set.mantissa_bits;
  a.traverse.tile_bits = set.tile_bits;
  a.height_l1 = {set.size_bytes, set.line_bytes, set.ways, set.mshrs};
  a.texels.layout = random.chance(0.5) ? TexelLayoutKind::kRowMajor : TexelLayoutKind::kMorton;
  machine.stalls.per_mille[static_cast<int>(Port::kSetup)] = 0;  // inside hmt_top

  RandomMap map;
  map.kind = "square";
  const int n = static_cast<int>(random.below(static_cast<uint64_t>(set.max_level) + 1));
  const int side = 1 << n;
  map.shape = {side, side, n, static_cast<int>(random.between(1, set.height_bits)),
               random.chance(0.5) ? AddressMode::kWrap : AddressMode::kBorder};
  map.format = number_format(a.traverse, map.shape);
  map.grid.width = map.grid.height = side;
  map.grid.bits = map.shape.bits;
  const bool rough = random.chance(0.4);
  int64_t height = random.between(0, map.shape.full_scale());
  for (int k = 0; k < side * side; ++k) {
    height = rough ? random.between(0, map.shape.full_scale())
                   : std::clamp<int64_t>(height + random.between(-3, 3), 0, map.shape.full_scale());
    map.grid.texels.push_back(static_cast<uint16_t>(height));
  }
  machine.map = map.shape;
  machine.schedule.start = static_cast<StartRule>(random.below(3));
  machine.schedule.down = static_cast<int>(random.between(1, 3));
  machine.schedule.up = static_cast<UpRule>(random.below(8));
  machine.schedule.stop_level = random.chance(0.7) ? 0 : static_cast<int>(random.between(0, n));
  machine.schedule.fetch = FetchRule::kTexel;
  machine.pyramid = build_stopped_pyramid(build_max_pyramid(map.grid), machine.schedule.stop_level);
  machine.width = machine.height = 20;
  machine.rays.clear();
  machine.pixels.clear();
  const auto count = static_cast<size_t>(random.between(1, 400));
  TracedRay first;
  const bool bundled = random.chance(0.5);
  for (uint64_t k = 0; machine.rays.size() < count; ++k) {
    TracedRay ray = random_ray(random, map, k);
    if (k % 64 == 0) first = ray;
    if (bundled && k % 64 != 0) {
      ray = first;
      ray.id = k;
      if (ray.fixed_axis == FixedAxis::kNone) {
        ray.origin[0] += static_cast<double>(k % 8) * 0x1p-8;
        ray.origin[1] += static_cast<double>(k / 8 % 8) * 0x1p-8;
      }
    }
    try {
      machine.rays.push_back(quantise(ray, map.shape, map.format));
    } catch (const std::exception&) {
      first = random_ray(random, map, k);
      continue;
    }
    machine.pixels.push_back(static_cast<uint32_t>(machine.rays.size() - 1));
  }
  return machine;
}

std::string difference(const HmtTopSet& set, const MakeHmtTop& make, const RandomMachine& machine) {
  CycleDetail detail;
  CycleHooks hooks;
  hooks.stalls = machine.stalled ? &machine.stalls : nullptr;
  const Outcome model = run_cycle_detailed(machine.work(), machine.architecture, {}, hooks, &detail);
  const RtlRun rtl = RtlMachine(machine, set, make).run();
  for (size_t k = 0; k < machine.rays.size(); ++k) {
    if (model.hits[k] == rtl.hits[k] && detail.timing[k].completed == rtl.completed[k]) continue;
    auto text = [](const HitRecord& h, Cycle completed) {
      return "status " + std::to_string(static_cast<int>(h.status)) + ", face " +
             std::to_string(static_cast<int>(h.face)) + ", level " + std::to_string(h.stop_level) + ", i " +
             std::to_string(h.i) + ", j " + std::to_string(h.j) + ", t " + std::to_string(h.t) + ", steps " +
             std::to_string(h.steps) + ", completed in " + std::to_string(completed);
    };
    return "ray " + std::to_string(k) + " (" + describe(machine.rays[k]) + ")\n  model " +
           text(model.hits[k], detail.timing[k].completed) + "\n  RTL   " +
           text(rtl.hits[k], rtl.completed[k]) + "\n" + twins::describe(machine);
  }
  for (size_t p = 0; p < rtl.counters.size(); ++p) {
    for (size_t c = 0; c < std::size(kCounters); ++c) {
      const std::string path =
          std::string(kCounters[c][0]) + "[" + std::to_string(p) + "]." + kCounters[c][1];
      const int64_t want = model.measurements.counters.get(path);
      if (want != static_cast<int64_t>(rtl.counters[p][c])) {
        return path + ": model " + std::to_string(want) + ", RTL " + std::to_string(rtl.counters[p][c]) +
               "\n" + twins::describe(machine);
      }
    }
  }
  return {};
}

constexpr HmtTopSet kMobile{10, 8, 8, 32, 12, 4, 24, 4, 8, 8, 32, 16384, 64, 4, 8};
constexpr HmtTopSet kTiny{8, 8, 8, 32, 12, 4, 24, 8, 4, 8, 8, 2048, 32, 2, 2};

template <class V>
void compare(const HmtTopSet& set, int64_t rays) {
  if (const char* told = std::getenv("CUESTA_RTL_RAYS")) rays = std::stoll(told);
  int64_t compared = 0, machines = 0;
  for (uint64_t seed = 1; compared < rays; ++seed, ++machines) {
    const auto make = [&]() -> std::unique_ptr<HmtTopPort> {
      return std::make_unique<HmtTop<V>>(set, static_cast<int>(seed));
    };
    const RandomMachine machine = machine_for(set, seed);
    const std::string found = difference(set, make, machine);
    if (!found.empty()) FAIL() << found << "\nregisters without reset start from random bits, seed " << seed;
    compared += static_cast<int64_t>(machine.rays.size());
  }
  std::cout << compared << " rays on " << machines << " machines, no difference\n";
}

TEST(HmtTopRtl, MobileEqualsTheModelUnderRandomStalls) { compare<Vhmt_top_mobile>(kMobile, 20'000); }
TEST(HmtTopRtl, TinyEqualsTheModelUnderRandomStalls) { compare<Vhmt_top_tiny>(kTiny, 20'000); }

}  // namespace
}  // namespace cuesta::rtl
