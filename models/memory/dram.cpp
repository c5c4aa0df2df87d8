#include "models/memory/dram.h"

#include <algorithm>

namespace cuesta {

namespace {

/// Numbers below 2^32, nearly all, divide in a third of the time.
uint64_t divide(uint64_t a, uint64_t b) {
  return (a | b) >> 32 == 0 ? static_cast<uint32_t>(a) / static_cast<uint32_t>(b) : a / b;
}

int64_t divide_up(int64_t a, int64_t b) {
  return static_cast<int64_t>(divide(static_cast<uint64_t>(a + b - 1), static_cast<uint64_t>(b)));
}

}  // namespace

Dram::Dram(const DramParameters& parameters, int granule_bytes)
    : parameters_(parameters),
      granule_bytes_(static_cast<uint64_t>(granule_bytes)),
      granules_per_row_(static_cast<uint64_t>(std::max(1, parameters.row_bytes / granule_bytes))),
      banks_(static_cast<size_t>(parameters.channels) * static_cast<size_t>(parameters.banks)),
      bus_free_(static_cast<size_t>(parameters.channels), 0) {}

Dram::Served Dram::serve(Cycle arrival, uint64_t address, int bytes, bool write) {
  const DramParameters& p = parameters_;
  const auto channels = static_cast<uint64_t>(p.channels), banks = static_cast<uint64_t>(p.banks);
  const uint64_t granule = divide(address, granule_bytes_);
  const uint64_t in_channel = divide(granule, channels);
  const uint64_t channel = granule - in_channel * channels;
  const uint64_t row_number = divide(in_channel, granules_per_row_);
  const uint64_t row_in_bank = divide(row_number, banks);
  Bank& bank = banks_[channel * banks + row_number - row_in_bank * banks];
  const auto row = static_cast<int64_t>(row_in_bank);

  Served served{};
  const int64_t t = divide_up(arrival * p.clock_num, p.clock_den);
  int64_t column = std::max(t, bank.ready);
  if (bank.row == row) {
    served.row = Row::kHit;
    ++counts_.row_hits;
  } else if (bank.row < 0) {
    served.row = Row::kClosed;
    ++counts_.row_misses;
    bank.activated = column;
    column += p.tRCD;
  } else {
    served.row = Row::kConflict;
    ++counts_.row_conflicts;
    const int64_t precharge = std::max(column, bank.activated + p.tRAS);
    bank.activated = precharge + p.tRP;
    column = bank.activated + p.tRCD;
  }
  bank.row = row;
  const int64_t data = std::max(column + p.tCL, bus_free_[channel]);
  served.bus_clocks = static_cast<int>(divide_up(bytes, p.bus_bytes));
  bus_free_[channel] = data + served.bus_clocks;
  bank.ready = data - p.tCL + served.bus_clocks;
  served.response = divide_up(bus_free_[channel] * p.clock_den, p.clock_num) + p.response_latency_cycles;

  counts_.bus_clocks += served.bus_clocks;
  (write ? counts_.writes : counts_.reads) += 1;
  (write ? counts_.write_bytes : counts_.read_bytes) += bytes;
  return served;
}

}  // namespace cuesta
