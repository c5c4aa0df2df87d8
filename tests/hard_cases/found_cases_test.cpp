#include "tests/hard_cases/found_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "models/common/error.h"
#include "sim/config/architecture_file.h"
#include "sim/explore/adversary/adversary_score.h"
#include "sim/session/job.h"
#include "tests/hard_cases/hard_check.h"

// What the adversary has found: as bad as it was, and no worse for any other algorithm's exactness.

namespace cuesta {
namespace {

HeightGrid grid_of(const Pyramid& pyramid) {
  HeightGrid grid{pyramid.width(0), pyramid.height(0), pyramid.bits(), {}};
  const size_t texels = static_cast<size_t>(grid.width) * static_cast<size_t>(grid.height);
  grid.texels.assign(pyramid.level(0), pyramid.level(0) + texels);
  return grid;
}

Maximise maximise_of(const FoundCase& found) {
  const auto names = maximise_names();
  return static_cast<Maximise>(std::find(names.begin(), names.end(), found.maximise) - names.begin());
}

TEST(FoundCases, ScoreWhatTheyScoredWhenTheyWereFound) {
  const std::vector<FoundCase> cases = found_cases();
  EXPECT_GT(cases.size(), 5u);
  for (const FoundCase& found : cases) {
    const Job job = prepare_job(found.folder + "/scene.toml", {});
    const Maximise maximise = maximise_of(found);
    const Architecture architecture =
        resolve_architecture(found.architecture, found.settings, maximise == Maximise::kCycles).architecture;
    const AdversaryScorer scorer(parse_algorithm(found.algorithm), architecture, job.map.address_mode,
                                 maximise);
    const AdversaryScore scored = scorer.score(grid_of(job.pyramid), job.trace.rays);
    EXPECT_EQ(scored.fault, "") << found.name;
    // Cycles are the machine's: they may become fewer.
    const double slack = maximise == Maximise::kCycles ? 0.25 * found.score : 1e-12;
    EXPECT_NEAR(scored.score, found.score, slack) << found.name;
  }
}

TEST(FoundCases, AreExactUnderEveryAlgorithmAndMode) {
  HardCounts counts;
  for (const FoundCase& found : found_cases()) {
    const Job job = prepare_job(found.folder + "/scene.toml", {});
    for (const AddressMode mode :
         {AddressMode::kBorder, AddressMode::kWrap, AddressMode::kMirror, AddressMode::kClamp}) {
      HardChecker checker(grid_of(job.pyramid), mode, {8, 32, job.map.bits + 4, 4}, true);
      ++counts.cases;
      for (const TracedRay& ray : job.trace.rays) {
        ++counts.rays;
        for (int level = 0; level <= job.map.root_level; ++level) checker.check_exact(ray, level, counts);
        checker.check_searches(ray, counts);
        checker.check_bilinear(ray, counts);
      }
    }
  }
  EXPECT_EQ(counts.faults(), 0) << counts.first_failure;
  std::printf("%s", describe(counts).c_str());
}

}  // namespace
}  // namespace cuesta
