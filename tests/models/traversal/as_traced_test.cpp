#include <gtest/gtest.h>

#include "models/common/error.h"
#include "models/oracle/random_cases.h"
#include "models/oracle/verdict.h"
#include "tests/support/exact_traced_ray.h"

// The second question: the machine's answer against the ray as traced, in multiple-precision integers.

namespace cuesta {
namespace {

/// A ray without favourite places: lattice rays lie on planes only as far as a double does, so that their exact
/// answer is a matter of the last bit.
TracedRay plain_ray(Random& random) {
  TracedRay ray;
  for (int a = 0; a < 2; ++a) {
    ray.origin[a] = random.unit();
    ray.direction[a] = 2 * random.unit() - 1;
  }
  ray.origin[2] = random.chance(0.7) ? 1 : random.unit();
  ray.direction[2] = (random.chance(0.8) ? -1 : 1) * random.unit() * (random.chance(0.5) ? 1 : 0.1);
  return ray;
}

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
    map.shape = {8, 4, 3, 1, random.chance(0.5) ? AddressMode::kWrap : AddressMode::kBorder};
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
    const auto traced = oracle_leaf_walk(exact_traced_ray(ray, machine, map.shape, format), surface);
    const auto input = exact_ray(machine, map.shape, format, OracleInput::kMachineInput);
    const auto quantised = oracle_leaf_walk(input, surface);
    ASSERT_EQ(traced.hit, quantised.hit) << describe(ray);
    if (!traced.hit) continue;
    ++hits;
    ASSERT_EQ(traced.i, quantised.i) << describe(ray);
    ASSERT_EQ(traced.j, quantised.j) << describe(ray);
    ASSERT_EQ(traced.face, quantised.face) << describe(ray);
    // The same time: T = t * 2^(f + D - 1 + M + q).
    const auto exact = exact_traced_ray(ray, machine, map.shape, format);
    ASSERT_DOUBLE_EQ(static_cast<double>(exact.in_machine_units(traced.t)),
                     static_cast<double>(input.in_machine_units(quantised.t)));
  }
  EXPECT_GT(hits, 1000);
}

TEST(AsTraced, TheMachineFindsTheTracedRaysCellInAlmostEveryCase) {
  Random random(43);
  VerdictCounts setup, input;
  while (setup.total() < 4000) {
    RandomMap map = random_map(random.next(), 48);
    if (map.grid.bits < 8) continue;  // few bits of height, few of the reciprocal
    map.format = {
        .fraction_bits = 8, .direction_bits = 32, .mantissa_bits = map.grid.bits + 4, .tile_bits = 4};
    const OracleMap surface = oracle_map(map.grid, map.shape);
    for (int r = 0; r < 40; ++r) {
      const TracedRay ray = plain_ray(random);
      const MachineRay machine = quantise(ray, map.shape, map.format);
      const auto exact = exact_traced_ray(ray, machine, map.shape, map.format);
      const auto truth = oracle_leaf_walk(exact, surface);
      for (const OracleInput question : {OracleInput::kSetup, OracleInput::kMachineInput}) {
        const auto rounded = exact_ray(machine, map.shape, map.format, question);
        const auto found = oracle_leaf_walk(rounded, surface);
        const JudgedAnswer answer{found.hit, found.i, found.j, rounded.in_machine_units(found.t)};
        (question == OracleInput::kSetup ? setup : input).add(judge(exact, surface, truth, answer));
      }
    }
  }
  for (const VerdictCounts* counts : {&setup, &input}) {
    std::printf("%s:", counts == &setup ? "reciprocals rounded" : "origin and direction rounded");
    for (size_t k = 0; k < kVerdicts; ++k) {
      std::printf(" %s %lld", std::string(name_of(static_cast<Verdict>(k))).c_str(),
                  static_cast<long long>(counts->of[k]));
    }
    std::printf("\n");
    EXPECT_GE(counts->count(Verdict::kExact) + counts->count(Verdict::kTie), counts->total() * 99 / 100);
  }
}

}  // namespace
}  // namespace cuesta
