#include <gtest/gtest.h>

#include "models/common/random.h"
#include "sim/hosts/systemc/machine_clock.h"

namespace cuesta::systemc {
namespace {

TEST(MachineClock, DoesNotDrift) {
  // 333 MHz: 3003.003... ps a cycle; a second has 333 million cycles all the same.
  const MachineClock clock(333, sc_core::sc_time(7, sc_core::SC_NS));
  EXPECT_EQ(clock.time_of(0), sc_core::sc_time(7, sc_core::SC_NS));
  EXPECT_EQ(clock.time_of(1), sc_core::sc_time(7, sc_core::SC_NS) + sc_core::sc_time(3003, sc_core::SC_PS));
  EXPECT_EQ(clock.time_of(333'000'000),
            sc_core::sc_time(7, sc_core::SC_NS) + sc_core::sc_time(1, sc_core::SC_SEC));
}

TEST(MachineClock, ATimeBelongsToTheFirstCycleThatIsNotBeforeIt) {
  Random random(1);
  const sc_core::sc_time tick = sc_core::sc_time::from_value(1);
  for (const int mhz : {1, 333, 500, 533, 999, 1000}) {
    const MachineClock clock(mhz, sc_core::sc_time(1, sc_core::SC_US));
    for (int k = 0; k < 2000; ++k) {
      const Cycle cycle = random.between(1, int64_t{1} << 34);
      ASSERT_EQ(clock.cycle_from(clock.time_of(cycle)), cycle) << mhz;
      ASSERT_EQ(clock.cycle_from(clock.time_of(cycle) + tick), cycle + 1) << mhz;
      ASSERT_EQ(clock.cycle_from(clock.time_of(cycle) - tick), cycle) << mhz;
    }
  }
}

}  // namespace
}  // namespace cuesta::systemc
