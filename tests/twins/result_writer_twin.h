#pragma once

#include <cstdint>
#include <optional>

#include "models/rays/hit.h"
#include "models/units/architecture.h"
#include "models/units/ports/port_stalls.h"
#include "tests/twins/hit_queue_twin.h"

namespace cuesta::twins {

/// result_writer: takes a record a cycle into a burst buffer, sends full bursts, and the last partial one when
/// its pipeline has nothing more to come.
class ResultWriterTwin {
 public:
  struct Burst {
    int64_t number;  ///< of this pipeline, from 0
    int owner;       ///< the first ray in it
    int records;
  };

  ResultWriterTwin(const ResultWriterParameters& parameters, int pipeline, const PortStalls& stalls)
      : records_per_burst_(parameters.burst_bytes / kHitRecordBytes),
        limit_(parameters.outstanding),
        pipeline_(pipeline),
        stalls_(stalls) {}

  /// `last`: nothing more comes to this pipeline's hit_queue, and it is empty. Returns the burst that leaves for
  /// dram in this cycle.
  std::optional<Burst> evaluate(Cycle cycle, HitQueueTwin& hit_queue, bool last) {
    if (filled_ < records_per_burst_ && !hit_queue.empty() &&
        !stalls_.blocked(Port::kResult, pipeline_, cycle)) {
      taken_ = hit_queue.head();
      hit_queue.pop();
    }
    const bool complete = filled_ == records_per_burst_ || (last && filled_ > 0);
    sends_ = complete && outstanding_ < limit_ && !stalls_.blocked(Port::kWrite, pipeline_, cycle);
    if (!sends_) return {};
    return Burst{bursts_, first_, filled_};
  }

  /// The acknowledgement of a burst lands in this cycle; several may.
  void acknowledge() { ++acknowledged_; }

  void commit() {
    if (sends_) {
      filled_ = 0;
      ++bursts_;
      ++outstanding_;
    }
    if (taken_ >= 0) {
      if (filled_ == 0) first_ = taken_;
      ++filled_;
      ++records_;
    }
    outstanding_ -= acknowledged_;
    sends_ = false;
    acknowledged_ = 0;
    taken_ = -1;
  }

  bool idle() const { return filled_ == 0 && outstanding_ == 0; }
  int64_t bursts() const { return bursts_; }
  int64_t records() const { return records_; }

 private:
  int records_per_burst_;
  int limit_;
  int pipeline_;
  const PortStalls& stalls_;
  int filled_ = 0;
  int first_ = -1;
  int outstanding_ = 0;
  int64_t bursts_ = 0, records_ = 0;
  int taken_ = -1;
  bool sends_ = false;
  int acknowledged_ = 0;
};

}  // namespace cuesta::twins
