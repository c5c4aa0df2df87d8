#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/config/architecture_file.h"
#include "sim/hosts/systemc/systemc_host.h"
#include "sim/session/measure.h"
#include "traces/scene_library.h"

// One simulation a process: each test is started in a process of its own.

namespace cuesta {
namespace {

/// Every built-in scene: the same digest from both hosts, one run after the other in one simulation.
void expect_equal_hosts(const std::string& preset, const std::vector<std::string>& settings) {
  const ResolvedArchitecture machine = resolve_architecture(preset, settings, true);
  SystemCHost host("", machine.architecture.machine.pipelines, false);
  SceneChanges changes;
  changes.size = {20, 20};
  const std::vector<Algorithm> all(algorithms().begin(), algorithms().end());
  size_t next = 0;
  for (const BuiltInScene& scene : built_in_scenes()) {
    const Job job = prepare_job(std::string(scene.name), changes);
    Measurer direct(job);
    Measurer systemc(
        job, [&](const Workload& work, std::span<const TracedRay> rays, const Architecture& architecture,
                 const Progress& progress) { return host.run(work, rays, architecture, progress); });
    for (int k = 0; k < 2; ++k) {
      const Algorithm& algorithm = all[next++ % all.size()];
      const RunEntry expected = direct.run(algorithm, machine.architecture, Fidelity::kCycle);
      const RunEntry found = systemc.run(algorithm, machine.architecture, Fidelity::kCycle);
      ASSERT_FALSE(expected.digest.empty());
      EXPECT_EQ(found.digest, expected.digest) << scene.name << ", " << algorithm.id;
      EXPECT_EQ(found.hits_digest, expected.hits_digest) << scene.name << ", " << algorithm.id;
    }
  }
}

TEST(SystemCHost, GivesTheDigestsOfTheDirectHostOnTiny) { expect_equal_hosts("tiny", {}); }
TEST(SystemCHost, GivesTheDigestsOfTheDirectHostOnMobile) { expect_equal_hosts("mobile", {}); }
TEST(SystemCHost, GivesTheDigestsOfTheDirectHostOnDesktop) { expect_equal_hosts("desktop", {}); }
TEST(SystemCHost, GivesTheDigestsOfTheDirectHostInFloat) {
  expect_equal_hosts("mobile", {"traverse.arithmetic=float", "machine.pipelines=3"});
}
TEST(SystemCHost, GivesTheDigestsOfTheDirectHostInDouble) {
  expect_equal_hosts("desktop", {"traverse.arithmetic=double", "ray_dispatch.assign=interleave"});
}
TEST(SystemCHost, GivesTheDigestsOfTheDirectHostWithManyChannelsAndOneMshr) {
  expect_equal_hosts("tiny", {"dram.channels=8", "height_l1.mshrs=1", "machine.clock_mhz=333",
                              "dram.request_latency_cycles=1", "dram.response_latency_cycles=1"});
}
TEST(SystemCHost, GivesTheDigestsOfTheDirectHostWithManyChannelsAndManyMshrs) {
  expect_equal_hosts("mobile", {"dram.channels=8", "height_l1.mshrs=64", "traverse.contexts=128",
                                "height_l1.size_bytes=1024", "dram.bus_bytes=2"});
}

}  // namespace
}  // namespace cuesta
