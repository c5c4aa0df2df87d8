#pragma once

#include <cstdint>

namespace cuesta {

/// The first DRAM: channels of banks with one open row each, first come first served per bank, one data bus
/// per channel. tXXX are in memory clocks; memory clock : machine clock = clock_num : clock_den.
struct DramParameters {
  int channels = 1;
  int banks = 8;         ///< per channel
  int row_bytes = 2048;  ///< bytes of an open row
  int bus_bytes = 8;     ///< bytes per memory clock on a channel's data bus
  int tRCD = 11;         ///< activate to column command
  int tRP = 11;          ///< precharge to activate
  int tCL = 11;          ///< column command to first data
  int tRAS = 28;         ///< activate to precharge
  int clock_num = 8;     ///< memory clock = machine clock * clock_num / clock_den
  int clock_den = 5;
  int request_latency_cycles = 10;   ///< L1 or writer to the controller, machine cycles
  int response_latency_cycles = 10;  ///< controller to L1 or writer, machine cycles
};

}  // namespace cuesta
