#pragma once

#include "sim/hardware/rtl_set.h"
#include "sim/hardware/traverse_port.h"
#include "sim/hardware/verilated_unit.h"

namespace cuesta::rtl {

/// The Verilated traverse V, compiled for `set`.
template <class V>
class VerilatedTraverse final : public VerilatedUnit<V, TraversePort> {
 public:
  VerilatedTraverse(const RtlParameters& set, int seed, const VerilatedRegions<V>& regions)
      : VerilatedUnit<V, TraversePort>("traverse", seed, regions),
        plane_bits_(plane_bits(set)),
        fraction_bits_(set.fraction_bits),
        product_mask_((uint64_t{1} << product_bits(set)) - 1) {}

  void reset() override {
    rtl().rst_ni = 0;
    this->evaluate(TraversePort::Inputs{});
    this->clock();
    rtl().rst_ni = 1;
    this->changed();
  }
  void configure(const TraversePort::Settings& settings) override {
    V& r = rtl();
    r.cfg_root_level_i = static_cast<uint8_t>(settings.map.root_level);
    r.cfg_border_i = settings.map.address_mode == AddressMode::kBorder;
    r.cfg_down_i = static_cast<uint8_t>(settings.schedule.down);
    r.cfg_up_i = static_cast<uint8_t>(settings.schedule.up);
    r.cfg_stop_level_i = static_cast<uint8_t>(settings.schedule.stop_level);
    set_port(r.cfg_t_end_i, settings.t_end);
    r.cfg_morton_i = settings.morton;
    for (size_t level = 0; level < settings.level_base.size(); ++level) {
      r.cfg_level_base_i[level] = static_cast<uint32_t>(settings.level_base[level]);  // 32 bits each
    }
    this->changed();
  }

  TraversePort::Outputs evaluate(const TraversePort::Inputs& in) override {
    V& r = rtl();
    r.in_valid_i = in.ray != nullptr;
    if (in.ray != nullptr) offer(*in.ray, in.ray_dead, in.ray_number);
    r.replay_valid_i = in.replay_context >= 0;
    r.replay_context_i = static_cast<uint8_t>(in.replay_context);
    r.retry_valid_i = in.retry_context >= 0;
    r.retry_context_i = static_cast<uint8_t>(in.retry_context);
    r.hit_ready_i = in.hit_ready;
    set_port(r.texel_i, in.texel);
    r.lookup_hit_i = 0;
    this->settle();
    const bool moves = r.enable_o != 0;  // what is asked for happens only then
    return {moves,
            r.in_valid_i && r.in_ready_o,
            moves && r.replay_take_o,
            moves && r.lookup_retry_o,
            moves && r.lookup_valid_o,
            r.lookup_address_o,
            r.lookup_context_o,
            static_cast<uint32_t>(r.slot_id_o),
            r.hit_valid_o != 0,
            r.full_o != 0};
  }
  void answer(bool hit) override {
    rtl().lookup_hit_i = hit;
    this->settle();
  }

  HitRecord hit() const override { return hit_record(this->rtl(), plane_bits_); }

 private:
  using VerilatedUnit<V, TraversePort>::rtl;

  void offer(const SetUpRay& ray, bool dead, uint32_t number) {
    V& r = rtl();
    r.in_id_i = number;
    r.in_dead_i = dead;
    // The hardware keeps mantissas without their fraction shift; a falling z has both signs turned.
    auto line = [&](const FixedArithmetic::PlaneTime& l, bool turned, auto& m, auto& o, auto& e,
                    auto& still) {
      const int64_t sign = turned ? -1 : 1;
      set_port(m, static_cast<uint64_t>(sign * l.slope) >> fraction_bits_);
      set_port(o, static_cast<uint64_t>(sign * l.offset) & product_mask_);
      set_port(e, static_cast<uint64_t>(l.shift));
      still = l.limit < 0;
    };
    line(ray.x, false, r.in_mx_i, r.in_ox_i, r.in_ex_i, r.in_still_x_i);
    line(ray.y, false, r.in_my_i, r.in_oy_i, r.in_ey_i, r.in_still_y_i);
    line(ray.z, !ray.rising, r.in_mz_i, r.in_oz_i, r.in_ez_i, r.in_still_z_i);
    r.in_flip_x_i = ray.gx.flip != 0;
    r.in_flip_y_i = ray.gy.flip != 0;
    r.in_rising_i = ray.rising;
    set_port(r.in_t_start_i, static_cast<uint64_t>(ray.t_start));
    set_port(r.in_t_max_i, static_cast<uint64_t>(ray.t_max));
    set_port(r.in_t_root_i, static_cast<uint64_t>(ray.t_root));
    r.in_level_i = static_cast<uint8_t>(ray.level);
    const uint64_t plane_mask = (uint64_t{1} << plane_bits_) - 1;
    set_port(r.in_node_x_i, static_cast<uint64_t>(ray.gx.node) & plane_mask);
    set_port(r.in_node_y_i, static_cast<uint64_t>(ray.gy.node) & plane_mask);
  }

  int plane_bits_;
  int fraction_bits_;
  uint64_t product_mask_;
};

}  // namespace cuesta::rtl
