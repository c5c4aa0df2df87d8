#include "tests/rtl/rtl_machine.h"

#include "models/dispatch/dispatch_order.h"

namespace cuesta::rtl {

RtlMachine::RtlMachine(const twins::RandomMachine& machine, const HmtTopSet& set, const MakeHmtTop& make)
    : machine_(machine),
      architecture_(machine.architecture),
      work_(machine.work()),
      layout_(architecture_.texels.layout, machine.pyramid),
      image_(layout_.write_image(machine.pyramid)),
      order_(dispatch_order(machine.pixels, machine.width, architecture_.ray_dispatch.order,
                            architecture_.ray_dispatch.tile_size)),
      stalls_(machine.stalled ? machine.stalls : PortStalls{}) {
  image_.resize(image_.size() + static_cast<size_t>(set.line_bytes));
  for (const uint32_t k : order_) pixels_.push_back(machine.pixels[k]);
  dispatch_.emplace(architecture_.ray_dispatch, architecture_.machine.pipelines, pixels_, machine.width,
                    stalls_);
  dram_.emplace(architecture_.dram, architecture_.height_l1.line_bytes,
                architecture_.result_writer.burst_bytes, architecture_.machine.pipelines, stalls_);
  const uint64_t stripe = static_cast<uint64_t>(architecture_.dram.row_bytes) *
                          static_cast<uint64_t>(architecture_.dram.channels) *
                          static_cast<uint64_t>(architecture_.dram.banks);
  write_base_ = (layout_.size_bytes() + stripe - 1) / stripe * stripe;
  const NumberFormat format = number_format(architecture_.traverse, machine.map);
  for (int p = 0; p < architecture_.machine.pipelines; ++p) {
    pipelines_.push_back({make(),
                          {},
                          twins::HitQueueTwin(architecture_.hit_queue),
                          twins::ResultWriterTwin(architecture_.result_writer, p, stalls_),
                          {},
                          {},
                          0});
    HmtTopPort& top = *pipelines_.back().top;
    top.reset();
    configure(top, work_.schedule, machine.map, format, machine.pyramid.highest(), layout_);
    for (size_t c = 0; c < std::size(kCounters); ++c) {
      pipelines_.back().counters_at_start[c] = top.read_register(kRegisterCounter + static_cast<int>(c));
    }
    pipelines_.back().lines.resize(static_cast<size_t>(set.mshrs));
  }
  run_.hits.resize(order_.size());
  run_.completed.assign(order_.size(), -1);
}

RtlRun RtlMachine::run() {
  Cycle cycle = 0;
  for (; !finished(); ++cycle) {
    tick(cycle);
    if (cycle > kMostCycles) break;
  }
  run_.cycles = cycle;
  for (Pipeline& p : pipelines_) {
    auto& counters = run_.counters.emplace_back();
    for (size_t c = 0; c < std::size(kCounters); ++c) {
      counters[c] = p.top->read_register(kRegisterCounter + static_cast<int>(c)) - p.counters_at_start[c];
    }
  }
  return std::move(run_);
}

void RtlMachine::tick(Cycle cycle) {
  const auto sent = dispatch_->evaluate(cycle);
  std::vector<twins::DramTwin::Request> requests;
  for (size_t p = 0; p < pipelines_.size(); ++p) tick_pipeline(static_cast<int>(p), cycle, requests);
  if (sent) {
    pipelines_[static_cast<size_t>(sent->pipeline)].queue.push_back(
        {sent->ray, cycle + architecture_.ray_dispatch.latency_cycles});
  }
  for (const auto& request : requests) dram_->send(request, cycle);
  dram_->evaluate(cycle);
  dispatch_->commit();
  for (Pipeline& pipe : pipelines_) {
    pipe.top->clock();
    pipe.hit_queue.commit();
    pipe.writer.commit();
  }
}

void RtlMachine::tick_pipeline(int p, Cycle cycle, std::vector<twins::DramTwin::Request>& requests) {
  Pipeline& pipe = pipelines_[static_cast<size_t>(p)];
  const bool no_ray = dispatch_->all_sent() && pipe.queue.empty();
  const bool last = no_ray && cycle >= dispatch_->last_sent() + architecture_.ray_dispatch.latency_cycles &&
                    pipe.inside == 0 && pipe.hit_queue.empty();
  HmtTopPort::Inputs in;
  if (!pipe.queue.empty() && pipe.queue.front().from <= cycle &&
      !stalls_.blocked(Port::kDispatch, p, cycle)) {
    in.ray_number = static_cast<uint32_t>(pipe.queue.front().ray);
    in.ray = &machine_.rays[order_[in.ray_number]];
  }
  in.no_ray_to_come = no_ray;
  in.hit_ready = !pipe.hit_queue.full() && !stalls_.blocked(Port::kHitStream, p, cycle);
  in.request_ready = !stalls_.blocked(Port::kMemoryRequest, p, cycle);
  if (const std::optional<int> mshr = dram_->landing_read(p, cycle)) {
    in.fill_mshr = *mshr;
    in.fill_data = image_.data() + pipe.lines[static_cast<size_t>(*mshr)];
  }
  for (int left = dram_->landing_writes(p, cycle); left > 0; --left) pipe.writer.acknowledge();
  const HmtTopPort::Outputs out = pipe.top->evaluate(in);
  if (out.hit_valid && in.hit_ready) {
    HitRecord record = pipe.top->hit();
    const auto number = static_cast<size_t>(record.ray_id);
    const uint32_t trace = order_[number];
    record.ray_id = machine_.rays[trace].id;
    run_.hits[trace] = record;
    run_.completed[trace] = cycle;
    pipe.hit_queue.push(static_cast<int>(number));
    --pipe.inside;
  }
  if (out.request_valid && in.request_ready) {
    pipe.lines[static_cast<size_t>(out.request_mshr)] = out.request_address;
    requests.push_back({p, false, out.request_mshr, out.request_address, 0});
  }
  if (const auto burst = pipe.writer.evaluate(cycle, pipe.hit_queue, last)) {
    const auto place = static_cast<uint64_t>(burst->number) * pipelines_.size() + static_cast<uint64_t>(p);
    requests.push_back({p, true, 0,
                        write_base_ + place * static_cast<uint64_t>(architecture_.result_writer.burst_bytes),
                        burst->owner});
  }
  if (in.ray != nullptr && out.ray_ready) {
    pipe.queue.pop_front();
    ++pipe.inside;
    dispatch_->give_back(p, cycle);
  }
}

bool RtlMachine::finished() const {
  if (!dispatch_->all_sent()) return false;
  for (const Pipeline& pipe : pipelines_) {
    if (!pipe.queue.empty() || pipe.inside != 0 || !pipe.hit_queue.empty() || !pipe.writer.idle())
      return false;
  }
  return true;
}

}  // namespace cuesta::rtl
