#include "sim/hosts/systemc/machine_waves.h"

#include <algorithm>
#include <string>

namespace cuesta::systemc {

MachineWaves::MachineWaves(const sc_core::sc_module_name& name, sc_core::sc_trace_file* file, int pipelines,
                           const MemoryOut& memory, const HitsOut& hits)
    : sc_core::sc_module(name), memory_(memory), hits_(hits), fill_(static_cast<size_t>(pipelines)) {
  SC_METHOD(show);
  sensitive << next_;
  dont_initialize();
  sc_core::sc_trace(file, cycle_, "machine.cycle");
  sc_core::sc_trace(file, rays_unsent_, "ray_dispatch.waiting");
  sc_core::sc_trace(file, request_phase_, "memory_out.request_phase");
  sc_core::sc_trace(file, address_, "memory_out.address");
  sc_core::sc_trace(file, requests_waiting_, "memory_out.waiting");
  sc_core::sc_trace(file, requests_in_flight_, "memory_out.outstanding");
  sc_core::sc_trace(file, hits_waiting_, "hits_out.waiting");
  sc_core::sc_trace(file, hits_sent_, "hits_out.records");
  for (size_t p = 0; p < fill_.size(); ++p) {
    const auto signal = [&](const int& value, const std::string& unit, const char* what) {
      sc_core::sc_trace(file, value, unit + "_" + std::to_string(p) + "." + what);
    };
    signal(fill_[p].rays_before_traverse, "ray_setup", "rays");
    signal(fill_[p].contexts, "traverse", "contexts");
    signal(fill_[p].mshrs, "height_l1", "mshrs");
    signal(fill_[p].retries, "height_l1", "retries");
    signal(fill_[p].hit_queue, "hit_queue", "records");
    signal(fill_[p].burst_records, "result_writer", "records");
    signal(fill_[p].bursts, "result_writer", "bursts");
  }
}

void MachineWaves::begin(const MachineClock& clock, Cycle window) {
  clock_ = clock;
  window_ = window;
  samples_.clear();
}

void MachineWaves::sample(Cycle cycle, const CycleMachine& machine) {
  Sample& sample = samples_.emplace_back();
  sample.cycle = cycle;
  sample.rays_unsent = machine.unsent();
  for (size_t p = 0; p < std::min(fill_.size(), static_cast<size_t>(machine.pipelines())); ++p) {
    sample.fill.push_back(machine.fill(static_cast<int>(p)));
  }
  const sc_core::sc_time at = clock_->time_of(cycle + window_);
  const sc_core::sc_time& now = sc_core::sc_time_stamp();
  if (samples_.size() == 1) next_.notify(std::max(at, now) - now);
}

void MachineWaves::show() {
  const Sample& sample = samples_.front();
  cycle_ = static_cast<Word>(sample.cycle);
  rays_unsent_ = sample.rays_unsent;
  std::copy(sample.fill.begin(), sample.fill.end(), fill_.begin());
  request_phase_ = memory_.request_phase();
  address_ = memory_.last_address();
  requests_waiting_ = memory_.waiting();
  requests_in_flight_ = memory_.in_flight();
  hits_waiting_ = hits_.waiting();
  hits_sent_ = hits_.sent();
  samples_.pop_front();
  if (samples_.empty()) return;
  const sc_core::sc_time at = clock_->time_of(samples_.front().cycle + window_);
  const sc_core::sc_time& now = sc_core::sc_time_stamp();
  next_.notify(std::max(at, now) - now);
}

}  // namespace cuesta::systemc
