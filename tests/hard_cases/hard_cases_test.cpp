#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "models/common/error.h"
#include "tests/hard_cases/hard_cases.h"
#include "tests/hard_cases/hard_check.h"

// Every algorithm over the catalogue. CUESTA_HARD_EVERY=N: one ray in N; 1: all. CUESTA_HARD_ROUNDS=N: N times the
// rays, each round from other places.

namespace cuesta {
namespace {

int64_t number_from(const char* variable, int64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::max<int64_t>(1, std::atoll(text));
}

#ifdef __SANITIZE_ADDRESS__
constexpr bool kSlow = true;
constexpr int64_t kEvery = 24;
#else
constexpr bool kSlow = false;
constexpr int64_t kEvery = 3;
#endif

constexpr AddressMode kModes[] = {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kMirror,
                                  AddressMode::kClamp};

bool may_lie_beyond(const Error& error) {
  return std::string(error.what()).find("lies outside the") != std::string::npos;
}

/// One family of rays on one map: `check(ray)` throws where the ray does not fit.
template <class Check>
void run_family(const HardRays& family, const HardPlace& place, uint64_t seed, HardCounts& counts,
                Check&& check) {
  const int64_t every = &family == &far_rays() ? 1 : number_from("CUESTA_HARD_EVERY", kEvery);
  const int64_t rounds = number_from("CUESTA_HARD_ROUNDS", 1);
  Random random(seed);
  ++counts.cases;
  for (int64_t round = 0; round < rounds; ++round) {
    std::vector<TracedRay> rays;
    family.make(random, place, rays);
    for (size_t k = 0; k < rays.size(); ++k) {
      if ((static_cast<int64_t>(k) + counts.cases) % every != 0) continue;
      try {
        const int64_t hits = counts.hits, runs = counts.runs;
        check(rays[k]);
        if (counts.runs == runs) continue;  // nothing of this kind on this map
        ++counts.rays;
        EXPECT_NE(static_cast<int>(family.expected), static_cast<int>(Expected::kRefused))
            << family.name << ", ray " << k << ": " << describe(rays[k]);
        if (family.expected == Expected::kMiss)
          EXPECT_EQ(counts.hits, hits) << family.name << ": " << describe(rays[k]);
      } catch (const Error& error) {
        ++counts.refused;
        const std::string sentence = error.what();
        EXPECT_TRUE(family.expected == Expected::kRefused || may_lie_beyond(error))
            << family.name << ": " << sentence;
        EXPECT_NE(sentence.find("ray "), std::string::npos) << sentence;
      }
    }
  }
}

/// Prints where the leaf walk in an arithmetic is not exact for the ray as quantised: rounding alone.
class ByFamily {
 public:
  void add(const HardRays& family, const HardCounts& counts) {
    for (size_t a = 0; a < std::size(kRows); ++a) {
      const auto row = counts.rows.find(kRows[a]);
      if (row == counts.rows.end()) continue;
      for (size_t v = 0; v < kVerdicts; ++v) {
        const int64_t now = row->second.verdicts.of[v];
        of_[family.name][a].of[v] += now - before_[a].of[v];
        before_[a].of[v] = now;
      }
    }
  }
  void print() const {
    for (const auto& [name, rows] : of_) {
      for (size_t a = 0; a < std::size(kRows); ++a) {
        const VerdictCounts& row = rows[a];
        if (row.total() == row.count(Verdict::kExact)) continue;
        std::printf("%-28s %s: of %lld, tie %lld, missed %lld, behind %lld, wrong cell %lld\n",
                    std::string(name).c_str(), kRows[a], static_cast<long long>(row.total()),
                    static_cast<long long>(row.count(Verdict::kTie)),
                    static_cast<long long>(row.count(Verdict::kMissed)),
                    static_cast<long long>(row.count(Verdict::kBehind)),
                    static_cast<long long>(row.count(Verdict::kWrongCell)));
      }
    }
  }

