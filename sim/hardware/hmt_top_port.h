#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "models/rays/hit.h"
#include "models/rays/machine_ray.h"
#include "sim/hardware/hmt_registers.h"
#include "sim/hardware/wave_port.h"

namespace cuesta::rtl {

/// The ports of one Verilated rtl/hmt_top.sv, whatever it is compiled for. In each cycle: evaluate, then clock.
class HmtTopPort : public WavePort {
 public:
  struct Inputs {
    const MachineRay* ray = nullptr;  ///< offered; nullptr: none
    uint32_t ray_number = 0;
    bool no_ray_to_come = false;
    bool hit_ready = false;
    bool request_ready = false;
    int fill_mshr = -1;  ///< lands in this cycle; -1: none
    const std::byte* fill_data = nullptr;
  };
  /// What the cycle was: HmtSlot... of rtl/traverse/traverse_types.svh.
  enum class Slot : uint8_t { kBubble, kStep, kMiss, kMerge, kRefused, kDead, kStall };
  struct Outputs {
    bool ray_ready = false;
    bool hit_valid = false;
    bool request_valid = false;
    Slot slot = Slot::kBubble;
    uint32_t slot_ray = 0;  ///< of a slot that is neither bubble nor stall
    int request_mshr = 0;   ///< of a request
    uint64_t request_address = 0;
  };

  virtual ~HmtTopPort() = default;
  virtual void reset() = 0;
  virtual void write_register(int address, uint64_t data) = 0;
  virtual uint64_t read_register(int address) = 0;
  /// The outputs of this cycle.
  virtual Outputs evaluate(const Inputs& inputs) = 0;
  /// The record offered on the hit stream, with the ray's number as its id.
  virtual HitRecord hit() const = 0;
  /// The clock's edge that ends the cycle.
  virtual void clock() = 0;
};

}  // namespace cuesta::rtl
