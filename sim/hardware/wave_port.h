#pragma once

#include <cstdint>
#include <string>

namespace cuesta::rtl {

/// Verilated hardware that can write its signals into a wave file.
class WavePort {
 public:
  /// From the next cycle on, into an FST file; one time unit is one nanosecond, a cycle takes two: the first has
  /// the cycle's values, the second those behind its clock edge. Throws Error(kResource) for a file that cannot be
  /// written, usage_error for hardware compiled without waves.
  virtual void open_waves(const std::string& file, int64_t cycle) = 0;
  virtual void close_waves() = 0;

 protected:
  ~WavePort() = default;
};

}  // namespace cuesta::rtl
