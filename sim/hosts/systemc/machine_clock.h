#pragma once

#include <cstdint>
#include <string>
#include <systemc>

#include "models/common/error.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta::systemc {

/// The machine's clock in SystemC's time: cycle c is at floor(c / frequency) after the origin, in whole units of the
/// kernel's time resolution, computed from c and not added up: no drift.
class MachineClock {
 public:
  /// Throws usage_error when the kernel's resolution is coarser than the clock's period.
  MachineClock(int clock_mhz, const sc_core::sc_time& origin)
      : per_microsecond_(static_cast<uint64_t>(clock_mhz)),
        units_(sc_core::sc_time(1, sc_core::SC_US).value()),
        origin_(origin.value()) {
    if (units_ < per_microsecond_) {
      throw usage_error("SystemC's time resolution is " + sc_core::sc_get_time_resolution().to_string() +
                        ", longer than a cycle of machine.clock_mhz = " + std::to_string(clock_mhz) +
                        "; accepted is a finer one, such as the default of 1 ps.");
    }
  }

  sc_core::sc_time time_of(Cycle cycle) const {
    const auto c = static_cast<uint64_t>(cycle);
    return sc_core::sc_time::from_value(origin_ + c / per_microsecond_ * units_ +
                                        c % per_microsecond_ * units_ / per_microsecond_);
  }
  /// The first cycle whose time is not before `time`.
  Cycle cycle_from(const sc_core::sc_time& time) const {
    if (time.value() <= origin_) return 0;
    const uint64_t value = time.value() - origin_;
    return static_cast<Cycle>(value / units_ * per_microsecond_ +
                              (value % units_ * per_microsecond_ + units_ - 1) / units_);
  }
  Cycle now() const { return cycle_from(sc_core::sc_time_stamp()); }

 private:
  uint64_t per_microsecond_;  ///< cycles
  uint64_t units_;            ///< of the resolution in a microsecond
  uint64_t origin_;
};

}  // namespace cuesta::systemc
