#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <string>

#include "models/common/random.h"
#include "models/oracle/random_cases.h"
#include "sim/cycle_machine.h"
#include "sim/rtl/rtl_set.h"
#include "tests/twins/random_machine.h"

// The machine with Verilated hardware in the place of its units against the machine as it is: every hit, every ray's
// completion cycle, every counter and plane, under random stalls on every port.

namespace cuesta::rtl {
namespace {

using twins::RandomMachine;

/// A random machine that the set can be.
RandomMachine machine_for(const RtlParameters& set, uint64_t seed) {
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
  const int n = static_cast<int>(random.below(static_cast<uint64_t>(std::min(set.max_level, 9)) + 1));
  const int side = 1 << n;
  map.shape = {side, side, n, static_cast<int>(random.between(set.height_bits > 8 ? 9 : 1, set.height_bits)),
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

std::string difference(RandomMachine machine, Implementation UnitParameters::*unit) {
  CycleDetail detail[2];
  Outcome outcome[2];
  CycleHooks hooks;
  hooks.stalls = machine.stalled ? &machine.stalls : nullptr;
  hooks.register_seed = static_cast<int>(machine.seed);
  for (const Implementation made : {Implementation::kModel, Implementation::kRtl}) {
    machine.architecture.units.*unit = made;
    const auto k = static_cast<size_t>(made);
    outcome[k] = run_cycle_detailed(machine.work(), machine.architecture, {}, hooks, &detail[k]);
  }
  for (size_t k = 0; k < machine.rays.size(); ++k) {
    if (outcome[0].hits[k] == outcome[1].hits[k] &&
        detail[0].timing[k].completed == detail[1].timing[k].completed) {
      continue;
    }
    auto text = [&](size_t which) {
      const HitRecord& h = outcome[which].hits[k];
      return "status " + std::to_string(static_cast<int>(h.status)) + ", face " +
             std::to_string(static_cast<int>(h.face)) + ", level " + std::to_string(h.stop_level) + ", i " +
             std::to_string(h.i) + ", j " + std::to_string(h.j) + ", t " + std::to_string(h.t) + ", steps " +
             std::to_string(h.steps) + ", completed in " + std::to_string(detail[which].timing[k].completed);
    };
    return "ray " + std::to_string(k) + " (" + describe(machine.rays[k]) + ")\n  model " + text(0) +
           "\n  RTL   " + text(1) + "\n" + twins::describe(machine);
  }
  const auto& counters = outcome[0].measurements.counters.all();
  for (const auto& [path, want] : counters) {
    const int64_t got = outcome[1].measurements.counters.get(path);
    if (want != got) {
      return path + ": model " + std::to_string(want) + ", RTL " + std::to_string(got) + "\n" +
             twins::describe(machine);
    }
  }
  return outcome[0].digest == outcome[1].digest ? "" : "the digests differ\n" + twins::describe(machine);
}

void compare(Implementation UnitParameters::*unit, int64_t rays) {
  if (const char* told = std::getenv("CUESTA_RTL_RAYS")) rays = std::stoll(told);
  for (const RtlSet& set : rtl_sets()) {
    int64_t compared = 0, machines = 0;
    for (uint64_t seed = 1; compared < rays; ++seed, ++machines) {
      const RandomMachine machine = machine_for(set.parameters, seed);
      const std::string found = difference(machine, unit);
      if (!found.empty()) FAIL() << set.name << ": " << found;
      compared += static_cast<int64_t>(machine.rays.size());
    }
    std::cout << set.name << ": " << compared << " rays on " << machines << " machines, no difference\n";
  }
}

TEST(HmtTopRtl, EqualsTheModelUnderRandomStalls) { compare(&UnitParameters::hmt_top, 20'000); }
TEST(TraverseRtl, EqualsTheModelUnderRandomStalls) { compare(&UnitParameters::traverse, 10'000); }

}  // namespace
}  // namespace cuesta::rtl
