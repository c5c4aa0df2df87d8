#include "models/units/dram/dram.h"

#include <algorithm>
#include <bit>

namespace cuesta {

namespace {

/// Numbers below 2^32, nearly all, divide in a third of the time.
uint64_t divide(uint64_t a, uint64_t b) {
  return (a | b) >> 32 == 0 ? static_cast<uint32_t>(a) / static_cast<uint32_t>(b) : a / b;
}

int shift_of(int power_of_two) { return std::countr_zero(static_cast<unsigned>(power_of_two)); }

int64_t divide_up(int64_t a, int64_t b) {
  return static_cast<int64_t>(divide(static_cast<uint64_t>(a + b - 1), static_cast<uint64_t>(b)));
}

}  // namespace

Dram::Dram(const DramParameters& parameters, int granule_bytes)
    : parameters_(parameters),
      granule_shift_(shift_of(granule_bytes)),
      channel_shift_(shift_of(parameters.channels)),
      row_shift_(shift_of(std::max(1, parameters.row_bytes / granule_bytes))),
      bank_shift_(shift_of(parameters.banks)),
      bus_shift_(shift_of(parameters.bus_bytes)),
      banks_(static_cast<size_t>(parameters.channels) * static_cast<size_t>(parameters.banks)),
      bus_free_(static_cast<size_t>(parameters.channels), 0) {}

Dram::Served Dram::serve(Cycle arrival, uint64_t address, int bytes, bool write) {
  const DramParameters& p = parameters_;
  const uint64_t granule = address >> granule_shift_;
  const uint64_t channel = granule & ((uint64_t{1} << channel_shift_) - 1);
  const uint64_t row_number = granule >> channel_shift_ >> row_shift_;
  Bank& bank = banks_[channel << bank_shift_ | (row_number & ((uint64_t{1} << bank_shift_) - 1))];
  const auto row = static_cast<int64_t>(row_number >> bank_shift_);

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
  served.bus_clocks = (bytes + p.bus_bytes - 1) >> bus_shift_;
  bus_free_[channel] = data + served.bus_clocks;
  bank.ready = data - p.tCL + served.bus_clocks;
  served.response = divide_up(bus_free_[channel] * p.clock_den, p.clock_num) + p.response_latency_cycles;

  counts_.bus_clocks += served.bus_clocks;
  (write ? counts_.writes : counts_.reads) += 1;
  (write ? counts_.write_bytes : counts_.read_bytes) += bytes;
  return served;
}

}  // namespace cuesta
