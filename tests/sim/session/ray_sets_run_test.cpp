#include <gtest/gtest.h>

#include <fstream>

#include "sim/session/measure.h"
#include "tests/support/temporary_folder.h"
#include "traces/ray_sets.h"

namespace cuesta {
namespace {

Job job_of(std::string_view kind, const std::string& mode, int count) {
  const TemporaryFolder folder;
  std::ofstream(folder.path("set.toml"))
      << "[heightmap]\ngenerate = { kind = \"rocks\", width = 48, height = 32 }\naddress_mode = \"" << mode
      << "\"\n[rays]\nset = \"" << kind << "\"\ncount = " << count << "\nseed = 5\n";
  return prepare_job(folder.path("set.toml"), {});
}

Architecture small_machine() {
  Architecture machine;
  machine.machine.pipelines = 2;
  machine.height_l1.size_bytes = 1024;
  return machine;
}

class EverySet : public ::testing::TestWithParam<const char*> {};

// The measurer itself holds each run against the laws and all algorithms against each other.
TEST_P(EverySet, GivesEveryAlgorithmTheSameHitsAtBothFidelities) {
  for (const RaySetKind& kind : ray_set_kinds()) {
    const Job job = job_of(kind.name, GetParam(), 1100);
    EXPECT_EQ(job.trace.rays.size(), 1100u);
    Measurer measurer(job);
    const Architecture machine = small_machine();
    for (const Algorithm& algorithm : algorithms()) {
      const RunEntry functional = measurer.run(algorithm, machine, Fidelity::kFunctional);
      const RunEntry cycle = measurer.run(algorithm, machine, Fidelity::kCycle);
      EXPECT_EQ(functional.hits_digest, cycle.hits_digest) << kind.name << " " << algorithm.id;
      EXPECT_GT(cycle.measurements.counters.get("machine.hits"), 0) << kind.name;
      EXPECT_GT(cycle.measurements.counters.get("machine.misses"), 0) << kind.name;
    }
  }
}

TEST_P(EverySet, GivesTheSameHitsInEveryDispatchOrderAndAnotherTime) {
  for (const RaySetKind& kind : ray_set_kinds()) {
    const Job job = job_of(kind.name, GetParam(), 3000);
    Measurer measurer(job);
    std::vector<RunEntry> runs;
    for (DispatchOrder order :
         {DispatchOrder::kScanline, DispatchOrder::kTile, DispatchOrder::kMorton, DispatchOrder::kHilbert}) {
      Architecture machine = small_machine();
      machine.ray_dispatch.order = order;
      runs.push_back(measurer.run(*find_algorithm("yun2013"), machine, Fidelity::kCycle));
      EXPECT_EQ(runs.back().hits_digest, runs.front().hits_digest) << kind.name;
      for (size_t k = 0; k + 1 < runs.size(); ++k) EXPECT_NE(runs[k].digest, runs.back().digest) << kind.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, EverySet, ::testing::Values("border", "wrap", "mirror", "clamp"),
                         [](const auto& mode) { return std::string(mode.param); });

}  // namespace
}  // namespace cuesta
