#pragma once

#include <cstdint>

#include "models/common/counter_table.h"

namespace cuesta {

/// What the machine has asked of dram, or of the memory outside in its place.
struct DramTraffic {
  int64_t reads = 0;
  int64_t writes = 0;
  int64_t read_bytes = 0;
  int64_t write_bytes = 0;
};

/// What dram itself knows beside that.
struct DramCounts : DramTraffic {
  int64_t row_hits = 0;
  int64_t row_misses = 0;
  int64_t row_conflicts = 0;
  int64_t bus_clocks = 0;
};

inline constexpr CounterRow<DramTraffic> kDramTraffic[] = {
    {"dram.reads", "requests", "Lines read for height_l1, one request each.", &DramTraffic::reads},
    {"dram.writes", "requests", "Bursts of hit records written, one request each.", &DramTraffic::writes},
    {"dram.read_bytes", "bytes", "Bytes of the lines read for height_l1.", &DramTraffic::read_bytes},
    {"dram.write_bytes", "bytes",
     "Bytes of the bursts of hit records; the last, partly filled burst counts whole.",
     &DramTraffic::write_bytes},
};

inline constexpr CounterRow<DramCounts> kDramCounters[] = {
    {"dram.row_hits", "requests", "Requests that found their row open.", &DramCounts::row_hits},
    {"dram.row_misses", "requests", "Requests that found no row open in their bank: activate only.",
     &DramCounts::row_misses},
    {"dram.row_conflicts", "requests",
     "Requests that found another row open in their bank: precharge and activate.",
     &DramCounts::row_conflicts},
    {"dram.bus_clocks", "memory clocks",
     "Clocks in which a channel's data bus carried data, over all channels.", &DramCounts::bus_clocks},
};

}  // namespace cuesta
