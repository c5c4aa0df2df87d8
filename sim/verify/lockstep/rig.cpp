#include "sim/verify/lockstep/rig.h"

#include <algorithm>
#include <numeric>

#include "models/common/error.h"
#include "models/units/ray_dispatch/dispatch_order.h"
#include "sim/config/on_architecture.h"

namespace cuesta {
namespace {

bool any(const PortStalls& stalls) {
  return std::ranges::any_of(stalls.per_mille, [](uint16_t chance) { return chance > 0; });
}

}  // namespace

LockstepWork::LockstepWork(const LockstepCase& one, const LockstepMachine& machine)
    : pyramid(one.pyramid), format(number_format(machine.architecture.traverse, one.map())) {
  if (machine.schedule.stop_level > 0) {
    pyramid = std::make_shared<Pyramid>(build_stopped_pyramid(*one.pyramid, machine.schedule.stop_level));
  }
  rays.reserve(one.rays.size());
  pixels.reserve(one.rays.size());
  for (const TracedRay& ray : one.rays) {
    rays.push_back(quantise(ray, one.map(), format));
    pixels.push_back(ray.pixel_y * static_cast<uint32_t>(one.width) + ray.pixel_x);
  }
}

Workload LockstepWork::workload(const LockstepCase& one, const LockstepMachine& machine) const {
  Workload load;
  load.pyramid = pyramid.get();
  load.map = one.map();
  load.arithmetic = machine.architecture.traverse.arithmetic;
  load.format = format;
  load.rays = rays;
  load.pixel_of_ray = pixels;
  load.width = one.width;
  load.height = one.height;
  load.schedule = machine.schedule;
  return load;
}

bool LockstepWork::serves(const LockstepCase& one, const LockstepMachine& machine) const {
  return format == number_format(machine.architecture.traverse, one.map()) &&
         pyramid->lowest_level() == machine.schedule.stop_level;
}

LockstepRig::LockstepRig(const LockstepCase& one, const LockstepMachine& machine,
                         std::shared_ptr<const LockstepWork> work, const WaveWindow& waves)
    : settings_(machine),
      work_(std::move(work)),
      layout_(machine.architecture.texels.layout, *work_->pyramid) {
  CycleHooks hooks;
  if (any(settings_.stalls)) hooks.stalls = &settings_.stalls;
  hooks.port_logs = &logs_;
  hooks.waves = waves;
  hooks.register_seed = machine.register_seed;
  const Workload load = work_->workload(one, machine);
  const DramParameters& dram = settings_.architecture.dram;
  if (settings_.memory) {
    memory_.emplace(*settings_.memory, dram.request_latency_cycles + dram.response_latency_cycles);
    machine_ = std::make_unique<CycleMachine>(load, settings_.architecture, *memory_,
                                              static_cast<RaySource*>(this), hooks);
    order_.resize(work_->rays.size());
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) next_arrival_ = settings_.memory->gap_before(0);
  } else {
    machine_ = std::make_unique<CycleMachine>(load, settings_.architecture, hooks);
    order_ = dispatch_order(work_->pixels, one.width, settings_.architecture.ray_dispatch.order,
                            settings_.architecture.ray_dispatch.tile_size);
  }
}

void LockstepRig::advance(Cycle end) {
  try {
    while (!stuck_ && now_ < end) {
      const Cycle next = memory_ ? std::min(end, now_ + machine_->window()) : end;
      if (memory_) tell_answers();
      machine_->advance(next);
      now_ = next;
    }
  } catch (const Error& error) {
    if (error.code() != ExitCode::kNoProgress && error.code() != ExitCode::kMismatch) throw;
    stuck_ = error;
  }
}

/// Tells the machine what the random memory has answered since.
void LockstepRig::tell_answers() {
  for (const RandomMemory::Answer& answer : memory_->answers())
    machine_->answer(answer.number, answer.response, 0, 0);
  memory_->answers().clear();
}

void LockstepRig::bring_until(Cycle limit, RayIntake& machine) {
  while (arrived_ < work_->rays.size() && next_arrival_ < limit) {
    machine.ray_arrives(work_->rays[arrived_], work_->pixels[arrived_], next_arrival_);
    if (++arrived_ < work_->rays.size()) next_arrival_ += settings_.memory->gap_before(arrived_);
  }
  if (arrived_ == work_->rays.size() && !ended_) {
    ended_ = true;
    machine.end_of_rays(next_arrival_);
  }
}

}  // namespace cuesta
