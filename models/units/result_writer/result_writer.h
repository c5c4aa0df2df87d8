#pragma once

#include <cstdint>
#include <vector>

#include "models/units/hit_queue/hit_queue.h"
#include "models/units/memory/memory_port.h"
#include "models/units/ports/port_stalls.h"
#include "models/units/result_writer/counters.h"
#include "models/units/result_writer/parameters.h"

namespace cuesta {

/// result_writer: gathers hit records into bursts and writes them to memory.
///
/// Ports: records from hit_queue, bursts to dram, acknowledgements from dram; all registered.
/// Timing: takes one record a cycle while the burst buffer (burst_bytes / 32 records) was not full at the end of
/// the cycle before. A full buffer is sent in the first cycle in which fewer than `outstanding` bursts were
/// unacknowledged at the end of the cycle before; no record is taken in that cycle. The last, partly filled,
/// burst is sent when the pipeline has no ray left (`finish`).
class ResultWriter final : public MemoryClient {
 public:
  using Counts = ResultWriterCounts;

  /// Burst b of this pipeline goes to `base` + (b * pipelines + pipeline) * burst_bytes.
  ResultWriter(const ResultWriterParameters& parameters, uint64_t base, int pipelines, int pipeline,
               HitQueue& queue, MemoryPort& memory, const PortStalls* stalls);

  /// Does everything that happens in cycles below `limit`.
  void advance(Cycle limit) {
    while (step(limit) != Step::kNothing) {
    }
  }
  /// Goes on until a record has been popped; returns the cycle, or kNever when that is not below `limit`.
  Cycle advance_to_pop(Cycle limit) {
    for (;;) {
      const Step done = step(limit);
      if (done == Step::kNothing) return kNever;
      if (done == Step::kTook) return last_cycle_;
    }
  }
  /// Learns that no record comes any more: what is left may be sent from `cycle` on.
  void finish(Cycle cycle) { finish_from_ = cycle; }
  /// Says whether everything taken was sent and acknowledged.
  bool idle() const;

  /// Says whether nothing waits to be written or acknowledged; a burst may be partly filled.
  bool quiet() const { return queue_.empty() && filled_ < records_per_burst_ && unacknowledged() == 0; }

  void respond(int slot, Cycle response) override;
  void catch_up(Cycle limit) override { advance(limit); }

  const Counts& counts() const { return counts_; }
  int filled() const { return filled_; }
  int unacknowledged() const;

 private:
  enum class Step : uint8_t { kNothing, kTook, kSent };
  /// Does the next thing that happens, if it happens below `limit`.
  Step step(Cycle limit);
  Step send(Cycle limit, Cycle earliest);

  int records_per_burst_;
  int burst_bytes_;
  uint64_t base_;
  int pipelines_;
  int pipeline_;
  HitQueue& queue_;
  MemoryPort& memory_;
  const PortStalls* stalls_;
  std::vector<Cycle> acknowledged_;  ///< per outstanding burst: when; kNever: not known yet; -1: place unused
  int filled_ = 0;
  uint32_t first_ray_ = 0;  ///< of the burst: its owner
  Cycle last_cycle_ = -1;   ///< of the last take or send
  Cycle finish_from_ = kNever;
  Counts counts_;
};

}  // namespace cuesta
