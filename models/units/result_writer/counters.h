#pragma once

#include <cstdint>

#include "models/common/counter_table.h"

namespace cuesta {

/// What one result_writer has counted.
struct ResultWriterCounts {
  int64_t records = 0;
  int64_t bursts = 0;
  int64_t bytes = 0;
  int64_t last_acknowledged = -1;  ///< cycle; no statistic
};

inline constexpr CounterRow<ResultWriterCounts> kResultWriterCounters[] = {
    {"result_writer.records", "records", "Hit records taken from hit_queue.", &ResultWriterCounts::records},
    {"result_writer.bursts", "bursts", "Bursts written.", &ResultWriterCounts::bursts},
    {"result_writer.bytes", "bytes", "Bytes of the bursts written.", &ResultWriterCounts::bytes},
};

}  // namespace cuesta
