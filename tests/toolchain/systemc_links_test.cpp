#include <gtest/gtest.h>

#include <cstdint>
#include <systemc>

namespace {

/// Counts the rising edges of its clock.
struct EdgeCounter : sc_core::sc_module {
  SC_HAS_PROCESS(EdgeCounter);
  explicit EdgeCounter(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    SC_METHOD(count);
    sensitive << clock.pos();
    dont_initialize();
  }
  void count() { ++edges; }

  sc_core::sc_in<bool> clock{"clock"};
  uint64_t edges = 0;
};

TEST(SystemC, KernelLinksAndCountsEveryEdgeOfAClock) {
  // Edges at 0, 10, ... 90 ns.
  sc_core::sc_clock clock("clock", 10, sc_core::SC_NS, 0.5, 0, sc_core::SC_NS, true);
  EdgeCounter counter("counter");
  counter.clock(clock);
  sc_core::sc_start(95, sc_core::SC_NS);
  EXPECT_EQ(counter.edges, 10u);
  EXPECT_EQ(sc_core::sc_time_stamp(), sc_core::sc_time(95, sc_core::SC_NS));
}

TEST(SystemC, AWarningOfTheKernelThrows) {
  EXPECT_THROW(SC_REPORT_WARNING("cuesta", "a warning"), sc_core::sc_report);
}

}  // namespace
