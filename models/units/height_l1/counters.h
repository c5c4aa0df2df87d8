#pragma once

#include <cstdint>

#include "models/common/counter_table.h"

namespace cuesta {

/// What one height_l1 has counted.
struct HeightL1Counts {
  int64_t accesses = 0;
  int64_t hits = 0;
  int64_t misses = 0;
  int64_t merges = 0;
  int64_t refused = 0;
  int64_t fills = 0;
  int64_t fill_bytes = 0;
  int64_t evictions = 0;
  int64_t unique_lines = 0;
  int64_t mshr_cycles = 0;
};

inline constexpr CounterRow<HeightL1Counts> kHeightL1Counters[] = {
    {"height_l1.accesses", "lookups",
     "Lookups: one per line access that traverse issues, replays left out, retries included.",
     &HeightL1Counts::accesses, 12},
    {"height_l1.hits", "lookups", "Lookups that found their line.", &HeightL1Counts::hits, 13},
    {"height_l1.misses", "lookups", "Lookups that missed and allocated an MSHR: lines requested from dram.",
     &HeightL1Counts::misses, 14},
    {"height_l1.merges", "lookups",
     "Lookups that missed and joined the MSHR of an earlier miss to the same line.", &HeightL1Counts::merges,
     15},
    {"height_l1.refused", "lookups",
     "Lookups that missed and found no free MSHR: the ray waits and looks up again.",
     &HeightL1Counts::refused, 16},
    {"height_l1.fills", "lines", "Lines that landed from dram.", &HeightL1Counts::fills, 17},
    {"height_l1.fill_bytes", "bytes", "Bytes of the lines that landed.", &HeightL1Counts::fill_bytes},
    {"height_l1.evictions", "lines", "Fills that replaced a line.", &HeightL1Counts::evictions, 18},
    {"height_l1.unique_lines", "lines",
     "Different lines ever requested by this cache: its compulsory misses.", &HeightL1Counts::unique_lines},
    {"height_l1.mshr_cycles", "MSHR cycles",
     "Sum over MSHRs of the cycles from allocation to the last waiter's replay.",
     &HeightL1Counts::mshr_cycles, 20},
};

}  // namespace cuesta
