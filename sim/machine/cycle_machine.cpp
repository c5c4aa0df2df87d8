#include "sim/machine/cycle_machine.h"

#include <algorithm>
#include <memory>

#include "models/common/error.h"
#include "models/units/dram/dram.h"
#include "models/units/hit_queue/hit_queue.h"
#include "models/units/ray_dispatch/dispatch_order.h"
#include "models/units/result_writer/result_writer.h"
#include "models/units/traverse/run_ahead_traverse.h"
#include "sim/config/on_architecture.h"
#include "sim/hardware/choose_set.h"
#include "sim/machine/time_measurements.h"

namespace cuesta {

namespace {

constexpr Cycle kCyclesPerReport = 1 << 20;

Workload without_rays(Workload work) {
  work.rays = {};
  work.pixel_of_ray = {};
  return work;
}

int granule_bytes(const Architecture& architecture) {
  return std::max(architecture.height_l1.line_bytes, architecture.result_writer.burst_bytes);
}

}  // namespace

struct CycleMachine::Pipeline {
  Pipeline(CycleMachine& m, int p, uint64_t write_base, const CycleHooks& hooks, PortLog* log)
      : hit_queue(m.architecture_.hit_queue.depth),
        writer(m.architecture_.result_writer, write_base, m.pipelines_, p, hit_queue, m.memory_,
               hooks.stalls),
        hmt(m.make_hmt({m.architecture_, p, m.image_bytes(), m.order_, *m.source_, m.dispatch_, m.memory_,
                        hit_queue, writer, m.hits_, m.timing_, m.watchdog_, hooks.stalls, log},
                       hooks)) {}

