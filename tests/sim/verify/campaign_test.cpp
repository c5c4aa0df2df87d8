#include "sim/verify/lockstep/campaign.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "sim/verify/lockstep/leave_difference.h"
#include "sim/verify/lockstep/own_case.h"
#include "tests/sim/session/recording_observer.h"
#include "tests/support/temporary_folder.h"

// Campaigns with the model on both sides: no hardware is needed, and what differs is known.

namespace cuesta {
namespace {

const std::array<LockstepSide, 2> kEqual{LockstepSide{"model", {}}, LockstepSide{"same", {}}};

/// The second side's seventh answer of an outside memory comes late.
const std::array<LockstepSide, 2> kLate{LockstepSide{"model", {}},
                                        LockstepSide{"late", [](LockstepMachine& m) {
                                                       if (!m.memory) return;
                                                       m.memory->late_request = 6;
                                                       m.memory->late_cycles = 50;
                                                     }}};

LockstepCampaign campaign_of(uint64_t rays, int workers = 1) {
  LockstepCampaign campaign;
  rtl::RtlSet set{};
  set.name = "default";
  const Architecture a;
  rtl::RtlParameters& p = set.parameters;
  p.setup_latency = a.ray_setup.latency_cycles;
  p.setup_interval = a.ray_setup.interval_cycles;
  p.setup_queue = a.ray_setup.queue_depth;
  p.stages = a.traverse.stages;
  p.contexts = a.traverse.contexts;
  p.fraction_bits = a.traverse.fraction_bits;
  p.direction_bits = a.traverse.direction_bits;
  p.mantissa_bits = a.traverse.mantissa_bits;
  p.tile_bits = a.traverse.tile_bits;
  p.size_bytes = a.height_l1.size_bytes;
  p.line_bytes = a.height_l1.line_bytes;
  p.ways = a.height_l1.ways;
  p.mshrs = a.height_l1.mshrs;
  p.max_level = 6;
  p.height_bits = 8;
  campaign.sets = {set};
  campaign.ray_count = rays;
  campaign.workers = workers;
  return campaign;
}

TEST(Campaign, EndsAtItsRaysAndCountsWhatItRan) {
  RecordingObserver observer;
  const LockstepReport report = run_campaign(campaign_of(900), kEqual, observer);
  EXPECT_GE(report.rays, 900u);
  EXPECT_LT(report.rays, 900u + 400u) << "one machine more than was needed";
  EXPECT_GE(report.machines, 3u);
  EXPECT_GT(report.requests, 0u);
  EXPECT_FALSE(report.failing);
  EXPECT_FALSE(report.stopped);
  EXPECT_EQ(observer.stages, std::vector<std::string>{"verify rtl [rays 900]"});
  EXPECT_EQ(observer.last_finished, report.rays);
}

TEST(Campaign, FindsTheSameFirstDifferenceWithAnyNumberOfWorkers) {
  Observer observer;
  const LockstepReport one = run_campaign(campaign_of(100000), kLate, observer);
  ASSERT_TRUE(one.differs());
  EXPECT_TRUE(one.failing->machine.memory) << "nothing else differs";
  const LockstepReport four = run_campaign(campaign_of(100000, 4), kLate, observer);
  ASSERT_TRUE(four.differs());
  EXPECT_EQ(four.failing->seed, one.failing->seed);
  EXPECT_EQ(four.rays, one.rays);
  EXPECT_EQ(four.machines, one.machines);
  EXPECT_EQ(first_difference(four.last, kLate), first_difference(one.last, kLate));
}

TEST(Campaign, StoppedItKeepsTheMachinesThatAreCompared) {
  RecordingObserver observer("verify rtl");
  const LockstepReport report = run_campaign(campaign_of(100000, 2), kEqual, observer);
  EXPECT_TRUE(report.stopped);
  EXPECT_EQ(report.machines, 2u);
}

TEST(LeaveDifference, LeavesASmallerCaseThatDiffersAsFilesAndAText) {
  RecordingObserver observer;
  const LockstepReport report = run_campaign(campaign_of(100000), kLate, observer);
  ASSERT_TRUE(report.differs());
  const SmallestDifference smallest = shrink_difference(report, kLate, observer);
  EXPECT_FALSE(smallest.result.equal());
  EXPECT_LE(smallest.shrunk.smallest.rays.size(), report.failing->rays.size());
  EXPECT_GT(smallest.shrunk.runs, 0);
  EXPECT_EQ(observer.remarks.size(), 1u);

  const TemporaryFolder place;
  ResultFolder folder = ResultFolder::create(place.path("d"), false);
  const std::string text = leave_difference(report, smallest, kLate, HardwareUnit::kTraverse, folder);
  EXPECT_NE(text.find("again: cuesta verify rtl " + place.path("d/scene.toml")), std::string::npos) << text;
  EXPECT_NE(text.find(" --unit traverse\n"), std::string::npos) << text;
  for (const char* name : {"scene.toml", "heights.png", "rays.rays", "architecture.toml"})
    EXPECT_TRUE(std::filesystem::exists(place.path(std::string("d/") + name))) << name;
  std::ifstream file(place.path("d/difference.txt"));
  const std::string left{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(left, describe(*report.failing) + first_difference(report.last, kLate) + text);
}

TEST(OwnCase, HasTheJobsRaysOnTheMachineUnderTheAlgorithm) {
  SceneChanges changes;
  changes.size = {9, 7};
  const Job job = prepare_job("grazing", changes);
  LockstepMachine machine;
  machine.register_seed = 5;
  const LockstepCase one = own_case(job, parse_algorithm("dda"), machine);
  EXPECT_EQ(one.rays.size(), job.trace.rays.size());
  EXPECT_EQ(one.width, 9);
  EXPECT_EQ(one.height, 7);
  EXPECT_EQ(one.machine.register_seed, 5);
  EXPECT_TRUE(one.machine.schedule.start == StartRule::kLeaf);
  EXPECT_EQ(one.pyramid->root_level(), job.map.root_level);
  Observer observer;
  const LockstepReport report = compare_case(one, kEqual, observer);
  EXPECT_EQ(report.rays, one.rays.size());
  EXPECT_EQ(report.machines, 1u);
  EXPECT_FALSE(report.failing);
}

TEST(OwnCase, WhatTheHardwareDoesNotHaveIsRefused) {
  SceneChanges changes;
  changes.size = {4, 4};
  const Job job = prepare_job("front", changes);
  EXPECT_THROW(own_case(job, parse_algorithm("relief"), {}), Error);
  EXPECT_THROW(own_case(job, parse_algorithm("dda:stop=" + std::to_string(job.map.root_level + 1)), {}),
               Error);
  PortStalls stalls;
  stalls.per_mille[static_cast<int>(Port::kSetup)] = 1;
  EXPECT_THROW(check_hardware_stalls(stalls, HardwareUnit::kHmtTop, "--stalls"), Error);
  check_hardware_stalls(stalls, HardwareUnit::kTraverse, "--stalls");
  EXPECT_EQ(parse_hardware_unit(std::string(name_of(HardwareUnit::kTraverse))), HardwareUnit::kTraverse);
}

}  // namespace
}  // namespace cuesta
