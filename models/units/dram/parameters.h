#pragma once

#include <cstdint>
#include <string_view>

#include "models/units/parameter_table.h"

namespace cuesta {

/// The sizes and timing of dram: channels of banks with one open row each, served in the order of arrival, with one
/// data bus per channel. tXXX are in memory clocks; memory clock : machine clock = clock_num : clock_den.
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

namespace parameter {

inline constexpr std::string_view kDatasheet =
    "ours; the default is DDR3-1600 11-11-11 (JEDEC JESD79-3) at 800 MHz";

inline constexpr ParameterRow<DramParameters> kDramParameters[] = {
    power<&DramParameters::channels>("dram.channels", 1, 16, "",
                                     "Channels, each with its banks and data bus.", kOurs),
    power<&DramParameters::banks>("dram.banks", 1, 64, "", "Banks of a channel, each with one open row.",
                                  kDatasheet),
    power<&DramParameters::row_bytes>("dram.row_bytes", 256, 65'536, "bytes",
                                      "Bytes of an open row, over all chips of a channel.", kDatasheet),
    power<&DramParameters::bus_bytes>(
        "dram.bus_bytes", 1, 64, "bytes",
        "Bytes that a channel's data bus moves in one memory clock: twice its width for double data rate.",
        kDatasheet),
    number<&DramParameters::tRCD>("dram.tRCD", 1, 255, kTime, "memory clocks",
                                  "Row activation to column command.", kDatasheet),
    number<&DramParameters::tRP>("dram.tRP", 1, 255, kTime, "memory clocks",
                                 "Precharge to activation of the next row.", kDatasheet),
    number<&DramParameters::tCL>("dram.tCL", 1, 255, kTime, "memory clocks",
                                 "Column command to the first data.", kDatasheet),
    number<&DramParameters::tRAS>("dram.tRAS", 1, 1023, kTime, "memory clocks",
                                  "Row activation to precharge.", kDatasheet),
    number<&DramParameters::clock_num>("dram.clock_num", 1, 64, kTime, "",
                                       "Memory clock = machine clock * clock_num / clock_den.", kOurs),
    number<&DramParameters::clock_den>("dram.clock_den", 1, 64, kTime, "",
                                       "Memory clock = machine clock * clock_num / clock_den.", kOurs),
    number<&DramParameters::request_latency_cycles>(
        "dram.request_latency_cycles", 1, 10'000, kTime, "cycles",
        "From height_l1 or result_writer to the memory controller.", kOurs),
    number<&DramParameters::response_latency_cycles>(
        "dram.response_latency_cycles", 1, 10'000, kTime, "cycles",
        "From the memory controller back to height_l1 or result_writer.", kOurs),
};

}  // namespace parameter

}  // namespace cuesta
