#include "tests/twins/ticking_machine.h"

#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace cuesta::twins {
namespace {

uint64_t rounded_up(uint64_t value, uint64_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

}  // namespace

TickingMachine::TickingMachine(const Architecture& architecture, const PortStalls& stalls, RayValues& values,
                               std::span<const uint32_t> pixels, int width, uint64_t image_bytes,
                               std::vector<int> evaluation_order)
    : architecture_(architecture),
      values_(values),
      write_base_(rounded_up(image_bytes, static_cast<uint64_t>(architecture.dram.row_bytes) *
                                              static_cast<uint64_t>(architecture.dram.channels) *
                                              static_cast<uint64_t>(architecture.dram.banks))),
      ray_dispatch_(architecture.ray_dispatch, architecture.machine.pipelines, pixels, width, stalls),
      dram_(architecture.dram, architecture.height_l1.line_bytes, architecture.result_writer.burst_bytes,
            architecture.machine.pipelines, stalls),
      order_(std::move(evaluation_order)) {
  const int count = architecture.machine.pipelines;
  for (int p = 0; p < count; ++p) {
    pipelines_.push_back(
        {RaySetupTwin(architecture.ray_setup, architecture.ray_dispatch.latency_cycles, p, stalls),
         TraverseTwin(architecture.traverse, architecture.height_l1.line_bytes, p, stalls, values),
         HeightL1Twin(architecture.height_l1, p, stalls),
         HitQueueTwin(architecture.hit_queue),
         ResultWriterTwin(architecture.result_writer, p, stalls),
         {}});
  }
  if (order_.empty()) {
    order_.resize(static_cast<size_t>(count));
    std::iota(order_.begin(), order_.end(), 0);
  }
  result_.rays.resize(pixels.size());
  result_.hits.resize(pixels.size());
  result_.pipelines.resize(static_cast<size_t>(count));
}

TickingResult TickingMachine::run(Cycle patience) {
  Cycle cycle = 0;
  while (!finished()) {
    tick(cycle);
    if (cycle - last_progress_ > patience) {
      throw std::runtime_error("the ticking machine stands still in cycle " + std::to_string(cycle));
    }
    ++cycle;
  }
  result_.cycles = cycle;
  for (size_t p = 0; p < pipelines_.size(); ++p) {
    PipelineCounts& counts = result_.pipelines[p];
    counts.records = pipelines_[p].result_writer.records();
    counts.bursts = pipelines_[p].result_writer.bursts();
    counts.resident_cycles = pipelines_[p].traverse.resident_cycles();
    counts.mshr_cycles = pipelines_[p].height_l1.mshr_cycles();
    counts.evictions = pipelines_[p].height_l1.evictions();
    counts.unique_lines = pipelines_[p].height_l1.unique_lines();
    counts.pushes = pipelines_[p].hit_queue.pushes();
    counts.pops = pipelines_[p].hit_queue.pops();
    counts.record_cycles = pipelines_[p].hit_queue.record_cycles();
    counts.most_records = pipelines_[p].hit_queue.most();
  }
  result_.dram = dram_.counts();
  return std::move(result_);
}

void TickingMachine::tick(Cycle cycle) {
  const std::optional<RayDispatchTwin::Sent> sent = ray_dispatch_.evaluate(cycle);
  for (const int p : order_) tick_pipeline(p, cycle);
  if (sent) {
    pipelines_[sent->pipeline].ray_setup.receive(sent->ray, cycle);
    result_.rays[sent->ray].sent = cycle;
    result_.rays[sent->ray].pipeline = sent->pipeline;
    ++result_.pipelines[sent->pipeline].rays;
  }
  for (Pipeline& pipeline : pipelines_) {
    for (const DramTwin::Request& request : pipeline.requests) dram_.send(request, cycle);
    pipeline.requests.clear();
  }
  dram_.evaluate(cycle);
  for (const DramTwin::Cost& cost : dram_.new_costs()) {
    RayTimes& ray = result_.rays[cost.request.owner];
    if (cost.request.write)
      ray.write_bytes += architecture_.result_writer.burst_bytes;
    else
      ray.fill_bytes += architecture_.height_l1.line_bytes;
    ray.row_activations += cost.activated ? 1 : 0;
    ray.bus_clocks += cost.bus_clocks;
  }
  ray_dispatch_.commit();
  for (Pipeline& pipeline : pipelines_) {
    pipeline.ray_setup.commit();
    pipeline.traverse.commit();
    pipeline.height_l1.commit();
    pipeline.hit_queue.commit();
    pipeline.result_writer.commit();
  }
}

void TickingMachine::tick_pipeline(int p, Cycle cycle) {
  Pipeline& pipeline = pipelines_[p];
  // At the end of the cycle before:
  const bool no_more = ray_dispatch_.all_sent() && pipeline.ray_setup.empty();
  const bool last = no_more &&
                    cycle >= ray_dispatch_.last_sent() + architecture_.ray_dispatch.latency_cycles &&
                    pipeline.traverse.empty() && pipeline.hit_queue.empty();

  if (const std::optional<int> mshr = dram_.landing_read(p, cycle)) {
    pipeline.height_l1.land(*mshr);
    ++result_.pipelines[p].fills;
  }
  for (int left = dram_.landing_writes(p, cycle); left > 0; --left) {
    pipeline.result_writer.acknowledge();
    last_progress_ = cycle;
  }

  account(
      p,
      pipeline.traverse.evaluate(cycle, pipeline.ray_setup, pipeline.height_l1, pipeline.hit_queue, no_more),
      cycle);
  if (const auto request = pipeline.height_l1.evaluate_request(cycle)) {
    const auto line_bytes = static_cast<uint64_t>(architecture_.height_l1.line_bytes);
    pipeline.requests.push_back({p, false, request->mshr, request->line * line_bytes, request->owner});
  }
  if (const auto burst = pipeline.result_writer.evaluate(cycle, pipeline.hit_queue, last)) {
    const auto place = static_cast<uint64_t>(burst->number) * pipelines_.size() + static_cast<uint64_t>(p);
    const uint64_t address =
        write_base_ + place * static_cast<uint64_t>(architecture_.result_writer.burst_bytes);
    pipeline.requests.push_back({p, true, 0, address, burst->owner});
  }
  if (pipeline.ray_setup.evaluate(cycle)) {
    ray_dispatch_.give_back(p, cycle);
    ++result_.pipelines[p].rays_entered;
  }
}

void TickingMachine::account(int p, const TraverseTwin::Event& event, Cycle cycle) {
  using Answer = HeightL1Twin::Answer;
  PipelineCounts& counts = result_.pipelines[p];
  ++counts.cycles[static_cast<size_t>(event.kind)];
  if (event.issued >= 0) ++result_.rays[event.issued].issue_slots;
  if (event.completed >= 0) {
    result_.rays[event.completed].completed = cycle;
    result_.hits[event.completed] = values_.record(event.completed);
    ++counts.rays_completed;
    counts.rays_hit += result_.hits[event.completed].status == HitStatus::kHit;
    last_progress_ = cycle;
  }
  if (event.lookup) {
    ++counts.lookups;
    counts.hits += *event.lookup == Answer::kHit;
    counts.merged += *event.lookup == Answer::kMerged;
    counts.allocated += *event.lookup == Answer::kAllocated;
    result_.rays[event.issued].misses += *event.lookup == Answer::kAllocated;
    counts.refused += *event.lookup == Answer::kRefused;
  }
  counts.replays += event.replayed;
  counts.retries += event.retried;
  counts.kept_steps += event.kept;
  counts.fetched_texels += event.texels;
}

bool TickingMachine::finished() const {
  if (!ray_dispatch_.all_sent()) return false;
  for (const Pipeline& pipeline : pipelines_) {
    if (!pipeline.ray_setup.empty() || !pipeline.traverse.empty() || !pipeline.hit_queue.empty() ||
        !pipeline.result_writer.idle()) {
      return false;
    }
  }
  return true;
}

}  // namespace cuesta::twins
