#pragma once

#include <cstdint>

#include "models/common/counter_table.h"

namespace cuesta {

/// What only the whole machine has counted.
struct MachineCounts {
  int64_t cycles = 0;
};

inline constexpr CounterRow<MachineCounts> kMachineCounters[] = {
    {"machine.cycles", "cycles",
     "Cycles from reset to the acknowledgement of the last burst written; cold caches. With fidelity "
     "transaction an estimate: every unit in time, but rays look up the lines of up to 32 steps ahead of it.",
     &MachineCounts::cycles},
};

/// Histograms and planes of what time adds to a workload's value.
inline constexpr StatisticDefinition kTimeStatistics[] = {
    {"latency", "cycles", "Histogram over rays of the cycles from dispatch to completion."},
    {"plane.issue_slots", "cycles",
     "Slots of the traverse pipes that the pixel's rays used; empty slots and standstills belong to nobody."},
    {"plane.l1_misses", "lines", "Misses that the pixel's rays allocated."},
    {"plane.dram_read_bytes", "bytes",
     "Bytes of the lines whose misses the pixel's rays allocated; merged misses and later hits carry none."},
    {"plane.dram_write_bytes", "bytes", "Bytes of the bursts whose first record is the pixel's."},
    {"plane.dram_bus_clocks", "memory clocks",
     "Data-bus clocks of the requests that the pixel's rays caused."},
    {"plane.dram_row_activations", "activations",
     "Rows opened by the requests that the pixel's rays caused."},
    {"plane.latency", "cycles",
     "Cycles from dispatch to completion, summed over the pixel's rays; does not add up to the machine's "
     "cycles, as rays overlap."},
};

}  // namespace cuesta
