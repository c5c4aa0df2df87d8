#pragma once

#include <verilated.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <type_traits>

#include "models/common/error.h"
#include "models/rays/hit.h"
#include "sim/hardware/wave_port.h"

#ifdef CUESTA_RTL_WAVES
#include <verilated_fst_c.h>
#endif
#ifdef CUESTA_RTL_COVERAGE
#include <verilated_cov.h>

#include <cstdlib>
#endif

namespace cuesta::rtl {

inline int64_t sign_extended(uint64_t value, int bits) {
  return static_cast<int64_t>(value << (64 - bits)) >> (64 - bits);
}

template <class P>
void set_port(P& port, uint64_t value) {
  port = static_cast<P>(value);
}

/// The record that V offers on its hit stream, with the ray's number as its id.
template <class V>
HitRecord hit_record(const V& rtl, int plane_bits) {
  HitRecord record;
  record.ray_id = rtl.hit_id_o;
  record.status = rtl.hit_status_o ? HitStatus::kHit : HitStatus::kMiss;
  record.face = static_cast<HitFace>(rtl.hit_face_o);
  record.stop_level = rtl.hit_level_o;
  record.i = static_cast<int32_t>(sign_extended(rtl.hit_i_o, plane_bits));
  record.j = static_cast<int32_t>(sign_extended(rtl.hit_j_o, plane_bits));
  record.t = static_cast<int64_t>(rtl.hit_t_o);
  record.steps = rtl.hit_steps_o;
  return record;
}

/// Of hardware compiled with --x-initial unique, before it is constructed: what no reset touches holds random bits,
/// others for each seed; 0: zeros.
inline VerilatedContext& with_random_start(VerilatedContext& context, int seed) {
  context.randReset(seed == 0 ? 0 : 2);
  if (seed != 0) context.randSeed(seed);
  return context;
}

/// What Verilator makes of V beside its class, declared weak by who instantiates it: what follows from inputs, and what
/// the clock's edge does with all that follows. Null where V has none.
template <class V>
struct VerilatedRegions {
  using Root = std::remove_pointer_t<decltype(V::rootp)>;
  void (*inputs)(Root*);
  void (*edge)(Root*);
};

/// Clock, reset and waves of a Verilated module V; Port is the interface that its user implements.
template <class V, class Port>
class VerilatedUnit : public Port {
 public:
  VerilatedUnit(const char* name, int seed, const VerilatedRegions<V>& regions) : regions_(regions) {
    with_random_start(context_, seed);
#ifdef CUESTA_RTL_WAVES
    context_.traceEverOn(true);
#endif
    rtl_ = std::make_unique<V>(&context_, name);
  }
  ~VerilatedUnit() override {
    VerilatedUnit::close_waves();
#ifdef CUESTA_RTL_COVERAGE
    static int number = 0;
    if (const char* folder = std::getenv("CUESTA_RTL_COVERAGE_FOLDER")) {
      const std::string file = std::string(folder) + "/" + rtl_->modelName() + "_" + std::to_string(number++);
      context_.coveragep()->write((file + ".dat").c_str());
    }
#endif
    // A scope is erased from the thread's context, which may be that of a unit long gone.
    Verilated::threadContextp(&context_);
    rtl_.reset();
  }
  VerilatedUnit(const VerilatedUnit&) = delete;
  VerilatedUnit& operator=(const VerilatedUnit&) = delete;

  void clock() override {
#ifdef CUESTA_RTL_WAVES
    // The cycle as it stands at its end, however often it was evaluated.
    if (waves_) [[unlikely]]
      waves_->dump(time_);
#endif
    rtl_->clk_i = 1;
    if constexpr (kEdgeIsAll) {
      if (regions_.edge != nullptr && regions_.inputs != nullptr && started_ && !waves_open()) {
        auto& root = *rtl_->rootp;
        root.__Vtrigrprev__TOP__clk_i = 1;
        root.__VicoTriggered.at(0) = root.__VnbaTriggered.at(0) = true;
        if (changed_) regions_.inputs(&root);
        regions_.edge(&root);
        changed_ = false;
        return;
      }
    }
    evaluate_all();
#ifdef CUESTA_RTL_WAVES
    if (waves_) [[unlikely]] {
      waves_->dump(time_ + 1);
      time_ += 2;
    }
#endif
  }

#ifdef CUESTA_RTL_WAVES
  void open_waves(const std::string& file, int64_t cycle) override {
    std::FILE* probe = std::fopen(file.c_str(), "wb");  // the writer itself would only be silent
    if (probe == nullptr) {
      throw usage_error("The waves cannot be written into " + file +
                        "; accepted is a file in a folder that may be written.");
    }
    std::fclose(probe);
    waves_ = std::make_unique<VerilatedFstC>();
    rtl_->trace(waves_.get(), 99);
    waves_->set_time_unit("1ns");
    waves_->set_time_resolution("1ns");
    waves_->open(file.c_str());
    time_ = static_cast<uint64_t>(cycle) * 2;
  }
  void close_waves() override {
    if (waves_) waves_->close();
    waves_.reset();
  }
#else
  void open_waves(const std::string&, int64_t) override {
    throw usage_error("This hardware is compiled without waves.");
  }
  void close_waves() override {}
#endif

 protected:
  /// An input has changed since the last evaluation.
  void changed() { changed_ = true; }
  /// The outputs of the cycle, with the clock low. `settled`: they stand already, since the clock's last edge: no input
  /// that they follow from within a cycle has changed, and the clock's fall alone is no event of the hardware's.
  void settle(bool settled = false) {
    rtl_->clk_i = 0;
    if constexpr (kEdgeIsAll) {
      if (settled && !waves_open()) {
        rtl_->rootp->__Vtrigrprev__TOP__clk_i = 0;
        return;
      }
    }
    evaluate_all();
  }
#ifdef CUESTA_RTL_WAVES
  bool waves_open() const { return waves_ != nullptr; }
#else
  bool waves_open() const { return false; }
#endif
  V& rtl() { return *rtl_; }
  const V& rtl() const { return *rtl_; }

 private:
  /// Nothing but the clock's edge is an event of V's: it can be done without looking for others. Verilator 5.006.
  static constexpr bool kEdgeIsAll = requires(V & v) {
    v.rootp->__Vtrigrprev__TOP__clk_i;
    requires std::is_same_v<std::remove_cvref_t<decltype(v.rootp->__VnbaTriggered)>, VlTriggerVec<1>>;
    requires std::is_same_v<std::remove_cvref_t<decltype(v.rootp->__VicoTriggered)>, VlTriggerVec<1>>;
  };

  void evaluate_all() {
    rtl_->eval();
    started_ = true;
    changed_ = false;
  }

  VerilatedContext context_;
  VerilatedRegions<V> regions_;
  bool started_ = false;  ///< evaluated once: initial values stand
  bool changed_ = true;   ///< an input, since the last evaluation
  std::unique_ptr<V> rtl_;
#ifdef CUESTA_RTL_WAVES
  std::unique_ptr<VerilatedFstC> waves_;
  uint64_t time_ = 0;
#endif
};

}  // namespace cuesta::rtl
