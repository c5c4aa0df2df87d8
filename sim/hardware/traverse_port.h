#pragma once

#include <cstdint>
#include <vector>

#include "models/rays/hit.h"
#include "models/traversal/traversal.h"
#include "sim/hardware/wave_port.h"

namespace cuesta::rtl {

/// What ray_setup has made of a ray.
using SetUpRay = RayState<FixedArithmetic, PlainAxis>;

/// The ports of one Verilated rtl/traverse/traverse.sv. In each cycle: evaluate, answer if there is a lookup,
/// then clock.
class TraversePort : public WavePort {
 public:
  struct Settings {
    MapShape map;
    Schedule schedule;
    uint64_t t_end;
    bool morton;
    std::vector<uint64_t> level_base;  ///< bytes
  };
  struct Inputs {
    const SetUpRay* ray = nullptr;  ///< offered; nullptr: none
    bool ray_dead = false;
    uint32_t ray_number = 0;
    int replay_context = -1;  ///< offered by height_l1; -1: none
    int retry_context = -1;
    bool hit_ready = false;
    uint32_t texel = 0;  ///< of the lookup or replay one enabled cycle before
  };
  struct Outputs {
    bool moves;      ///< the pipe
    bool ray_taken;  ///< the one offered
    bool replayed, retried;
    bool lookup;
    uint64_t address;  ///< bytes; of a replay too
    int context;
    uint32_t slot_ray;
    bool hit_valid;
    bool full;  ///< every context is resident
  };

  virtual ~TraversePort() = default;
  virtual void reset() = 0;
  virtual void configure(const Settings& settings) = 0;
  virtual Outputs evaluate(const Inputs& inputs) = 0;
  /// height_l1's answer to the lookup of this cycle.
  virtual void answer(bool hit) = 0;
  virtual HitRecord hit() const = 0;
  virtual void clock() = 0;
};

}  // namespace cuesta::rtl
