#include "sim/hosts/systemc/machine_shell.h"

#include <algorithm>
#include <string>

#include "models/common/error.h"
#include "models/rays/hit_bytes.h"
#include "sim/config/on_architecture.h"

#if defined(__SANITIZE_ADDRESS__)
// What stands on the stack of an SC_THREAD when the simulation ends is never destroyed, and the stacks are the
// kernel's: the leak checker's complaint names its library, whatever it is about.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_options();
const char* __lsan_default_suppressions() { return "leak:libsystemc\n"; }
const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace cuesta::systemc {

namespace {

constexpr Cycle kCyclesPerReport = 1 << 16;

Workload work_of(const MachineSetup& setup) {
  Workload work;
  work.pyramid = setup.pyramid;
  work.map = setup.map;
  set_numbers(work, *setup.architecture);
  work.width = setup.width;
  work.height = setup.height;
  work.schedule = setup.schedule;
  return work;
}

}  // namespace

MachineShell::MachineShell(const sc_core::sc_module_name& name, const ShellParameters& parameters)
    : sc_core::sc_module(name),
      memory_(
          "memory", parameters,
          [this](const MemoryTag& tag, const sc_core::sc_time& at) { answered(tag, at); },
          [this](const Error& error) { fail(std::make_exception_ptr(error)); }),
      parameters_(parameters) {
  SC_THREAD(run);
  set_stack_size(4 << 20);
}

MachineShell::~MachineShell() = default;

void MachineShell::load(const MachineSetup& setup, const Progress& progress) {
  const Architecture& architecture = *setup.architecture;
  setup_ = setup;
  progress_ = progress;
  format_ = number_format(architecture.traverse, setup.map);
  clock_.emplace(architecture.machine.clock_mhz, sc_core::sc_time_stamp());
  machine_ = std::make_unique<CycleMachine>(work_of(setup), architecture, static_cast<OutsideMemory&>(*this),
                                            nullptr);
  const auto most_in_a_window =
      static_cast<uint64_t>(machine_->window()) * static_cast<uint64_t>(architecture.machine.pipelines);
  hit_places_ = parameters_.hit_fifo == 0 ? 4 * most_in_a_window : parameters_.hit_fifo;
  if (hit_places_ < most_in_a_window) {
    throw usage_error("ShellParameters::hit_fifo is " + std::to_string(hit_places_) +
                      "; accepted are at least pipelines x (dram.request_latency_cycles + "
                      "response_latency_cycles) = " +
                      std::to_string(most_in_a_window) + " places, or 0.");
  }
  completed_.clear();
  machine_->log_completions(completed_);
  given_.assign(completed_.size(), 0);
  written_.assign(completed_.size(), 0);
  burst_.resize(static_cast<size_t>(architecture.result_writer.burst_bytes));
  ids_.clear();
  hits_.reset();
  rays_ended_ = done_ = stopped_ = false;
  fault_ = nullptr;
  if (waves_) {
    machine_->step_by(1);
    waves_->begin(*clock_, machine_->window());
  }
  loaded_.notify(sc_core::SC_ZERO_TIME);
}

void MachineShell::trace(sc_core::sc_trace_file* file, int pipelines) {
  waves_ = std::make_unique<MachineWaves>("waves", file, pipelines, memory_, hits_);
}

void MachineShell::run() {
  for (;;) {
    while (machine_ == nullptr || done_ || stopped_) wait(loaded_);
    try {
      const TexelLayout layout(setup_.architecture->texels.layout, *setup_.pyramid);
      memory_.load(layout.write_image(*setup_.pyramid),
                   std::max(setup_.architecture->height_l1.line_bytes,
                            setup_.architecture->result_writer.burst_bytes));
      run_machine();
    } catch (const Error&) {
      fail(std::current_exception());
    }
  }
}

void MachineShell::run_machine() {
  const Cycle window = machine_->window();
  Cycle report_at = kCyclesPerReport;
  for (Cycle from = 0; !stopped_;) {
    if (machine_->starved()) {
      wait(ray_came_);
      // Nothing happened in the windows since.
      const Cycle skipped = clock_->now() / window * window;
      if (skipped > from) advance(from, skipped);
      from = std::max(from, skipped);
    }
    const Cycle end = from + window;
    wait(clock_->time_of(end) - sc_core::sc_time_stamp());
    advance(from, end);
    from = end;
    if (machine_->done()) {
      if (progress_) progress_(machine_->completed(), machine_->completed());
      done_ = true;
      return;
    }
    if (end >= report_at) {
      report_at += kCyclesPerReport;
      if (progress_ && !progress_(machine_->completed(), ids_.size())) {
        stopped_ = true;
        sc_core::sc_stop();
      }
    }
  }
}

/// The machine's cycles `from` to `end` - 1; it is socket cycle `end`.
void MachineShell::advance(Cycle from, Cycle end) {
  const auto most = static_cast<size_t>(end - from) * completed_.size();
  if (hits_.bound() && !machine_->starved() && hits_.waiting() + most > hit_places_) {
    machine_->hold_hits_until(end);
  }
  if (!waves_) {
    machine_->advance(end);
    send_hits();
  } else {
    for (Cycle cycle = from; cycle < end; ++cycle) {
      machine_->advance(cycle + 1);
      send_hits();
      waves_->sample(cycle, *machine_);
    }
  }
  rays_.room.notify(sc_core::SC_ZERO_TIME);
}

void MachineShell::send_hits() {
  window_hits_.clear();
  if (!hits_.bound()) return;
  for (size_t p = 0; p < completed_.size(); ++p) {
    while (given_[p] < completed_[p].size()) {
      const uint32_t ray = completed_[p][given_[p]++];
      window_hits_.push_back({machine_->timing(ray).completed, ray});
    }
  }
  std::stable_sort(window_hits_.begin(), window_hits_.end(),
                   [](const Completion& a, const Completion& b) { return a.cycle < b.cycle; });
  for (const Completion& hit : window_hits_) {
    hits_.send(machine_->hit(hit.ray), clock_->time_of(hit.cycle + machine_->window()));
  }
}

/// Called by the machine within `advance`.
void MachineShell::request(uint64_t number, const MemoryRequest& request) {
  const sc_core::sc_time at = clock_->time_of(request.leaves + machine_->window());
  if (!request.write) return memory_.send(number, request, at, nullptr);
  // Records leave hit_queue, and so enter the burst, in the order in which their rays complete.
  const auto p = static_cast<size_t>(request.pipeline);
  std::fill(burst_.begin(), burst_.end(), uint8_t{0});
  for (size_t byte = 0; byte < burst_.size() && written_[p] < completed_[p].size(); byte += kHitRecordBytes) {
    encode_hit(machine_->hit(completed_[p][written_[p]++]), burst_.data() + byte);
  }
  memory_.send(number, request, at, burst_.data());
}

void MachineShell::answered(const MemoryTag& tag, const sc_core::sc_time& at) {
  if (done_ || stopped_) return;
  machine_->answer(tag.number, clock_->cycle_from(at), tag.bus_clocks, tag.row_activations);
}

bool MachineShell::full() const {
  return parameters_.ray_fifo != 0 && machine_->unsent() >= parameters_.ray_fifo;
}

void MachineShell::take(const TracedRay& ray) {
  const std::string fault = fault_of(ray, setup_.width, setup_.height);
  try {
    if (!fault.empty()) {
      throw input_error("The ray with id " + std::to_string(ray.id) + ", number " +
                        std::to_string(ids_.size()) + " at " + std::string(name()) +
                        ".rays_in, cannot be used: " + fault + ".");
    }
    machine_->ray_arrives(quantise(ray, setup_.map, format_),
                          ray.pixel_y * static_cast<uint32_t>(setup_.width) + ray.pixel_x, clock_->now());
    ids_.push_back(ray.id);
    ray_came_.notify(sc_core::SC_ZERO_TIME);
  } catch (const Error&) {
    fail(std::current_exception());
  }
}

void MachineShell::end_of_rays() {
  rays_ended_ = true;
  machine_->end_of_rays(clock_->now());
  ray_came_.notify(sc_core::SC_ZERO_TIME);
  try {
    require_distinct_ids(ids_, std::string(name()) + ".rays_in");
  } catch (const Error&) {
    fail(std::current_exception());
  }
}

void MachineShell::fail(std::exception_ptr fault) {
  if (!fault_) fault_ = std::move(fault);
  stopped_ = true;
  sc_core::sc_stop();
}

void MachineShell::check_finished() const {
  if (fault_) std::rethrow_exception(fault_);
  if (done_ || stopped_) return;
  throw Error(ExitCode::kNoProgress,
              "The simulation ended at " + sc_core::sc_time_stamp().to_string() + ", before " +
                  std::string(name()) + " had finished" +
                  (rays_ended_ ? "" : "; the end of the rays was never written to rays_in") + ": " +
                  machine_->who_waits());
}

Outcome MachineShell::outcome() {
  check_finished();
  return machine_->outcome(!stopped_, false, nullptr);
}

Outcome MachineShell::outcome(const Workload& work, std::span<const uint32_t> position,
                              const Dram::Counts* dram) {
  check_finished();
  return machine_->outcome(work, position, !stopped_, dram);
}

}  // namespace cuesta::systemc
