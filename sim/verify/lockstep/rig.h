#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "models/common/error.h"
#include "models/heightmap/texel_layout.h"
#include "sim/machine/cycle_machine.h"
#include "sim/verify/lockstep/lockstep_case.h"

namespace cuesta {

/// The value part of a case, which both sides read.
struct LockstepWork {
  /// Throws input_error for a ray that does not fit the machine's numbers.
  LockstepWork(const LockstepCase& one, const LockstepMachine& machine);
  /// Says whether it has the numbers and leaves of this machine, too.
  bool serves(const LockstepCase& one, const LockstepMachine& machine) const;
  /// Makes the work of all its rays on the machine; it must outlive the workload.
  Workload workload(const LockstepCase& one, const LockstepMachine& machine) const;

  std::shared_ptr<const Pyramid> pyramid;  ///< stopped where the schedule stops
  NumberFormat format;
  std::vector<MachineRay> rays;
  std::vector<uint32_t> pixels;
};

/// One side of a comparison: its machine from reset on, with what it meets.
class LockstepRig {
 public:
  LockstepRig(const LockstepCase& one, const LockstepMachine& machine,
              std::shared_ptr<const LockstepWork> work, const WaveWindow& waves = {});

  /// Everything in cycles below `end`; a machine that makes no progress, or that does what no machine may, is `stuck`.
  void advance(Cycle end);
  /// From here on by so many cycles at most, so that fills are exact after each.
  void step_by(Cycle cycles) { machine_->step_by(cycles); }

  bool done() const { return machine_->done(); }
  /// What was said of it; nullopt: it goes on.
  const std::optional<Error>& stuck() const { return stuck_; }
  const CycleMachine& machine() const { return *machine_; }
  std::vector<PortLog>& logs() { return logs_; }
  const TexelLayout& layout() const { return layout_; }
  /// Its height_l1 is hardware, which does not show how many MSHRs and retries there are.
  bool hides_mshrs() const { return settings_.architecture.units.hmt_top == Implementation::kRtl; }
  const LockstepWork& work() const { return *work_; }
  /// Of a ray in the machine's order, its place in the case's rays.
  uint32_t position(uint32_t ray) const { return order_[ray]; }

 private:
  void feed(Cycle end);

  LockstepMachine settings_;
  std::shared_ptr<const LockstepWork> work_;
  TexelLayout layout_;
  std::vector<uint32_t> order_;
  std::vector<PortLog> logs_;
  std::optional<RandomMemory> memory_;
  std::unique_ptr<CycleMachine> machine_;
  Cycle now_ = 0;
  size_t arrived_ = 0;
  Cycle next_arrival_ = 0;
  bool ended_ = false;
  std::optional<Error> stuck_;
};

}  // namespace cuesta
