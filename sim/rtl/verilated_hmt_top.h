#pragma once

#include <cstring>

#include "sim/rtl/hmt_top_port.h"
#include "sim/rtl/rtl_set.h"
#include "sim/rtl/verilated_unit.h"

namespace cuesta::rtl {

/// The Verilated hmt_top V, compiled for `set`.
template <class V>
class VerilatedHmtTop final : public VerilatedUnit<V, HmtTopPort> {
 public:
  VerilatedHmtTop(const RtlParameters& set, int seed, const VerilatedRegions<V>& regions)
      : VerilatedUnit<V, HmtTopPort>("hmt_top", seed, regions),
        line_bytes_(static_cast<size_t>(set.line_bytes)),
        position_mask_((uint64_t{1} << (set.max_level + set.tile_bits + set.fraction_bits + 2)) - 1),
        direction_mask_((uint64_t{1} << (set.direction_bits + 1)) - 1),
        plane_bits_(set.max_level + set.tile_bits + 3) {}

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
    bool changed = in.fill_mshr >= 0;
    const auto put = [&changed](CData& port, bool value) {
      changed |= port != value;
      port = value;
    };
    put(r.ray_valid_i, in.ray != nullptr);
    if (in.ray != nullptr && (in.ray != ray_ || in.ray_number != r.ray_id_i)) {
      changed = true;
      offer(*in.ray, in.ray_number);
    }
    put(r.ray_none_i, in.no_ray_to_come);
    // The only input that outputs follow from within the cycle.
    const bool settled = settled_ && r.hit_ready_i == in.hit_ready;
    put(r.hit_ready_i, in.hit_ready);
    put(r.axi_ar_ready_i, in.request_ready);
    put(r.axi_r_valid_i, in.fill_mshr >= 0);
    if (in.fill_mshr >= 0) {
      r.axi_r_id_i = static_cast<uint8_t>(in.fill_mshr);
      std::memcpy(&r.axi_r_data_i, in.fill_data, line_bytes_);
    }
    if (changed) this->changed();
    this->settle(settled);
    settled_ = true;
    return {r.ray_ready_o != 0,
            r.hit_valid_o != 0,
            r.axi_ar_valid_o != 0,
            r.axi_ar_id_o,
            r.axi_ar_addr_o,
            static_cast<HmtTopPort::Slot>(r.event_slot_o),
            static_cast<uint32_t>(r.event_id_o)};
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

  size_t line_bytes_;
  uint64_t position_mask_, direction_mask_;
  int plane_bits_;
  const MachineRay* ray_ = nullptr;  ///< at the inputs
  bool settled_ = false;             ///< evaluated since the reset
};

}  // namespace cuesta::rtl
