#pragma once

#include <verilated.h>

#include <cstdint>
#include <cstring>
#include <memory>
#include <span>

#include "models/heightmap/texel_layout.h"
#include "models/traversal/hit.h"
#include "models/traversal/traversal.h"

namespace cuesta::rtl {

/// What an hmt_top is compiled for.
struct HmtTopSet {
  int max_level, height_bits, fraction_bits, direction_bits, mantissa_bits, tile_bits;
  int setup_latency, setup_interval, setup_queue;
  int stages, contexts;
  int size_bytes, line_bytes, ways, mshrs;
};

/// The ports of one Verilated hmt_top, whatever it is compiled for.
class HmtTopPort {
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
  struct Outputs {
    bool ray_ready;
    bool hit_valid;
    bool request_valid;
    int request_mshr;
    uint64_t request_address;
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

inline int64_t sign_extended(uint64_t value, int bits) {
  return static_cast<int64_t>(value << (64 - bits)) >> (64 - bits);
}

/// Of hardware compiled with --x-initial unique, before it is constructed.
inline VerilatedContext& with_random_start(VerilatedContext& context, int reset_seed) {
  context.randReset(reset_seed == 0 ? 0 : 2);
  if (reset_seed != 0) context.randSeed(reset_seed);
  return context;
}

template <class V>
class HmtTop final : public HmtTopPort {
 public:
  /// `reset_seed`: what no reset touches holds random bits at the start, others for each seed; 0: zeros.
  explicit HmtTop(const HmtTopSet& set, int reset_seed = 0)
      : set_(set), rtl_(&with_random_start(context_, reset_seed)) {
    const int index_bits = set.max_level + set.tile_bits;
    position_mask_ = (uint64_t{1} << (index_bits + set.fraction_bits + 2)) - 1;
    direction_mask_ = (uint64_t{1} << (set.direction_bits + 1)) - 1;
    plane_bits_ = index_bits + 3;
  }

  void reset() override {
    rtl_.rst_ni = 0;
    rtl_.reg_write_i = 0;
    evaluate({});
    clock();
    rtl_.rst_ni = 1;
  }
  void write_register(int address, uint64_t data) override {
    rtl_.reg_write_i = 1;
    rtl_.reg_address_i = static_cast<uint8_t>(address);
    rtl_.reg_data_i = data;
    evaluate({});
    clock();
    rtl_.reg_write_i = 0;
  }
  uint64_t read_register(int address) override {
    rtl_.reg_address_i = static_cast<uint8_t>(address);
    rtl_.eval();
    return rtl_.reg_data_o;
  }

  Outputs evaluate(const Inputs& in) override {
    rtl_.ray_valid_i = in.ray != nullptr;
    if (in.ray != nullptr) {
      rtl_.ray_id_i = in.ray_number;
      set(rtl_.ray_x0_i, static_cast<uint64_t>(in.ray->x0) & position_mask_);
      set(rtl_.ray_y0_i, static_cast<uint64_t>(in.ray->y0) & position_mask_);
      set(rtl_.ray_z0_i, static_cast<uint64_t>(in.ray->z0));
      set(rtl_.ray_dx_i, static_cast<uint64_t>(in.ray->dx) & direction_mask_);
      set(rtl_.ray_dy_i, static_cast<uint64_t>(in.ray->dy) & direction_mask_);
      set(rtl_.ray_dz_i, static_cast<uint64_t>(in.ray->dz) & direction_mask_);
      set(rtl_.ray_t_max_i, static_cast<uint64_t>(in.ray->t_max));
      rtl_.ray_dead_i = in.ray->dead;
    }
    rtl_.ray_none_i = in.no_ray_to_come;
    rtl_.hit_ready_i = in.hit_ready;
    rtl_.axi_ar_ready_i = in.request_ready;
    rtl_.axi_r_valid_i = in.fill_mshr >= 0;
    if (in.fill_mshr >= 0) {
      rtl_.axi_r_id_i = static_cast<uint8_t>(in.fill_mshr);
      std::memcpy(rtl_.axi_r_data_i.data(), in.fill_data, static_cast<size_t>(set_.line_bytes));
    }
    rtl_.clk_i = 0;
    rtl_.eval();
    return {rtl_.ray_ready_o != 0, rtl_.hit_valid_o != 0, rtl_.axi_ar_valid_o != 0, rtl_.axi_ar_id_o,
            rtl_.axi_ar_addr_o};
  }

