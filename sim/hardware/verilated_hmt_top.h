#pragma once

#include <cstring>

#include "sim/hardware/hmt_top_port.h"
#include "sim/hardware/rtl_set.h"
#include "sim/hardware/verilated_unit.h"

namespace cuesta::rtl {

/// The Verilated hmt_top V, compiled for `set`.
template <class V>
class VerilatedHmtTop final : public VerilatedUnit<V, HmtTopPort> {
 public:
  VerilatedHmtTop(const RtlParameters& set, int seed, const VerilatedRegions<V>& regions)
      : VerilatedUnit<V, HmtTopPort>("hmt_top", seed, regions),
        line_bytes_(static_cast<size_t>(set.line_bytes)),
        position_mask_((uint64_t{1} << position_bits(set)) - 1),
        direction_mask_((uint64_t{1} << (set.direction_bits + 1)) - 1),
        plane_bits_(plane_bits(set)) {}

  void reset() override {
    rtl().rst_ni = 0;
    rtl().reg_write_i = 0;
    rtl().reg_read_i = 0;
    this->evaluate(HmtTopPort::Inputs{});
    this->clock();
    rtl().rst_ni = 1;
    this->changed();
    settled_ = false;
  }
  void write_register(int address, uint64_t data) override {
    rtl().reg_write_i = 1;
    rtl().reg_address_i = static_cast<uint8_t>(address);
    rtl().reg_data_i = data;
    this->changed();
    this->evaluate(HmtTopPort::Inputs{});
    this->clock();
    rtl().reg_write_i = 0;
    this->changed();
  }
  uint64_t read_register(int address) override {
    rtl().reg_read_i = 1;
    rtl().reg_address_i = static_cast<uint8_t>(address);
    rtl().eval();
    rtl().reg_read_i = 0;
    this->changed();
    return rtl().reg_data_o;
  }

  HmtTopPort::Outputs evaluate(const HmtTopPort::Inputs& in) override {
    V& r = rtl();
    const Flags flags{in.ray != nullptr, in.no_ray_to_come, in.request_ready, in.hit_ready};
    // The only input that outputs follow from within the cycle.
    const bool settled = settled_ && flags_.hit_ready == in.hit_ready;
    if (flags != flags_ || !settled_) {
      flags_ = flags;
      r.ray_valid_i = flags.ray_valid;
      r.ray_none_i = flags.no_ray_to_come;
      r.axi_ar_ready_i = flags.request_ready;
      r.hit_ready_i = flags.hit_ready;
      this->changed();
    }
    if (in.ray != nullptr && (in.ray != ray_ || in.ray_number != r.ray_id_i)) {
      offer(*in.ray, in.ray_number);
      this->changed();
    }
    if (in.fill_mshr >= 0) {
      r.axi_r_valid_i = 1;
      r.axi_r_id_i = static_cast<uint8_t>(in.fill_mshr);
      std::memcpy(&r.axi_r_data_i, in.fill_data, line_bytes_);
      this->changed();
    } else if (r.axi_r_valid_i) {
      r.axi_r_valid_i = 0;
      this->changed();
    }
    this->settle(settled);
    settled_ = true;
    HmtTopPort::Outputs out{.ray_ready = r.ray_ready_o != 0,
                            .hit_valid = r.hit_valid_o != 0,
                            .request_valid = r.axi_ar_valid_o != 0,
                            .slot = static_cast<HmtTopPort::Slot>(r.event_slot_o),
                            .slot_ray = static_cast<uint32_t>(r.event_id_o)};
    if (out.request_valid) {
      out.request_mshr = r.axi_ar_id_o;
      out.request_address = r.axi_ar_addr_o;
    }
    return out;
  }

  HitRecord hit() const override { return hit_record(this->rtl(), plane_bits_); }

 private:
  using VerilatedUnit<V, HmtTopPort>::rtl;

  void offer(const MachineRay& ray, uint32_t number) {
    V& r = rtl();
    ray_ = &ray;
    r.ray_id_i = number;
    set_port(r.ray_x0_i, static_cast<uint64_t>(ray.x0) & position_mask_);
    set_port(r.ray_y0_i, static_cast<uint64_t>(ray.y0) & position_mask_);
    set_port(r.ray_z0_i, static_cast<uint64_t>(ray.z0));
    set_port(r.ray_dx_i, static_cast<uint64_t>(ray.dx) & direction_mask_);
    set_port(r.ray_dy_i, static_cast<uint64_t>(ray.dy) & direction_mask_);
    set_port(r.ray_dz_i, static_cast<uint64_t>(ray.dz) & direction_mask_);
    set_port(r.ray_t_max_i, static_cast<uint64_t>(ray.t_max));
    r.ray_dead_i = ray.dead;
  }

  /// Inputs of one bit.
  struct Flags {
    bool ray_valid = false, no_ray_to_come = false, request_ready = false, hit_ready = false;
    bool operator==(const Flags& other) const = default;
  };

  size_t line_bytes_;
  uint64_t position_mask_, direction_mask_;
  int plane_bits_;
  const MachineRay* ray_ = nullptr;  ///< at the inputs
  Flags flags_;                      ///< at the inputs, once settled
  bool settled_ = false;             ///< evaluated since the reset
};

}  // namespace cuesta::rtl
