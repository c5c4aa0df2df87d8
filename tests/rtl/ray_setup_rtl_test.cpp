#include <gtest/gtest.h>
#include <verilated.h>

#include <deque>
#include <memory>
#include <sstream>

#include <vector>

#include "Vray_setup.h"
#include "models/common/random.h"
#include "models/oracle/random_cases.h"
#include "models/traversal/traversal.h"
#include "sim/hardware/verilated_unit.h"
#include "tests/twins/ray_setup_twin.h"

// rtl/ray_setup/ray_setup.sv against `start` of models/traversal/traversal.h for the value and against the ticking
// twin for the time, under random stalls on both ports.

namespace cuesta {
namespace {

using rtl::sign_extended;

using FixedWalk = Walk<FixedArithmetic, PlainAxis>;
using State = RayState<FixedArithmetic, PlainAxis>;

// What the RTL under test is compiled for: its defaults.
constexpr int kMaxLevel = 10, kQueueDepth = 8, kLatency = 24, kInterval = 4;
constexpr NumberFormat kFormat{8, 32, 12, 4};

RandomMap square_map(Random& random) {
  RandomMap map;
  map.seed = random.next();
  const int n = static_cast<int>(random.below(kMaxLevel + 1));
  map.kind = "square";
  map.shape = {1 << n, 1 << n, n, static_cast<int>(random.between(1, 8)),
               random.chance(0.5) ? AddressMode::kWrap : AddressMode::kBorder};
  map.format = kFormat;
  map.grid = {map.shape.width, map.shape.height, map.shape.bits, {}};
  map.grid.texels.resize(static_cast<size_t>(map.shape.width) * static_cast<size_t>(map.shape.height));
  for (uint16_t& height : map.grid.texels)
    height = static_cast<uint16_t>(random.between(0, map.shape.full_scale()));
  return map;
}

struct Bench {
  explicit Bench(int reset_seed) : rtl(&rtl::with_random_start(context, reset_seed)) {}

  VerilatedContext context;
  Vray_setup rtl;