 private:
  static constexpr const char* kRows[] = {"dda fixed", "dda float", "dda double"};
  std::array<VerdictCounts, 3> before_;
  std::map<std::string_view, std::array<VerdictCounts, 3>> of_;
};

void expect_no_fault(const HardCounts& counts) {
  EXPECT_EQ(counts.faults(), 0) << counts.first_failure;
  std::printf("%s", describe(counts).c_str());
}

/// Every map in every mode and number format under every family; `check(checker, ray, counts)`.
template <class Check>
HardCounts over_the_catalogue(bool with_searches, Check&& check) {
  HardCounts counts;
  ByFamily by_family;
  uint64_t seed = 1;
  for (const HardMap& map : hard_maps()) {
    for (const AddressMode mode : kModes) {
      MapShape shape;
      shape.bits = map.make().bits;
      for (const HardNumbers& numbers : hard_numbers()) {
        const NumberFormat format = numbers.of(shape);
        HardChecker checker(map.make(), mode, format, with_searches);
        for (const HardRays& family : hard_rays()) {
          run_family(family, {checker.grid(), checker.shape(), format}, seed++, counts,
                     [&](const TracedRay& ray) { check(checker, ray, counts); });
          if (counts.faults() > 0) return counts;
          by_family.add(family, counts);
        }
      }
    }
  }
  by_family.print();
  return counts;
}

TEST(HardCases, ExactAlgorithmsFindWhatExactArithmeticFinds) {
  const HardCounts counts = over_the_catalogue(
      false,
      [](HardChecker& checker, const TracedRay& ray, HardCounts& all) { checker.check_exact(ray, 0, all); });
  expect_no_fault(counts);
  // Of doubles one ray in 10,000 at most may see an edge otherwise; all conventions are theirs as well.
  const VerdictCounts& verdicts = counts.rows.at("dda double").verdicts;
  EXPECT_LE(verdicts.total() - verdicts.count(Verdict::kExact), 1 + verdicts.total() / 10000);
}

TEST(HardCases, ApproximateAlgorithmsEndAndKeepWhatTheyPromise) {
  expect_no_fault(over_the_catalogue(true, [](HardChecker& checker, const TracedRay& ray,
                                              HardCounts& counts) { checker.check_searches(ray, counts); }));
}

TEST(HardCases, EveryScheduleFindsTheSameBilinearSurface) {
  expect_no_fault(over_the_catalogue(false, [](HardChecker& checker, const TracedRay& ray,
                                               HardCounts& counts) { checker.check_bilinear(ray, counts); }));
}

TEST(HardCases, EveryLevelOfDetailIsExact) {
  int64_t asked = 0;
  expect_no_fault(
      over_the_catalogue(false, [&](HardChecker& checker, const TracedRay& ray, HardCounts& counts) {
        if (checker.shape().root_level == 0) return;
        const int64_t level = 1 + asked++ % checker.shape().root_level;
        checker.check_exact(ray, static_cast<int>(level), counts);
      }));
}

TEST(HardCases, AMillionTilesAreWalkedToTheirEnd) {
  HardCounts counts;
  const std::pair<std::string_view, AddressMode> places[] = {{"one texel at 0", AddressMode::kWrap},
                                                             {"one texel", AddressMode::kMirror},
                                                             {"one texel", AddressMode::kBorder}};
  for (const auto& [name, mode] : places) {
    const auto maps = hard_maps();
    const auto map = std::find_if(maps.begin(), maps.end(), [&](const HardMap& m) { return m.name == name; });
    ASSERT_NE(map, maps.end());
    MapShape shape;
    shape.bits = map->make().bits;
    const NumberFormat format = far_numbers().of(shape);
    HardChecker checker(map->make(), mode, format, true);
    run_family(far_rays(), {checker.grid(), checker.shape(), format}, 5, counts, [&](const TracedRay& ray) {
      if (ray.id > 0 && (kSlow || mode == AddressMode::kMirror)) return;
      if (kSlow && mode != AddressMode::kWrap) return;
      checker.check_exact(ray, 0, counts);
      if (ray.id > 0) return;
      checker.check_searches(ray, counts);
      checker.check_bilinear(ray, counts);
    });
  }
  expect_no_fault(counts);
}

TEST(HardCases, TheLargestMapIsExact) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "half a GiB of texels: optimised builds only";
#endif
  // Low ground, and a spike in one texel of 65536, as cheap to make as to store.
  HeightGrid grid{16384, 16384, 16, {}};
  grid.texels.reserve(size_t{16384} * 16384);
  for (uint32_t k = 0; k < 16384u * 16384u; ++k) {
    const uint32_t mixed = (k ^ (k >> 13)) * 0x9E3779B1u;
    grid.texels.push_back(static_cast<uint16_t>((mixed & 0xFFFF0000u) == 0 ? 65535 : mixed >> 26));
  }
  HardCounts counts;
  const NumberFormat format{8, 32, 20, 1};
  HardChecker checker(std::move(grid), AddressMode::kWrap, format, false);
  uint64_t seed = 1;
  for (const HardRays& family : hard_rays()) {
    run_family(family, {checker.grid(), checker.shape(), format}, seed++, counts, [&](const TracedRay& ray) {
      if (seed++ % 4 == 0) checker.check_exact(ray, 0, counts);
    });
  }
  expect_no_fault(counts);
}

}  // namespace
}  // namespace cuesta
