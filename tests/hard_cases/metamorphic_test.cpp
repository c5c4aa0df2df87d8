#include "tests/hard_cases/metamorphic.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "models/oracle/checked_walks.h"
#include "models/oracle/oracle.h"
#include "models/oracle/verdict.h"

// When map and ray are changed together the hit moves as it must, bit for bit. A failing case is cut to the smallest
// map and ray. CUESTA_METAMORPHIC_CASES=N: N cases for each relation.

namespace cuesta {
namespace {

int64_t cases_wanted() {
  const char* text = std::getenv("CUESTA_METAMORPHIC_CASES");
  return text == nullptr ? 20000 : std::atoll(text);
}

/// Whether a relation fails on an instance, and how.
struct Trial {
  const Relation& relation;
  Arithmetic arithmetic;
  Schedule one, other;  ///< before and after
  uint64_t seed;

  /// Empty: it holds, or does not apply.
  std::string fault(const Instance& instance, bool* applied = nullptr) const {
    const HitRecord found = walk(instance, arithmetic, one);
    const auto moved = relation.move(instance, found, arithmetic, seed);
    if (!moved) return {};
    if (applied != nullptr) *applied = true;
    const HitRecord after = walk(moved->instance, arithmetic, other);
    if (!agree(relation, moved->expected, after)) {
      return "before: " + describe(found) + "\n  expected after: " + describe(moved->expected) +
             "\n  found after:    " + describe(after);
    }
    const HitRecord same = relation.steps_too ? walk(moved->instance, arithmetic, one) : found;
    if (same.steps == found.steps) return {};
    return "other steps by the same schedule: " + std::to_string(found.steps) + " and " +
           std::to_string(same.steps);
  }
};

void check(const Relation& relation) {
  const std::vector<Schedule> schedules = checked_schedules(true, 0);
  Random random(Random::mix(relation.name.size()) + 5);
  int64_t applied = 0, hits = 0;
  for (int64_t k = 0; applied < cases_wanted() && k < 40 * cases_wanted(); ++k) {
    const auto instance = random_instance(random, k % 4 == 0 ? 40 : 9);
    if (!instance) continue;
    const Trial trial{relation, static_cast<Arithmetic>(k % 3), schedules[random.below(schedules.size())],
                      schedules[random.below(schedules.size())], random.next() >> 8};
    bool counted = false;
    if (const std::string fault = trial.fault(*instance, &counted); !fault.empty()) {
      const Instance least = shrink(*instance, [&](const Instance& i) { return !trial.fault(i).empty(); });
      FAIL() << relation.name << " (" << relation.exact_in << "), " << describe(trial.one) << ", then "
             << describe(trial.other) << ", seed " << trial.seed << ", arithmetic "
             << static_cast<int>(trial.arithmetic) << "\n  " << describe(least) << "\n  "
             << trial.fault(least);
    }
    applied += counted;
    hits += counted && walk(*instance, trial.arithmetic, trial.one).status == HitStatus::kHit;
  }
  EXPECT_GE(applied, cases_wanted());
  EXPECT_GT(hits, applied / 4);
  std::printf("%s: %lld cases, %lld hits\n", std::string(relation.name).c_str(),
              static_cast<long long>(applied), static_cast<long long>(hits));
}

class Metamorphic : public ::testing::TestWithParam<size_t> {};

TEST_P(Metamorphic, TheHitMovesAsItMust) { check(relations()[GetParam()]); }

INSTANTIATE_TEST_SUITE_P(Relations, Metamorphic, ::testing::Range<size_t>(0, relations().size()),
                         [](const auto& test) {
                           std::string name(relations()[test.param].name);
                           for (char& letter : name) {
                             if (letter == ' ') letter = '_';
                           }
                           return name;
                         });

/// Rays on a plane that they never leave: the mirror image belongs to the cell on the plane's other side, so that the
/// two answers are each other's ties.
TEST(MetamorphicTies, AMirroredRayOnAPlaneIsRightUnderTheOtherReadingOfEdges) {
  Random random(9);
  int64_t checked = 0, moved = 0;
  while (checked < cases_wanted() / 4) {
    auto instance = random_instance(random, 9);
    if (!instance || instance->ray.dx != 0) continue;
    const int f = instance->format.fraction_bits, w = instance->grid.width;
    instance->ray.x0 = instance->ray.x0 >> f << f;
    const HitRecord here = walk(*instance, Arithmetic::kFixed, {});
    Instance image = *instance;
    for (int j = 0; j < image.grid.height; ++j) {
      for (int i = 0; i < w; ++i) image.grid.at(i, j) = instance->grid.at(w - 1 - i, j);
    }
    image.ray.x0 = (int64_t{w} << f) - instance->ray.x0;
    const HitRecord there = walk(image, Arithmetic::kFixed, {});
    const OracleMap map = oracle_map(image.grid, image.shape);
    const auto exact = exact_ray(image.ray, image.shape, image.format, OracleInput::kSetup);
    const auto truth = oracle_leaf_walk(exact, map);
    EXPECT_TRUE(same_answer(there, to_record(truth, image.ray.id, 0))) << describe(image);
    const bool hit = here.status == HitStatus::kHit;
    const Verdict verdict =
        judge(exact, map, truth, {hit, hit ? w - 1 - here.i : 0, here.j, static_cast<long double>(here.t)});
    EXPECT_TRUE(verdict == Verdict::kExact || verdict == Verdict::kTie)
        << name_of(verdict) << "\n  " << describe(image) << "\n  here " << describe(here) << "\n  there "
        << describe(there);
    moved += verdict == Verdict::kTie;
    ++checked;
  }
  EXPECT_GT(moved, checked / 10);
}

/// Higher ground is never hit later, and never lost.
TEST(MetamorphicOrder, RaisingAnyTexelNeverMakesTheHitLater) {
  const std::vector<Schedule> schedules = checked_schedules(true, 0);
  Random random(11);
  int64_t earlier = 0;
  for (int64_t k = 0; k < cases_wanted(); ++k) {
    const auto instance = random_instance(random, 12);
    if (!instance) continue;
    Instance higher = *instance;
    uint16_t& texel = higher.grid.texels[random.below(higher.grid.texels.size())];
    texel = static_cast<uint16_t>(random.between(texel, higher.grid.full_scale()));
    const auto fails = [&](const Instance& low, const Instance& high, int64_t* before) {
      const HitRecord a = walk(low, Arithmetic::kFixed, schedules[static_cast<size_t>(k) % schedules.size()]);
      const HitRecord b =
          walk(high, Arithmetic::kFixed, schedules[static_cast<size_t>(7 * k) % schedules.size()]);
      if (a.status != HitStatus::kHit) return false;
      if (before != nullptr) *before += b.status == HitStatus::kHit && b.t < a.t;
      return b.status != HitStatus::kHit || b.t > a.t;
    };
    ASSERT_FALSE(fails(*instance, higher, &earlier)) << describe(*instance) << "\nraised:\n"
                                                     << describe(higher);
  }
  EXPECT_GT(earlier, 0);
}

}  // namespace
}  // namespace cuesta
