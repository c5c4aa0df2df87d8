#include "reports/quantities.h"

#include <gtest/gtest.h>

#include "tests/support/example_result.h"

namespace cuesta {
namespace {

RunEntry hand_made() {
  RunEntry run;
  run.machine = {{{"machine.pipelines", 2, ""},
                  {"machine.clock_mhz", 500, "MHz"},
                  {"height_l1.line_bytes", 64, "bytes"},
                  {"dram.channels", 2, ""},
                  {"dram.bus_bytes", 4, "bytes"},
                  {"dram.clock_num", 8, ""},  // 12.8 bytes per cycle at the peak
                  {"dram.clock_den", 5, ""}},
                 2};
  Counters& counters = run.measurements.counters;
  counters.set("machine.rays", 100);
  counters.set("machine.steps", 1250);
  counters.set("machine.cycles", 1000);
  counters.set("height_l1[0].hits", 30);
  counters.set("height_l1[1].hits", 60);
  counters.set("height_l1[0].accesses", 40);
  counters.set("height_l1[1].accesses", 80);
  counters.set("dram.read_bytes", 3000);
  counters.set("dram.write_bytes", 200);
  return run;
}

TEST(Quantities, CountersAreSummedOverTheInstancesOfTheirUnit) {
  EXPECT_EQ(counter_total(hand_made().measurements.counters, "height_l1.hits"), 90);
  EXPECT_EQ(counter_total(hand_made().measurements.counters, "height_l1.evictions"), std::nullopt);
}

TEST(Quantities, RatiosMatchWhatIsWorkedByHand) {
  const RunEntry run = hand_made();
  EXPECT_DOUBLE_EQ(*ratio(run, "steps_per_ray"), 12.5);
  EXPECT_DOUBLE_EQ(*ratio(run, "l1_hit_rate"), 0.75);
  EXPECT_DOUBLE_EQ(*ratio(run, "rays_per_second"), 5e7);  // 100 rays in 2 us
  EXPECT_DOUBLE_EQ(*ratio(run, "frames_per_second"), 5e5);
  EXPECT_DOUBLE_EQ(*ratio(run, "dram_bandwidth"), 1.6e9);   // 3200 bytes in 2 us
  EXPECT_DOUBLE_EQ(*ratio(run, "dram_utilisation"), 0.25);  // of 12800 bytes
}

TEST(Quantities, WhatWasNotCountedGivesNoRatio) {
  RunEntry run;
  run.measurements.counters.set("machine.rays", 0);
  run.measurements.counters.set("machine.steps", 3);
  EXPECT_TRUE(ratios_of(run).empty());
}

TEST(Quantities, EveryPartOfARatioHasADefinition) {
  auto is_derived = [](std::string_view name) {
    for (const DerivedQuantity& derived : derived_quantities()) {
      if (derived.name == name) return true;
    }
    return false;
  };
  for (const RatioDefinition& definition : ratio_definitions()) {
    for (std::string_view part : {definition.numerator, definition.denominator}) {
      EXPECT_TRUE(is_derived(part) || find_statistic(part) != nullptr) << definition.name << " uses " << part;
    }
  }
}

TEST(Quantities, IndexIsNotPartOfAName) {
  EXPECT_EQ(without_index("height_l1[12].misses"), "height_l1.misses");
  EXPECT_EQ(without_index("dram.reads"), "dram.reads");
}

TEST(Quantities, TheExamplesSlotsAddUpToItsCycles) {
  for (const RunEntry& run : tests::example_result().runs) {
    int64_t slots = 0;
    for (const auto& [path, value] : run.measurements.counters.all()) {
      const std::string name = without_index(path);
      const bool use = name.starts_with("traverse.slots_") || name.starts_with("traverse.bubble_") ||
                       name.starts_with("traverse.stall_");
      slots += use ? value : 0;
    }
    EXPECT_EQ(slots, counter_total(run.measurements.counters, "traverse.cycles"));
  }
}

}  // namespace
}  // namespace cuesta
