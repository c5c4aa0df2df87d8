#pragma once

#include <deque>
#include <optional>
#include <systemc>
#include <vector>

#include "sim/hosts/systemc/hits_out.h"
#include "sim/hosts/systemc/machine_clock.h"
#include "sim/hosts/systemc/memory_out.h"
#include "sim/machine/cycle_machine.h"

namespace cuesta::systemc {

/// Signals of a machine for a trace file (VCD), at each rising edge: what the sockets do, and at the same place the
/// fill of the units at the end of the cycle that is on the sockets then (`machine.cycle`).
class MachineWaves : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(MachineWaves);
  /// `pipelines`: so many have signals.
  MachineWaves(const sc_core::sc_module_name& name, sc_core::sc_trace_file* file, int pipelines,
               const MemoryOut& memory, const HitsOut& hits);

  void begin(const MachineClock& clock, Cycle window);
  /// The machine has done `cycle`.
  void sample(Cycle cycle, const CycleMachine& machine);

 private:
  using Word = sc_dt::uint64;
  struct Sample {
    Cycle cycle;
    Word rays_unsent;
    std::vector<PipelineFill> fill;
  };

  void show();

  const MemoryOut& memory_;
  const HitsOut& hits_;
  std::optional<MachineClock> clock_;
  Cycle window_ = 0;
  std::deque<Sample> samples_;
  sc_core::sc_event next_;

  // What is traced.
  Word cycle_ = 0, rays_unsent_ = 0;
  bool request_phase_ = false;
  Word requests_waiting_ = 0, requests_in_flight_ = 0, address_ = 0, hits_waiting_ = 0, hits_sent_ = 0;
  std::vector<PipelineFill> fill_;
};

}  // namespace cuesta::systemc
