// The one list of instances and bindings: which units a machine has, and what is connected to what.
#include "sim/machine/pipeline.h"

#include <algorithm>
#include <memory>

#include "models/common/error.h"
#include "models/units/dram/dram.h"
#include "models/units/dram/dram_level.h"
#include "models/units/hmt/hmt_model.h"
#include "models/units/traverse/run_ahead_traverse.h"
#include "sim/config/on_architecture.h"
#include "sim/hardware/choose_set.h"

namespace cuesta {

namespace {

Workload without_rays(Workload work) {
  work.rays = {};
  work.pixel_of_ray = {};
  return work;
}

int granule_bytes(const Architecture& architecture) {
  return std::max(architecture.height_l1.line_bytes, architecture.result_writer.burst_bytes);
}

}  // namespace

CycleMachine::Pipeline::Pipeline(CycleMachine& m, int p, uint64_t write_base, const CycleHooks& hooks,
                                 PortLog* log)
    : hit_queue(m.architecture_.hit_queue.depth),
      writer(m.architecture_.result_writer, write_base, m.pipelines_, p, hit_queue, m.memory_, hooks.stalls),
      drain(hit_queue, writer),
      hmt(m.make_hmt({m.architecture_, p, m.image_bytes(), m.order_, *m.source_, m.dispatch_, m.memory_,
                      drain, m.hits_, m.timing_, m.watchdog_, hooks.stalls, log},
                     hooks)) {}

CycleMachine::CycleMachine(const Workload& work, const Architecture& architecture, const CycleHooks& hooks)
    : CycleMachine(without_rays(work), architecture, hooks, nullptr, nullptr) {
  TraceRays(work.rays, work.pixel_of_ray).bring_until(0, *this);
}

CycleMachine::CycleMachine(const Workload& work, const Architecture& architecture, OutsideMemory& memory,
                           RaySource* source, const CycleHooks& hooks)
    : CycleMachine(without_rays(work), architecture, hooks, &memory, source) {}

CycleMachine::CycleMachine(const Workload& work, const Architecture& architecture, const CycleHooks& hooks,
                           OutsideMemory* outside, RaySource* source)
    : work_(work),
      architecture_(architecture),
      layout_(architecture.texels.layout, *work.pyramid),
      source_(std::make_unique<StepSource>(work_, layout_, architecture.height_l1.line_bytes, order_)),
      pipelines_(architecture.machine.pipelines),
      hosted_(outside != nullptr),
      rays_(source),
      at_once_(pipelines_ == 1 && hooks.stalls == nullptr && !hosted_),
      window_(architecture.dram.request_latency_cycles + architecture.dram.response_latency_cycles),
      step_(at_once_ || (pipelines_ == 1 && hosted_)
                ? kNever
                : std::min<Cycle>(architecture.ray_dispatch.credit_latency_cycles, window_)),
      dram_(hosted_ ? nullptr
                    : std::make_unique<DramLevel>(architecture.dram, granule_bytes(architecture), costs_)),
      outside_(hosted_ ? std::make_unique<OutsideLevel>(*outside, costs_) : nullptr),
      below_(hosted_ ? static_cast<MemoryLevel&>(*outside_) : *dram_),
      memory_(below_, at_once_),
      dispatch_(architecture.ray_dispatch, pipelines_, hooks.stalls) {
  if (work.arithmetic != architecture.traverse.arithmetic ||
      work.format != number_format(architecture.traverse, work.map)) {
    throw Error(ExitCode::kInternal,
                "The workload's numbers are not those of the architecture's [traverse] section.");
  }
  if (hosted_) dispatch_.open();
  if (rtl::has_rtl(architecture)) {
    rtl_ = std::make_unique<rtl::RtlJob>(work_, layout_, rtl::choose_set(architecture, work_),
                                         hooks.register_seed);
  } else if (!hooks.waves.file.empty()) {
    throw usage_error(
        "Waves are of hardware, and no unit of this machine is; accepted is --fidelity rtl, or "
        "units.traverse = \"rtl\".");
  }
  watchdog_.limit = architecture.machine.no_progress_cycles;
  const uint64_t stripe = Dram(architecture.dram, granule_bytes(architecture)).stripe_bytes();
  const uint64_t write_base = (image_bytes() + stripe - 1) / stripe * stripe;
  pipeline_.resize(static_cast<size_t>(pipelines_));
  if (hooks.port_logs != nullptr) hooks.port_logs->resize(pipeline_.size());
  for (int n = 0; n < pipelines_; ++n) {
    const int p = hooks.reverse_construction ? pipelines_ - 1 - n : n;
    const auto at = static_cast<size_t>(p);
    PortLog* log = hooks.port_logs == nullptr ? nullptr : &(*hooks.port_logs)[at];
    pipeline_[at] = std::make_unique<Pipeline>(*this, p, write_base, hooks, log);
  }
  if (at_once_) memory_.set_writer(&pipeline_[0]->writer);
}

CycleMachine::~CycleMachine() = default;

std::unique_ptr<HmtUnit> CycleMachine::make_hmt(const HmtSite& site, const CycleHooks& hooks) const {
  if (hooks.loosely_timed) return std::make_unique<HmtModel<RunAheadTraverse>>(site);
  if (!rtl_) return std::make_unique<HmtModel<TraverseUnit>>(site);
  const WaveWindow& waves = hooks.waves;
  std::unique_ptr<rtl::RtlUnit> unit = architecture_.units.hmt_top == Implementation::kRtl
                                           ? rtl::make_hmt_top_unit(*rtl_, site)
                                           : rtl::make_traverse_unit(*rtl_, site);
  if (!waves.file.empty() && waves.pipeline == site.pipeline)
    unit->record_waves(waves.file, waves.first, waves.last);
  return unit;
}

}  // namespace cuesta
