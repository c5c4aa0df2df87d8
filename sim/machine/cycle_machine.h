#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "models/heightmap/texel_layout.h"
#include "models/units/dram/dram_level.h"
#include "models/units/hmt/hmt_site.h"
#include "models/units/hmt/hmt_unit.h"
#include "models/units/memory/memory_port.h"
#include "models/units/memory/outside_memory.h"
#include "models/units/ports/port_log.h"
#include "models/units/ports/port_stalls.h"
#include "models/units/ray_dispatch/ray_dispatch.h"
#include "models/units/ray_source.h"
#include "models/work/step_source.h"
#include "sim/hardware/rtl_unit.h"
#include "sim/machine/machine.h"

namespace cuesta {

/// Waves of the hardware in one pipeline: its signals from cycle `first` to cycle `last` into an FST file.
struct WaveWindow {
  std::string file;  ///< empty: none
  int pipeline = 0;
  Cycle first = 0, last = kNever;
};

/// What tests and tools turn that no architecture has.
struct CycleHooks {
  const PortStalls* stalls = nullptr;  ///< back-pressure on the ports
  bool counters_only = false;  ///< no histograms, planes and digests: what a benchmark of the machine times
  bool loosely_timed = false;  ///< RunAheadTraverse in traverse's place (fidelity transaction)
  bool reverse_construction = false;          ///< build the pipelines last to first: must change nothing
  std::vector<PortLog>* port_logs = nullptr;  ///< one per pipeline, resized to that; must outlive the machine
  WaveWindow waves = {};
  int register_seed = 0;  ///< hardware: of what registers without a reset begin with; 0: zeros
};

/// Per ray, in the order of the trace.
struct CycleDetail {
  std::vector<RayTiming> timing;
  std::vector<MemoryCost> memory;
};

/// `run_cycle` with hooks; `detail` may be nullptr.
Outcome run_cycle_detailed(const Workload& work, const Architecture& architecture, const Progress& progress,
                           const CycleHooks& hooks, CycleDetail* detail);

/// How full a pipeline is at the end of a cycle.
struct PipelineFill : HmtUnit::Fill {
  int hit_queue = 0;      ///< records
  int burst_records = 0;  ///< in result_writer's buffer
  int bursts = 0;         ///< written, not yet acknowledged
};

/// The machine: instances and bindings. A host moves it on, a number of cycles at a time.
///
/// Either all rays of a workload are there at cycle 0 and dram is inside (`run_cycle`), or a host brings the rays and
/// serves memory: rays by a RaySource that the machine asks, or told one by one (RayIntake). Such a host may run the
/// machine up to `window()` cycles ahead of its own time: no answer to what leaves within a window lands in that
/// window.
/// Before `advance(end)` it must have told every ray, end of trace and answer of a cycle below `end`.
class CycleMachine final : public RayIntake {
 public:
  /// All of `work`; `work`'s pyramid and the architecture must outlive the machine.
  CycleMachine(const Workload& work, const Architecture& architecture, const CycleHooks& hooks);
  /// No ray yet (`work.rays` is not looked at), memory outside. Rays are taken in the order in which they come,
  /// whatever ray_dispatch.order is.
  /// `source`: asked for rays in `advance`; nullptr: the host tells them.
  CycleMachine(const Workload& work, const Architecture& architecture, OutsideMemory& memory,
               RaySource* source, const CycleHooks& hooks = {});
  ~CycleMachine();
  CycleMachine(const CycleMachine&) = delete;
  CycleMachine& operator=(const CycleMachine&) = delete;

  // For a host that brings the rays and serves memory.

  void trace_arrives(std::span<const MachineRay> rays, std::span<const uint32_t> pixels) override;
  void ray_arrives(const MachineRay& ray, uint32_t pixel, Cycle cycle) override;
  void end_of_rays(Cycle cycle) override;
  /// Tells the outside memory's answer: OutsideLevel.
  void answer(uint64_t number, Cycle response, int bus_clocks, int row_activations) {
    outside_->answer(number, response, bus_clocks, row_activations);
  }
  /// request_latency_cycles + response_latency_cycles.
  Cycle window() const { return window_; }
  /// Pipelines advance in turn by `cycles` at most, so that `fill` between two calls of advance is exact.
  void step_by(Cycle cycles) { step_ = std::min(step_, cycles); }
  /// No record enters a hit_queue before `cycle`.
  void hold_hits_until(Cycle cycle);
  /// From now on completed rays are added to the lists, one list per pipeline, in order.
  void log_completions(std::vector<std::vector<uint32_t>>& rays);

