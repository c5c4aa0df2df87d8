#pragma once

#include <cstdint>

#include "models/common/counter_table.h"

namespace cuesta {

/// What one hit_queue has counted.
struct HitQueueCounts {
  int64_t pushes = 0;
  int64_t pops = 0;
  int64_t waited_cycles = 0;
  int64_t max_fill = 0;
};

inline constexpr CounterRow<HitQueueCounts> kHitQueueCounters[] = {
    {"hit_queue.pushes", "records", "Records pushed by traverse: completed rays.", &HitQueueCounts::pushes},
    {"hit_queue.pops", "records", "Records taken by result_writer.", &HitQueueCounts::pops},
    {"hit_queue.waited_cycles", "record cycles", "Sum over records of the cycles from push to pop.",
     &HitQueueCounts::waited_cycles},
    {"hit_queue.max_fill", "records",
     "Most records met by a push, itself included; pops of the same cycle not yet counted.",
     &HitQueueCounts::max_fill},
};

}  // namespace cuesta
