#include "sim/verify/oracle/oracle_check.h"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/sim/session/recording_observer.h"

namespace cuesta {
namespace {

OracleRequest small(int threads = 1) {
  OracleRequest request;
  request.rays = 2300;
  request.precision_rays = 1200;
  request.bilinear_rays = 1100;
  request.bilinear_exact_rays = 300;
  request.max_side = 16;
  request.seed = 3;
  request.threads = threads;
  return request;
}

auto numbers(const OracleCounts& c) {
  return std::tuple(c.traversal.maps, c.traversal.hits, c.traversal.comparisons, c.traversal.oracle_brute,
                    c.traversal.step_comparisons, c.free.rows[0].traced.of, c.lattice.rows[3].quantised.of,
                    c.walks.hits, c.borders.borders, c.exact.exact[0].times, c.exact.exact[1].largest_ulps);
}

TEST(OracleCheck, CountsEveryRayThatWasAskedForInEachPartOnAnyNumberOfThreads) {
  RecordingObserver observer;
  std::vector<OraclePart> parts;
  const OracleCounts one = check_oracle(small(), observer, [&](const OracleCounts& counts, OraclePart part) {
    parts.push_back(part);
    EXPECT_EQ(fault_of(counts, part, 3), "");
  });
  EXPECT_EQ(parts, (std::vector{OraclePart::kTraversal, OraclePart::kPrecision, OraclePart::kBilinear}));
  EXPECT_EQ(one.traversal.rays, 2300);
  EXPECT_EQ(one.free.rays, 960);
  EXPECT_EQ(one.lattice.rays, 240);
  EXPECT_EQ(one.walks.rays, 1100);
  EXPECT_EQ(one.borders.rays, 110);
  EXPECT_EQ(one.exact.rays, 300);
  EXPECT_EQ(one.rays(), 2300 + 1200 + 1100 + 110 + 300);
  EXPECT_EQ(one.comparisons(), one.traversal.comparisons + one.walks.comparisons);
  EXPECT_FALSE(one.stopped);
  EXPECT_EQ(observer.stages.size(), 6u);
  EXPECT_EQ(observer.stages[0], "verify oracle [rays 2300]");
  EXPECT_EQ(observer.open, 0);
  Observer silent;
  EXPECT_EQ(numbers(check_oracle(small(3), silent)), numbers(one));
}

TEST(OracleCheck, StoppedItKeepsTheBatchesThatAreDoneAndChecksNothingMore) {
  RecordingObserver observer("verify oracle");
  const OracleCounts counts = check_oracle(small(), observer);
  EXPECT_TRUE(counts.stopped);
  EXPECT_EQ(counts.traversal.rays, 1000);
  EXPECT_EQ(counts.rays(), 1000);
}

TEST(OracleCheck, AFaultOfAPartIsASentenceWithItsCountsAndTheSeed) {
  OracleCounts counts;
  for (const OraclePart part : {OraclePart::kTraversal, OraclePart::kPrecision, OraclePart::kBilinear})
    EXPECT_EQ(fault_of(counts, part, 1), "");
  counts.traversal.quad_errors = 4;
  EXPECT_EQ(fault_of(counts, OraclePart::kTraversal, 9),
            "0 mismatches, 0 endless walks, 0 oracle errors, 0 step errors, 4 quad errors and 0 lane errors "
            "with seed 9");
  EXPECT_EQ(fault_of(counts, OraclePart::kPrecision, 9), "");
  counts.lattice.rows[0].set_up.of[static_cast<size_t>(Verdict::kExact) + 1] = 2;
  EXPECT_EQ(fault_of(counts, OraclePart::kPrecision, 9),
            "2 fixed-point answers are not exact for the ray as set up, with seed 9");
  counts.borders.gaps = 1;
  EXPECT_EQ(fault_of(counts, OraclePart::kBilinear, 9),
            "on bilinear surfaces 0 mismatches, 0 endless walks, 0 borders on which two patches disagree and "
            "1 gaps, with seed 9");
}

}  // namespace
}  // namespace cuesta
