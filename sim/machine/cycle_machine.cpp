#include "sim/machine/cycle_machine.h"

#include <algorithm>

#include "models/common/error.h"
#include "models/units/machine_statistics.h"
#include "models/units/ray_dispatch/dispatch_order.h"
#include "sim/machine/pipeline.h"
#include "sim/machine/time_measurements.h"

namespace cuesta {

namespace {

constexpr Cycle kCyclesPerReport = 1 << 20;

}  // namespace

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

void CycleMachine::trace_arrives(std::span<const MachineRay> rays, std::span<const uint32_t> pixels) {
  work_.rays = rays;
  work_.pixel_of_ray = pixels;
  order_ = dispatch_order(pixels, work_.width, architecture_.ray_dispatch.order,
                          architecture_.ray_dispatch.tile_size);
  add_rays(0);
  dispatch_.trace_arrives(static_cast<uint32_t>(order_.size()), targets());
}

void CycleMachine::add_rays(uint32_t first) {
  costs_.resize(order_.size());
  timing_.resize(order_.size());
  hits_.resize(order_.size());
  for (size_t k = first; k < hits_.size(); ++k) {
    hits_[k].ray_id = work_.rays[k].id;
    hits_[k].status = HitStatus::kDidNotFinish;
  }
}

void CycleMachine::ray_arrives(const MachineRay& ray, uint32_t pixel, Cycle cycle) {
  const auto number = static_cast<uint32_t>(order_.size());
  if (arrived_.empty()) {  // behind a trace
    arrived_.assign(work_.rays.begin(), work_.rays.end());
    arrived_pixel_.assign(work_.pixel_of_ray.begin(), work_.pixel_of_ray.end());
  }
  arrived_.push_back(ray);
  arrived_pixel_.push_back(pixel);
  work_.rays = arrived_;
  work_.pixel_of_ray = arrived_pixel_;
  order_.push_back(number);
  add_rays(number);
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
  if (rays_ != nullptr) rays_->bring_until(end, *this);
  below_.deliver_until(end);
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
  return below_.in_flight() == 0 && std::all_of(pipeline_.begin(), pipeline_.end(), [](const auto& p) {
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
  collect(kMachineCounters, {cycles}, kNoInstance, counters);
  collect(kRayDispatchCounters, dispatch_.counts(), kNoInstance, counters);
  for (int p = 0; p < pipelines_; ++p) {
    const Pipeline& units = *pipeline_[static_cast<size_t>(p)];
    const HmtUnit::Counts hmt = units.hmt->counts(cycles);
    collect(kRaySetupCounters, hmt.ray_setup, p, counters);
    collect(kTraverseCounters, hmt.traverse, p, counters);
    collect(kHeightL1Counters, hmt.height_l1, p, counters);
    collect(kHitQueueCounters, units.hit_queue.counts(), p, counters);
    collect(kResultWriterCounters, units.writer.counts(), p, counters);
  }
  const DramTraffic& traffic = hosted_ ? outside_->counts() : dram_->counts();
  collect(kDramTraffic, traffic, kNoInstance, counters);
  if (dram != nullptr) collect(kDramCounters, *dram, kNoInstance, counters);
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
