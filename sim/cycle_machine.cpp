#include "sim/cycle_machine.h"

#include <algorithm>
#include <memory>

#include "models/dispatch/dispatch_order.h"
#include "models/dispatch/ray_dispatch.h"
#include "models/memory/dram.h"
#include "models/memory/height_l1.h"
#include "models/output/hit_queue.h"
#include "models/output/result_writer.h"
#include "models/traversal/ray_setup_unit.h"
#include "sim/outcome.h"
#include "sim/traversal_source.h"

namespace cuesta {

namespace {

constexpr Cycle kCyclesPerReport = 1 << 20;

/// The machine: instances and bindings.
class CycleMachine {
 public:
  CycleMachine(const Workload& work, const Architecture& architecture, const CycleHooks& hooks)
      : work_(work),
        architecture_(architecture),
        layout_(architecture.texels.layout, *work.pyramid),
        order_(dispatch_order(work.pixel_of_ray, work.width, architecture.ray_dispatch.order,
                              architecture.ray_dispatch.tile_size)),
        source_(make_traversal_source(work, architecture, layout_, order_)),
        pipelines_(architecture.machine.pipelines),
        windows_(pipelines_ > 1 || hooks.stalls != nullptr),
        costs_(work.rays.size()),
        timing_(work.rays.size()),
        hits_(work.rays.size()),
        dram_(architecture.dram,
              std::max(architecture.height_l1.line_bytes, architecture.result_writer.burst_bytes)),
        memory_(dram_, architecture.dram.request_latency_cycles, !windows_, costs_),
        dispatch_(architecture.ray_dispatch, pipelines_, static_cast<uint32_t>(work.rays.size()), targets(),
                  hooks.stalls) {
    for (size_t k = 0; k < hits_.size(); ++k) {
      hits_[k].ray_id = work.rays[k].id;
      hits_[k].status = HitStatus::kDidNotFinish;
    }
    watchdog_.limit = architecture.machine.no_progress_cycles;
    const uint64_t stripe = dram_.stripe_bytes();
    const uint64_t write_base = (layout_.size_bytes() + stripe - 1) / stripe * stripe;
    pipeline_.resize(static_cast<size_t>(pipelines_));
    for (int n = 0; n < pipelines_; ++n) {
      const int p = hooks.reverse_construction ? pipelines_ - 1 - n : n;
      pipeline_[static_cast<size_t>(p)] = std::make_unique<Pipeline>(*this, p, write_base, hooks.stalls);
    }
    if (!windows_) memory_.set_writer(&pipeline_[0]->writer);
  }

  /// False: ended early by `progress`.
  bool run(const Progress& progress) {
    const DramParameters& dram = architecture_.dram;
    const Cycle window = windows_
                             ? std::min<Cycle>(architecture_.ray_dispatch.credit_latency_cycles,
                                               dram.request_latency_cycles + dram.response_latency_cycles)
                             : kCyclesPerReport;
    Cycle report_at = kCyclesPerReport;
    for (Cycle end = window; !done(); end += window) {
      dispatch_.set_horizon(windows_ ? end : kNever);
      dispatch_.advance();
      for (auto& p : pipeline_) {
        p->traverse.advance(end);
        if (p->traverse.finished()) {
          p->writer.finish(dispatch_.last_sent() + architecture_.ray_dispatch.latency_cycles);
        }
        p->writer.advance(windows_ || !p->traverse.finished() ? end : kNever);
      }
      memory_.serve_until(end);
      if (end >= report_at) {
        report_at += kCyclesPerReport;
        if (progress && !progress(completed(), work_.rays.size())) return false;
      }
    }
    if (progress) progress(completed(), work_.rays.size());
    return true;
  }

  Outcome outcome(bool finished, bool counters_only, CycleDetail* detail) {
    Cycle cycles = 0;
    for (auto& p : pipeline_)
      cycles = std::max({cycles, p->writer.counts().last_acknowledged + 1, p->traverse.cycle()});
    if (work_.rays.empty()) cycles = 0;
    for (auto& p : pipeline_) p->traverse.drain_until(cycles);

    Outcome result;
    result.hits = std::move(hits_);
    result.finished_rays = completed();
    count(result.measurements.counters, cycles);
    if (counters_only) return result;
    std::vector<MemoryCost> memory(costs_.size());
    for (size_t k = 0; k < order_.size(); ++k) memory[order_[k]] = costs_[k];
    add_ray_measurements(work_, result.hits, timing_, memory, pipelines_ * cycles, result.measurements);
    seal(work_, finished, result);
    if (detail != nullptr) {
      detail->timing = std::move(timing_);
      detail->memory = std::move(memory);
    }
    return result;
  }