  /// Everything that happens in cycles below `end`. Throws Error(kNoProgress).
  void advance(Cycle end);

  /// Every ray has completed, none can come, and everything written is acknowledged.
  bool done() const;
  /// Nothing can happen until a ray or the end of the trace comes.
  bool starved() const;
  /// Rays that wait for ray_dispatch to send them.
  uint32_t unsent() const { return static_cast<uint32_t>(order_.size()) - dispatch_.sent(); }
  uint64_t completed() const;
  /// Each queue's fill and who waits for whom.
  std::string who_waits() const;
  /// As at the end of the last cycle that `advance` did, but for those that are counted ahead of time:
  /// ray_dispatch.rays, ray_setup.rays.
  Counters counters() const;
  /// Of a machine that is done: how many cycles it took.
  Cycle cycles() const { return work_.rays.empty() ? 0 : end_cycle(); }
  int pipelines() const { return pipelines_; }
  PipelineFill fill(int pipeline) const;
  const HitRecord& hit(uint32_t ray) const { return hits_[ray]; }
  const RayTiming& timing(uint32_t ray) const { return timing_[ray]; }

  /// False: ended early by `progress`.
  bool run(const Progress& progress);

  /// Ends the machine. `finished` false: partial. `detail` may be nullptr. Without what an outside memory alone
  /// knows.
  Outcome outcome(bool finished, bool counters_only, CycleDetail* detail);
  /// The same with rays that came from a host, put back into the order of `work`'s trace: ray k to come was
  /// `work.rays[position[k]]`. `dram`: what the outside memory counted; nullptr: not known, and left out.
  Outcome outcome(const Workload& work, std::span<const uint32_t> position, bool finished,
                  const Dram::Counts* dram);

 private:
  struct Pipeline;

  CycleMachine(const Workload& work, const Architecture& architecture, const CycleHooks& hooks,
               OutsideMemory* outside, RaySource* source);
  /// Makes room for what is known of each ray from number `first` on: `work_` has them.
  void add_rays(uint32_t first);
  std::unique_ptr<HmtUnit> make_hmt(const HmtSite& site, const CycleHooks& hooks) const;
  Cycle end_cycle() const;
  /// Of what the rays read.
  uint64_t image_bytes() const {
    return work_.search ? work_.search_map->size_bytes() : layout_.size_bytes();
  }
  uint16_t target_of(uint32_t pixel) const;
  std::vector<uint16_t> targets() const;
  Outcome outcome(const Workload& work, std::span<const uint32_t> position, bool finished, bool counters_only,
                  const Dram::Counts* dram, CycleDetail* detail);
  void count(Counters& counters, Cycle cycles, const Dram::Counts* dram) const;

  Workload work_;
  const Architecture& architecture_;
  TexelLayout layout_;
  std::vector<MachineRay> arrived_;      ///< outside rays
  std::vector<uint32_t> arrived_pixel_;  ///< likewise
  std::vector<uint32_t> order_;          ///< machine's order -> position in the trace
  std::unique_ptr<StepSource> source_;
  std::unique_ptr<rtl::RtlJob> rtl_;  ///< where some unit is hardware
  int pipelines_;
  bool hosted_;  ///< rays and memory are outside
  RaySource* rays_;
  bool at_once_;  ///< one pipeline, memory inside, nothing held back: no windows
  Cycle window_;
  Cycle step_;  ///< pipelines advance in turn by so much
  Cycle now_ = 0;
  std::vector<MemoryCost> costs_;
  std::vector<RayTiming> timing_;
  std::vector<HitRecord> hits_;
  Watchdog watchdog_;
  std::unique_ptr<DramLevel> dram_;        ///< inside
  std::unique_ptr<OutsideLevel> outside_;  ///< in its place
  MemoryLevel& below_;                     ///< the one of the two that there is
  MemoryPort memory_;
  RayDispatch dispatch_;
  std::vector<std::unique_ptr<Pipeline>> pipeline_;
};

}  // namespace cuesta
