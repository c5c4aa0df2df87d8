#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <systemc>
#include <vector>

#include "sim/hosts/systemc/hits_out.h"
#include "sim/hosts/systemc/machine_clock.h"
#include "sim/hosts/systemc/machine_waves.h"
#include "sim/hosts/systemc/memory_out.h"
#include "sim/hosts/systemc/rays_in.h"
#include "sim/hosts/systemc/shell_parameters.h"
#include "sim/machine/cycle_machine.h"
#include "traces/ray_trace.h"

namespace cuesta::systemc {

/// What a machine works on; pyramid and architecture must outlive it.
struct MachineSetup {
  const Pyramid* pyramid = nullptr;  ///< max pyramid, or four-corner pyramid as map.surface is
  MapShape map;
  Schedule schedule;
  int width = 0, height = 0;  ///< of the frame that the rays' pixels are in
  const Architecture* architecture = nullptr;
};

/// The machine (sim/machine/cycle_machine.h) in a SystemC module, with three TLM-2.0 sockets.
///
/// Time: the sockets are at the memory's end of the way between machine and memory. What comes in (rays, memory's
/// responses) takes dram.response_latency_cycles to the machine, what goes out (requests, hit records)
/// dram.request_latency_cycles. Socket cycle n is at n / machine.clock_mhz after `load`; the machine's cycle 0 comes
/// response_latency_cycles later. Hence, with window = request_latency + response_latency: what comes in at socket
/// cycle n (or between n - 1 and n) is there in the machine's cycle n; what leaves the machine in cycle c is on the
/// socket at socket cycle c + window. At socket cycle k * window the machine does the window of cycles before it:
/// everything goes out at its exact time and nothing can come in too late, whatever the other side does.
///
/// rays_in: records of 112 bytes (traces/README.md) and registers (shell_parameters.h). A ray may be sent by
/// ray_dispatch in the cycle of its arrival; rays are taken in the order in which they come, whatever
/// ray_dispatch.order says. With ShellParameters::ray_fifo, a write waits while so many rays are unsent.
/// hits_out: records of 32 bytes (models/rays/hit_bytes.h), each `window` after the ray's completion, ordered by
/// (cycle, pipeline). Back-pressure: at the start of a window, if fewer than pipelines x window places of the FIFO
/// are free, no record enters a hit_queue in the whole window, and the pipelines stand still where one would.
/// memory_out: height_l1's reads and result_writer's writes, in the order (cycle, pipeline, read before write); a
/// request that the target does not accept waits, and those behind it. Responses in any order. A memory other than
/// DramTarget changes the timing of memory and nothing else: hits are computed from the pyramid, the bytes that come
/// back are held against it.
///
/// Faults: an Error of the machine, or of what the memory answers, is kept, stops the simulation and is thrown by
/// `outcome`.
class MachineShell : public sc_core::sc_module, private OutsideMemory {
  RaysIn rays_{
      "rays",
      {[this] { return full(); }, [this](const TracedRay& ray) { take(ray); }, [this] { end_of_rays(); },
       [this] { return machine_ != nullptr && !rays_ended_; }, [this] { return done(); }}};
  HitsOut hits_{"hits"};
  MemoryOut memory_;

 public:
  SC_HAS_PROCESS(MachineShell);
  tlm_utils::simple_target_socket<RaysIn>& rays_in = rays_.socket;
  tlm_utils::simple_initiator_socket_optional<HitsOut>& hits_out = hits_.socket;
  tlm_utils::simple_initiator_socket<MemoryOut>& memory_out = memory_.socket;

  explicit MachineShell(const sc_core::sc_module_name& name, const ShellParameters& parameters = {});
  ~MachineShell() override;

  /// A new machine, whose sockets' cycle 0 is now; before the simulation or between two runs of it. `progress`: as
  /// of run_cycle. Throws usage_error for parameters that contradict each other.
  void load(const MachineSetup& setup, const Progress& progress = {});
  /// Before the simulation: the machine's signals go into `file`, those of the first `pipelines` pipelines. The
  /// machine then goes cycle by cycle, which takes longer.
  void trace(sc_core::sc_trace_file* file, int pipelines);

  const MachineClock& clock() const { return *clock_; }
  /// Every ray has completed and every record is written.
  bool done() const { return done_; }

  /// After the simulation: what the machine did, in the order in which the rays came. Throws the Error that ended
  /// it, or Error(kNoProgress) with who waits for whom when the simulation stopped before the machine was done.
  Outcome outcome();
  /// The same in the order of `work`'s trace, as CycleMachine::outcome.
  Outcome outcome(const Workload& work, std::span<const uint32_t> position, const Dram::Counts* dram);

 private:
  struct Completion {
    Cycle cycle;
    uint32_t ray;
  };

  void run();
  void run_machine();
  void advance(Cycle from, Cycle end);
  void send_hits();
  void request(uint64_t number, const MemoryRequest& request) override;
  void answered(const MemoryTag& tag, const sc_core::sc_time& at);
  void fail(std::exception_ptr fault);

  bool full() const;
  void take(const TracedRay& ray);
  void end_of_rays();
  void check_finished() const;

  ShellParameters parameters_;
  MachineSetup setup_;
  NumberFormat format_;
  Progress progress_;
  size_t hit_places_ = 0;
  std::optional<MachineClock> clock_;
  std::unique_ptr<CycleMachine> machine_;
  std::unique_ptr<MachineWaves> waves_;
  std::vector<std::vector<uint32_t>> completed_;  ///< per pipeline, in order
  std::vector<size_t> given_;                     ///< per pipeline: of these, handed to hits_out
  std::vector<size_t> written_;                   ///< per pipeline: of these, sent to memory
  std::vector<Completion> window_hits_;
  std::vector<uint8_t> burst_;
  std::vector<uint64_t> ids_;
  bool rays_ended_ = false, done_ = false, stopped_ = false;
  std::exception_ptr fault_;
  sc_core::sc_event loaded_, ray_came_;
};

}  // namespace cuesta::systemc
