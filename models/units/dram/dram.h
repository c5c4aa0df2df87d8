#pragma once

#include <cstdint>
#include <vector>

#include "models/units/dram/counters.h"
#include "models/units/dram/parameters.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// dram, first form: channels of banks with one open row each; every request is served in the order of arrival,
/// as a function of what was served before. Reads and writes have the same timing; there is no refresh.
///
/// Ports: one request port (arrival order is the caller's duty), one response. Registered.
/// Timing, in memory clocks t = ceil(arrival * clock_num / clock_den): a request to the open row may issue its
/// column command when the bank is ready, a closed bank needs tRCD before, another open row tRP + tRCD and tRAS
/// since its activation. Data follow tCL later when the channel's bus is free and take ceil(bytes / bus_bytes)
/// clocks. The response leaves in cycle ceil(done * clock_den / clock_num) + response_latency_cycles.
/// Addresses: granules go round the channels, rows of a channel round its banks.
class Dram {
 public:
  enum class Row : uint8_t { kHit, kClosed, kConflict };
  struct Served {
    Cycle response;  ///< at the requester, machine cycles
    Row row;
    int bus_clocks;
  };
  using Counts = DramCounts;

  /// `granule_bytes`: a power of two, as the parameters in bytes, channels and banks are.
  Dram(const DramParameters& parameters, int granule_bytes);

  Served serve(Cycle arrival, uint64_t address, int bytes, bool write);

  const Counts& counts() const { return counts_; }
  /// Returns the bytes after which rows, channels and banks repeat.
  uint64_t stripe_bytes() const {
    return static_cast<uint64_t>(parameters_.row_bytes) * static_cast<uint64_t>(parameters_.channels) *
           static_cast<uint64_t>(parameters_.banks);
  }

 private:
  struct Bank {
    int64_t row = -1;  ///< -1: nothing open
    int64_t ready = 0;
    int64_t activated = 0;
  };

  DramParameters parameters_;
  // log2 of what is a power of two.
  int granule_shift_, channel_shift_, row_shift_, bank_shift_, bus_shift_;
  std::vector<Bank> banks_;        ///< channel-major
  std::vector<int64_t> bus_free_;  ///< per channel
  Counts counts_;
};

}  // namespace cuesta