  HitQueue hit_queue;
  ResultWriter writer;
  std::unique_ptr<HmtUnit> hmt;
};

CycleMachine::CycleMachine(const Workload& work, const Architecture& architecture, const CycleHooks& hooks)
    : CycleMachine(work, architecture, hooks, nullptr) {}

CycleMachine::CycleMachine(const Workload& work, const Architecture& architecture, OutsideMemory& memory,
                           const CycleHooks& hooks)
    : CycleMachine(without_rays(work), architecture, hooks, &memory) {}

CycleMachine::CycleMachine(const Workload& work, const Architecture& architecture, const CycleHooks& hooks,
                           OutsideMemory* outside)
    : work_(work),
      architecture_(architecture),
      layout_(architecture.texels.layout, *work.pyramid),
      order_(dispatch_order(work.pixel_of_ray, work.width, architecture.ray_dispatch.order,
                            architecture.ray_dispatch.tile_size)),
      source_(std::make_unique<StepSource>(work_, layout_, architecture.height_l1.line_bytes, order_)),
      pipelines_(architecture.machine.pipelines),
      hosted_(outside != nullptr),
      at_once_(pipelines_ == 1 && hooks.stalls == nullptr && !hosted_),
      window_(architecture.dram.request_latency_cycles + architecture.dram.response_latency_cycles),
      step_(at_once_ || (pipelines_ == 1 && hosted_)
                ? kNever
                : std::min<Cycle>(architecture.ray_dispatch.credit_latency_cycles, window_)),
      costs_(work.rays.size()),
      timing_(work.rays.size()),
      hits_(work.rays.size()),
      dram_(hosted_ ? nullptr : std::make_unique<Dram>(architecture.dram, granule_bytes(architecture))),
      memory_(hosted_ ? MemoryPort(*outside, costs_)
                      : MemoryPort(*dram_, architecture.dram.request_latency_cycles, at_once_, costs_)),
      dispatch_(architecture.ray_dispatch, pipelines_, static_cast<uint32_t>(work.rays.size()), targets(),
                hooks.stalls) {
  if (work.arithmetic != architecture.traverse.arithmetic ||
      work.format != number_format(architecture.traverse, work.map)) {
    throw Error(ExitCode::kInternal,
                "The workload's numbers are not those of the architecture's [traverse] section.");
  }
  for (size_t k = 0; k < hits_.size(); ++k) {
    hits_[k].ray_id = work.rays[k].id;
    hits_[k].status = HitStatus::kDidNotFinish;
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

uint16_t CycleMachine::target_of(uint32_t pixel) const {
  return static_cast<uint16_t>(tile_number(pixel, work_.width, architecture_.ray_dispatch.tile_size) %
                               static_cast<uint32_t>(pipelines_));
}

std::vector<uint16_t> CycleMachine::targets() const {
  if (architecture_.ray_dispatch.assign == DispatchAssign::kFirstFree) return {};
  std::vector<uint16_t> targets(order_.size());
  for (size_t k = 0; k < order_.size(); ++k) targets[k] = target_of(work_.pixel_of_ray[order_[k]]);
  return targets;
}

void CycleMachine::ray_arrives(const MachineRay& ray, uint32_t pixel, Cycle cycle) {
  const auto number = static_cast<uint32_t>(order_.size());
  arrived_.push_back(ray);
  arrived_pixel_.push_back(pixel);
  work_.rays = arrived_;
  work_.pixel_of_ray = arrived_pixel_;
  order_.push_back(number);
  source_->set_rays(number + 1);
  costs_.emplace_back();
  timing_.emplace_back();
  HitRecord& hit = hits_.emplace_back();
  hit.ray_id = ray.id;
  hit.status = HitStatus::kDidNotFinish;
  dispatch_.arrive(cycle, target_of(pixel));
  watchdog_.last_progress = std::max(watchdog_.last_progress, cycle);
}

void CycleMachine::end_of_rays(Cycle cycle) { dispatch_.close(cycle); }

void CycleMachine::hold_hits_until(Cycle cycle) {
  for (auto& p : pipeline_) p->hmt->hold_hits_until(cycle);
}

void CycleMachine::log_completions(std::vector<std::vector<uint32_t>>& rays) {
  rays.resize(pipeline_.size());
  for (size_t p = 0; p < pipeline_.size(); ++p) pipeline_[p]->hmt->log_completions(&rays[p]);
}

void CycleMachine::advance(Cycle end) {
  if (hosted_) memory_.deliver_until(end);
  while (now_ < end) {
    now_ = std::min(end, now_ + step_);
    dispatch_.set_horizon(step_ == kNever ? kNever : now_);
    dispatch_.advance();
    for (auto& p : pipeline_) {
      p->hmt->advance(now_);
      if (p->hmt->finished()) {
        p->writer.finish(dispatch_.last_sent() + architecture_.ray_dispatch.latency_cycles);
      }
      p->writer.advance(at_once_ && p->hmt->finished() ? kNever : now_);
    }
    memory_.serve_until(now_);
  }
}

bool CycleMachine::run(const Progress& progress) {
  Cycle report_at = kCyclesPerReport;
  for (Cycle end = 0; !done();) {
    end += at_once_ ? kCyclesPerReport : step_;
    advance(end);
    if (end >= report_at) {
      report_at += kCyclesPerReport;
      if (progress && !progress(completed(), work_.rays.size())) return false;
    }
  }
  if (progress) progress(completed(), work_.rays.size());
  return true;
}

bool CycleMachine::done() const {
  return std::all_of(pipeline_.begin(), pipeline_.end(),
                     [](const auto& p) { return p->hmt->finished() && p->writer.idle(); });
}

bool CycleMachine::starved() const {
  return memory_.in_flight() == 0 && std::all_of(pipeline_.begin(), pipeline_.end(), [](const auto& p) {
           return p->hmt->starved() && p->writer.quiet();
         });
}

uint64_t CycleMachine::completed() const {
  uint64_t rays = 0;
  for (auto& p : pipeline_) rays += static_cast<uint64_t>(p->hmt->completed());
  return rays;
}

std::string CycleMachine::who_waits() const {
  std::string text;
  for (auto& p : pipeline_) text += (text.empty() ? "" : "; ") + p->hmt->who_waits();
  return text;
}

PipelineFill CycleMachine::fill(int pipeline) const {
  const Pipeline& p = *pipeline_[static_cast<size_t>(pipeline)];
  PipelineFill fill{p.hmt->fill()};
  fill.hit_queue = static_cast<int>(p.hit_queue.size());
  fill.burst_records = p.writer.filled();
  fill.bursts = p.writer.unacknowledged();
  return fill;
}

Outcome CycleMachine::outcome(bool finished, bool counters_only, CycleDetail* detail) {
  return outcome(work_, order_, finished, counters_only, hosted_ ? nullptr : &dram_->counts(), detail);
}

Outcome CycleMachine::outcome(const Workload& work, std::span<const uint32_t> position, bool finished,
                              const Dram::Counts* dram) {
  std::vector<HitRecord> hits(work.rays.size());
  std::vector<RayTiming> timing(work.rays.size());
  for (size_t k = 0; k < position.size(); ++k) {
    hits[position[k]] = hits_[k];
    timing[position[k]] = timing_[k];
  }
  hits_ = std::move(hits);
  timing_ = std::move(timing);
  return outcome(work, position, finished, false, dram, nullptr);
}

/// hits_ and timing_ are in the order of `work`, costs_ in the machine's order.
Outcome CycleMachine::outcome(const Workload& work, std::span<const uint32_t> position, bool finished,
                              bool counters_only, const Dram::Counts* dram, CycleDetail* detail) {
  const Cycle cycles = work.rays.empty() ? 0 : end_cycle();
  for (auto& p : pipeline_) p->hmt->drain_until(cycles);

  Outcome result;
  result.hits = std::move(hits_);
  result.finished_rays = completed();
  count(result.measurements.counters, cycles, dram);
  if (counters_only) return result;
  std::vector<MemoryCost> memory(costs_.size());
  for (size_t k = 0; k < position.size(); ++k) memory[position[k]] = costs_[k];
  add_ray_measurements(work, result.hits, timing_, memory, pipelines_ * cycles, dram != nullptr,
                       result.measurements);
  seal(work, finished, result);
  if (detail != nullptr) {
    detail->timing = std::move(timing_);
    detail->memory = std::move(memory);
  }
  return result;
}

void CycleMachine::count(Counters& counters, Cycle cycles, const Dram::Counts* dram) const {
  counters.set("machine.cycles", cycles);
  counters.set("ray_dispatch.rays", dispatch_.sent());
  for (size_t p = 0; p < pipeline_.size(); ++p) {
    const Pipeline& unit = *pipeline_[p];
    const std::string index = "[" + std::to_string(p) + "].";
    auto set = [&](const char* name, const char* statistic, int64_t value) {
      counters.set(name + index + statistic, value);
    };
    const HmtUnit::Counts hmt = unit.hmt->counts(cycles);
    set("ray_setup", "rays", hmt.setup_rays);
    const TraverseUnit::Counts& t = hmt.traverse;
    set("traverse", "cycles", t.total());
    set("traverse", "rays", t.rays);
    set("traverse", "hits", t.hits);
    set("traverse", "slots_step", t.steps);
    set("traverse", "slots_part", t.part_slots);
    set("traverse", "slots_compute", t.compute_slots);
    set("traverse", "slots_miss", t.miss_slots);
    set("traverse", "slots_refused", t.refused_slots);
    set("traverse", "slots_dead", t.dead_slots);
    set("traverse", "bubble_contexts_full", t.contexts_full);
    set("traverse", "bubble_no_ray", t.no_ray);
    set("traverse", "bubble_drain", t.drain);
    set("traverse", "stall_hit_queue", t.stalls);
    set("traverse", "replays", t.replays);
    set("traverse", "kept_steps", t.kept_steps);
    set("traverse", "line_accesses", t.steps - t.kept_steps + t.part_slots);
    set("traverse", "resident_cycles", t.resident_cycles);
    const HeightL1::Counts& l1 = hmt.height_l1;
    set("height_l1", "accesses", l1.accesses);
    set("height_l1", "hits", l1.hits);
    set("height_l1", "misses", l1.misses);
    set("height_l1", "merges", l1.merges);
    set("height_l1", "refused", l1.refused);
    set("height_l1", "fills", l1.fills);
    set("height_l1", "fill_bytes", l1.fills * architecture_.height_l1.line_bytes);
    set("height_l1", "evictions", l1.evictions);
    set("height_l1", "unique_lines", l1.unique_lines);
    set("height_l1", "mshr_cycles", l1.mshr_cycles);
    set("hit_queue", "pushes", unit.hit_queue.pushes());
    set("hit_queue", "pops", unit.hit_queue.pops());
    set("hit_queue", "waited_cycles", unit.hit_queue.waited_cycles());
    set("hit_queue", "max_fill", static_cast<int64_t>(unit.hit_queue.max_fill()));
    const ResultWriter::Counts& writer = unit.writer.counts();
    set("result_writer", "records", writer.records);
    set("result_writer", "bursts", writer.bursts);
    set("result_writer", "bytes", writer.bytes);
  }
  const MemoryPort::Counts& outside = memory_.outside_counts();
  counters.set("dram.reads", hosted_ ? outside.reads : dram->reads);
  counters.set("dram.writes", hosted_ ? outside.writes : dram->writes);
  counters.set("dram.read_bytes", hosted_ ? outside.read_bytes : dram->read_bytes);
  counters.set("dram.write_bytes", hosted_ ? outside.write_bytes : dram->write_bytes);
  if (dram == nullptr) return;
  counters.set("dram.row_hits", dram->row_hits);
  counters.set("dram.row_misses", dram->row_misses);
  counters.set("dram.row_conflicts", dram->row_conflicts);
  counters.set("dram.bus_clocks", dram->bus_clocks);
}

Cycle CycleMachine::end_cycle() const {
  Cycle cycles = dispatch_.closed() + 1;
  for (auto& p : pipeline_)
    cycles = std::max({cycles, p->writer.counts().last_acknowledged + 1, p->hmt->cycle()});
  return cycles;
}

Counters CycleMachine::counters() const {
  Counters counters;
  count(counters, now_, hosted_ ? nullptr : &dram_->counts());
  return counters;
}

Outcome run_cycle_detailed(const Workload& work, const Architecture& architecture, const Progress& progress,
                           const CycleHooks& hooks, CycleDetail* detail) {
  CycleMachine machine(work, architecture, hooks);
  const bool finished = machine.run(progress);
  return machine.outcome(finished, hooks.counters_only, detail);
}

Outcome run_cycle(const Workload& work, const Architecture& architecture, const Progress& progress) {
  return run_cycle_detailed(work, architecture, progress, {}, nullptr);
}

}  // namespace cuesta
