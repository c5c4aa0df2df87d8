#include <gtest/gtest.h>

#include "models/oracle/random_cases.h"
#include "models/oracle/traced_ray.h"
#include "models/oracle/verdict.h"

// The second question: the machine's answer against the ray as traced, in multiple-precision integers.

namespace cuesta {
namespace {

TEST(AsTraced, ARayThatTheGridHoldsExactlyIsNotChangedByQuantise) {
  // Sides of powers of two; origins on the grid, directions of small whole texels: nothing is rounded but heights,
  // whose full scale 2^B - 1 divides no power of two; so z is whole here.
  Random random(41);
  const NumberFormat format{.fraction_bits = 8, .direction_bits = 32, .mantissa_bits = 12, .tile_bits = 4};
  int hits = 0;
  for (int n = 0; n < 3000; ++n) {
    RandomMap map;
    map.grid = {8, 4, 1, {}};  // one bit: full scale is 1
    for (int k = 0; k < 32; ++k) map.grid.texels.push_back(static_cast<uint16_t>(random.below(2)));
    map.shape = {8, 4, 3, 1, static_cast<AddressMode>(random.below(4))};
    TracedRay ray;
    ray.origin[0] = static_cast<double>(random.between(0, 8 * 256)) / (8 * 256);
    ray.origin[1] = static_cast<double>(random.between(0, 4 * 256)) / (4 * 256);
    ray.origin[2] = static_cast<double>(random.between(0, 256)) / 256;
    ray.direction[0] = static_cast<double>(random.between(-8, 8)) / 8;
    ray.direction[1] = static_cast<double>(random.between(-8, 8)) / 4;
    ray.direction[2] = static_cast<double>(random.between(-8, 2)) / 16;
    if (ray.direction[0] == 0 && ray.direction[1] == 0 && ray.direction[2] == 0) continue;
    const MachineRay machine = quantise(ray, map.shape, format);
    const OracleMap surface = oracle_map(map.grid, map.shape);
    auto exact = *exact_traced_ray(ray, map.shape, format, machine.dead);
    exact.machine_units = machine_units_of(format, machine.exponent);
    const auto traced = oracle_leaf_walk(exact, surface);
    const auto input = exact_ray(machine, map.shape, format, OracleInput::kMachineInput);
    const auto quantised = oracle_leaf_walk(input, surface);
    ASSERT_EQ(traced.hit, quantised.hit) << describe(ray);
    if (!traced.hit) continue;
    ++hits;
    ASSERT_EQ(traced.i, quantised.i) << describe(ray);
    ASSERT_EQ(traced.j, quantised.j) << describe(ray);
    ASSERT_EQ(traced.face, quantised.face) << describe(ray);
    // The same time: T = t * 2^(f + D - 1 + M + q).
    ASSERT_DOUBLE_EQ(static_cast<double>(exact.in_machine_units(traced.t)),
                     static_cast<double>(input.in_machine_units(quantised.t)));
  }
  EXPECT_GT(hits, 1000);
}

}  // namespace
}  // namespace cuesta