  void reset() {
    rtl.rst_ni = 0;
    rtl.ray_valid_i = rtl.out_ready_i = 0;
    clock();
    rtl.rst_ni = 1;
  }
  void clock() {
    rtl.clk_i = 0;
    rtl.eval();
    rtl.clk_i = 1;
    rtl.eval();
  }
  void configure(const FixedWalk& walk) {
    rtl.cfg_root_level_i = static_cast<uint8_t>(walk.map.root_level);
    rtl.cfg_border_i = walk.map.address_mode == AddressMode::kBorder;
    rtl.cfg_start_i = static_cast<uint8_t>(walk.schedule.start);
    rtl.cfg_stop_level_i = static_cast<uint8_t>(walk.schedule.stop_level);
    rtl.cfg_t_end_i = static_cast<uint64_t>(walk.format.t_end);
    rtl.cfg_root_bound_i = static_cast<uint8_t>(walk.root_bound);
  }
  void offer(const MachineRay& ray) {
    rtl.ray_id_i = static_cast<uint32_t>(ray.id);
    rtl.ray_x0_i = static_cast<uint32_t>(ray.x0) & 0xFFFFFF;
    rtl.ray_y0_i = static_cast<uint32_t>(ray.y0) & 0xFFFFFF;
    rtl.ray_z0_i = static_cast<uint16_t>(ray.z0);
    rtl.ray_dx_i = static_cast<uint64_t>(ray.dx) & 0x1FFFFFFFF;
    rtl.ray_dy_i = static_cast<uint64_t>(ray.dy) & 0x1FFFFFFFF;
    rtl.ray_dz_i = static_cast<uint64_t>(ray.dz) & 0x1FFFFFFFF;
    rtl.ray_t_max_i = static_cast<uint64_t>(ray.t_max);
    rtl.ray_dead_i = ray.dead;
  }
};

/// The first field that differs, decoded; empty when none does.
std::string difference(const Vray_setup& rtl, const FixedWalk& walk, const MachineRay& ray) {
  State state{};
  const bool dead = start(walk, ray, state) == Visit::kMiss;
  std::ostringstream text;
  auto compare = [&](const char* field, int64_t want, int64_t got) {
    if (want != got && text.str().empty()) {
      text << field << ": model " << want << ", RTL " << got << " (0x" << std::hex << want << ", 0x" << got
           << ")";
    }
  };
  compare("id", static_cast<uint32_t>(ray.id), rtl.out_id_o);
  compare("dead", dead, rtl.out_dead_o);
  if (dead || !text.str().empty()) return text.str();
  auto line = [&](const char* name, const FixedArithmetic::PlaneTime& want, uint32_t m, int64_t offset,
                  int shift, bool still, bool falling_z) {
    const int64_t slope = static_cast<int64_t>(m) << kFormat.fraction_bits;
    compare(name, want.slope, falling_z ? -slope : slope);
    compare(name, want.offset, falling_z ? -offset : offset);
    compare(name, want.shift, shift);
    compare(name, want.limit < 0, still);
  };
  line("x", state.x, rtl.out_mx_o, sign_extended(rtl.out_ox_o, 38), rtl.out_ex_o, rtl.out_still_x_o, false);
  line("y", state.y, rtl.out_my_o, sign_extended(rtl.out_oy_o, 38), rtl.out_ey_o, rtl.out_still_y_o, false);
  line("z", state.z, rtl.out_mz_o, sign_extended(rtl.out_oz_o, 38), rtl.out_ez_o, rtl.out_still_z_o,
       !state.rising);
  compare("flip_x", state.gx.flip != 0, rtl.out_flip_x_o);
  compare("flip_y", state.gy.flip != 0, rtl.out_flip_y_o);
  compare("rising", state.rising, rtl.out_rising_o);
  compare("t_start", state.t_start, static_cast<int64_t>(rtl.out_t_start_o));
  compare("t_max", state.t_max, static_cast<int64_t>(rtl.out_t_max_o));
  if (state.rising) compare("t_root", state.t_root, static_cast<int64_t>(rtl.out_t_root_o));
  compare("level", state.level, rtl.out_level_o);
  compare("node_x", state.gx.node, sign_extended(rtl.out_node_x_o, 17));
  compare("node_y", state.gy.node, sign_extended(rtl.out_node_y_o, 17));
  return text.str();
}

/// Rays through model and RTL; the first difference as a text.
std::string run(uint64_t seed, int rays) {
  Random random(seed);
  const RandomMap map = square_map(random);
  Schedule schedule;
  schedule.start = static_cast<StartRule>(random.below(3));
  schedule.stop_level = random.chance(0.5)
                            ? 0
                            : static_cast<int>(random.below(static_cast<uint64_t>(map.shape.root_level) + 1));
  const int root_bound = static_cast<int>(random.between(0, map.shape.full_scale()));
  const FixedWalk walk(map.shape, map.format, schedule, root_bound);
  PortStalls stalls;
  stalls.seed = random.next();
  stalls.per_mille[static_cast<int>(Port::kDispatch)] = static_cast<uint16_t>(random.below(900));
  stalls.per_mille[static_cast<int>(Port::kSetup)] = static_cast<uint16_t>(random.below(950));

  std::vector<MachineRay> all;
  while (static_cast<int>(all.size()) < rays) {
    try {
      all.push_back(quantise(random_ray(random, map, all.size()), map.shape, map.format));
    } catch (const std::exception&) {
    }
  }
  RaySetupParameters parameters{kLatency, kInterval, kQueueDepth};
  twins::RaySetupTwin twin(parameters, 0, 0, stalls);
  Bench bench(static_cast<int>(seed));  // registers without reset start from random bits
  bench.configure(walk);
  bench.reset();
  for (size_t k = 0; k < all.size(); ++k) {  // all wait in front
    twin.receive(static_cast<int>(k), 0);
    twin.commit();
  }
  size_t entered = 0, left = 0;
  for (Cycle cycle = 0; left < all.size(); ++cycle) {
    bench.rtl.ray_valid_i = entered < all.size() && !stalls.blocked(Port::kDispatch, 0, cycle);
    if (entered < all.size()) bench.offer(all[entered]);
    const bool enters = twin.evaluate(cycle);
    const std::optional<int> offered = twin.offered(cycle);
    const bool take = offered && !stalls.blocked(Port::kSetup, 0, cycle);
    bench.rtl.out_ready_i = !stalls.blocked(Port::kSetup, 0, cycle);
    bench.rtl.clk_i = 0;
    bench.rtl.eval();
    auto at = [&](const std::string& what) {
      return "seed " + std::to_string(seed) + ", cycle " + std::to_string(cycle) + ", ray " +
             std::to_string(left) + ": " + what + "\n" + describe(map) + "\n" +
             describe(all[std::min(left, all.size() - 1)]);
    };
    if ((bench.rtl.ray_valid_i && bench.rtl.ray_ready_o) != enters)
      return at("a ray enters in one of the two");
    if (bench.rtl.out_valid_o != offered.has_value()) return at("a ray is offered by one of the two");
    if (take) {
      const std::string found = difference(bench.rtl, walk, all[left]);
      if (!found.empty()) return at(found);
      twin.take();
      ++left;
    }
    entered += enters;
    bench.clock();
    twin.commit();
  }
  return {};
}

TEST(RaySetupRtl, EqualsTheModelUnderRandomStalls) {
  int rays = 0;
  for (uint64_t seed = 1; rays < 200'000; ++seed) {
    const std::string found = run(seed, 500);
    if (!found.empty()) FAIL() << found;
    rays += 500;
  }
}

}  // namespace
}  // namespace cuesta