  HitRecord hit() const override {
    HitRecord record;
    record.ray_id = rtl_.hit_id_o;
    record.status = rtl_.hit_status_o ? HitStatus::kHit : HitStatus::kMiss;
    record.face = static_cast<HitFace>(rtl_.hit_face_o);
    record.stop_level = rtl_.hit_level_o;
    record.i = static_cast<int32_t>(sign_extended(rtl_.hit_i_o, plane_bits_));
    record.j = static_cast<int32_t>(sign_extended(rtl_.hit_j_o, plane_bits_));
    record.t = static_cast<int64_t>(rtl_.hit_t_o);
    record.steps = rtl_.hit_steps_o;
    return record;
  }

  void clock() override {
    rtl_.clk_i = 1;
    rtl_.eval();
  }

 private:
  template <class P>
  static void set(P& port, uint64_t value) {
    port = static_cast<P>(value);
  }

  HmtTopSet set_;
  VerilatedContext context_;
  V rtl_;
  uint64_t position_mask_, direction_mask_;
  int plane_bits_;
};

/// Register addresses of rtl/hmt_top.sv.
inline constexpr int kRegisterMode = 0, kRegisterTimeEnd = 1, kRegisterRootBound = 2, kRegisterLevelBase = 16,
                     kRegisterCounter = 32;

/// The counters of rtl/hmt_top.sv, in the order of their addresses.
inline constexpr const char* kCounters[][2] = {{"ray_setup", "rays"},
                                               {"traverse", "rays"},
                                               {"traverse", "hits"},
                                               {"traverse", "slots_step"},
                                               {"traverse", "slots_miss"},
                                               {"traverse", "slots_refused"},
                                               {"traverse", "slots_dead"},
                                               {"traverse", "bubble_contexts_full"},
                                               {"traverse", "bubble_no_ray"},
                                               {"traverse", "bubble_drain"},
                                               {"traverse", "stall_hit_queue"},
                                               {"traverse", "replays"},
                                               {"height_l1", "accesses"},
                                               {"height_l1", "hits"},
                                               {"height_l1", "misses"},
                                               {"height_l1", "merges"},
                                               {"height_l1", "refused"},
                                               {"height_l1", "fills"},
                                               {"height_l1", "evictions"},
                                               {"traverse", "resident_cycles"},
                                               {"height_l1", "mshr_cycles"}};

inline void configure(HmtTopPort& top, const Schedule& schedule, const MapShape& map,
                      const NumberFormat& format, int root_bound, const TexelLayout& layout) {
  const uint64_t mode = static_cast<uint64_t>(map.root_level) |
                        static_cast<uint64_t>(map.address_mode == AddressMode::kBorder) << 4 |
                        static_cast<uint64_t>(schedule.start) << 5 |
                        static_cast<uint64_t>(schedule.down) << 7 | static_cast<uint64_t>(schedule.up) << 9 |
                        static_cast<uint64_t>(schedule.stop_level) << 12 |
                        static_cast<uint64_t>(layout.kind() == TexelLayoutKind::kMorton) << 16;
  top.write_register(kRegisterMode, mode);
  top.write_register(kRegisterTimeEnd, (uint64_t{1} << time_bits(map, format)) - 1);
  top.write_register(kRegisterRootBound, static_cast<uint64_t>(root_bound));
  for (int level = 0; level <= map.root_level; ++level) {
    top.write_register(kRegisterLevelBase + level, layout.offset(level, 0, 0));
  }
}

}  // namespace cuesta::rtl