 private:
  struct Pipeline {
    Pipeline(CycleMachine& m, int p, uint64_t write_base, const PortStalls* stalls)
        : hit_queue(m.architecture_.hit_queue.depth),
          writer(m.architecture_.result_writer, write_base, m.pipelines_, p, hit_queue, m.memory_, stalls),
          l1(m.architecture_.height_l1, m.architecture_.traverse.contexts, m.layout_.size_bytes(), p,
             m.memory_, stalls),
          setup(m.architecture_.ray_setup, m.architecture_.ray_dispatch, p, m.dispatch_, stalls),
          traverse(m.architecture_.traverse, *m.source_, m.order_, p, m.dispatch_, setup, l1, hit_queue,
                   writer, m.hits_, m.timing_, m.watchdog_, stalls) {}

    HitQueue hit_queue;
    ResultWriter writer;
    HeightL1 l1;
    RaySetupUnit setup;
    TraverseUnit traverse;
  };

  std::vector<uint16_t> targets() const {
    if (architecture_.ray_dispatch.assign == DispatchAssign::kFirstFree) return {};
    std::vector<uint16_t> targets(order_.size());
    for (size_t k = 0; k < order_.size(); ++k) {
      targets[k] = static_cast<uint16_t>(
          tile_number(work_.pixel_of_ray[order_[k]], work_.width, architecture_.ray_dispatch.tile_size) %
          static_cast<uint32_t>(pipelines_));
    }
    return targets;
  }

  bool done() const {
    return std::all_of(pipeline_.begin(), pipeline_.end(),
                       [](const auto& p) { return p->traverse.finished() && p->writer.idle(); });
  }

  uint64_t completed() const {
    uint64_t rays = 0;
    for (auto& p : pipeline_) rays += static_cast<uint64_t>(p->traverse.counts().rays);
    return rays;
  }

  void count(Counters& counters, Cycle cycles) const;

  const Workload& work_;
  const Architecture& architecture_;
  TexelLayout layout_;
  std::vector<uint32_t> order_;
  std::unique_ptr<StepSource> source_;
  int pipelines_;
  bool windows_;  ///< pipelines advance in turn, a window at a time
  std::vector<MemoryCost> costs_;
  std::vector<RayTiming> timing_;
  std::vector<HitRecord> hits_;
  Watchdog watchdog_;
  Dram dram_;
  MemoryPort memory_;
  RayDispatch dispatch_;
  std::vector<std::unique_ptr<Pipeline>> pipeline_;
};

void CycleMachine::count(Counters& counters, Cycle cycles) const {
  counters.set("machine.cycles", cycles);
  counters.set("ray_dispatch.rays", dispatch_.sent());
  for (size_t p = 0; p < pipeline_.size(); ++p) {
    const Pipeline& unit = *pipeline_[p];
    const std::string index = "[" + std::to_string(p) + "].";
    auto set = [&](const char* name, const char* statistic, int64_t value) {
      counters.set(name + index + statistic, value);
    };
    set("ray_setup", "rays", unit.setup.entered());
    const auto& t = unit.traverse.counts();
    set("traverse", "cycles", t.total());
    set("traverse", "rays", t.rays);
    set("traverse", "hits", t.hits);
    set("traverse", "slots_step", t.steps);
    set("traverse", "slots_miss", t.miss_slots);
    set("traverse", "slots_refused", t.refused_slots);
    set("traverse", "slots_dead", t.dead_slots);
    set("traverse", "bubble_contexts_full", t.contexts_full);
    set("traverse", "bubble_no_ray", t.no_ray);
    set("traverse", "bubble_drain", t.drain);
    set("traverse", "stall_hit_queue", t.stalls);
    set("traverse", "replays", t.replays);
    set("traverse", "resident_cycles", t.resident_cycles);
    const HeightL1::Counts& l1 = unit.l1.counts();
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
    set("hit_queue", "max_fill", unit.hit_queue.max_fill());
    const ResultWriter::Counts& writer = unit.writer.counts();
    set("result_writer", "records", writer.records);
    set("result_writer", "bursts", writer.bursts);
    set("result_writer", "bytes", writer.bytes);
  }
  const Dram::Counts& dram = dram_.counts();
  counters.set("dram.reads", dram.reads);
  counters.set("dram.writes", dram.writes);
  counters.set("dram.read_bytes", dram.read_bytes);
  counters.set("dram.write_bytes", dram.write_bytes);
  counters.set("dram.row_hits", dram.row_hits);
  counters.set("dram.row_misses", dram.row_misses);
  counters.set("dram.row_conflicts", dram.row_conflicts);
  counters.set("dram.bus_clocks", dram.bus_clocks);
}

}  // namespace

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
