#include "sim/hardware/rtl_unit.h"

#include "models/common/error.h"

namespace cuesta::rtl {

RtlJob::RtlJob(const Workload& workload, const TexelLayout& texels, const RtlSet& compiled, int random_seed)
    : work(workload),
      layout(texels),
      set(compiled),
      image(texels.write_image(*workload.pyramid)),
      seed(random_seed) {
  image.resize(image.size() + static_cast<size_t>(compiled.parameters.line_bytes));
}

void RtlUnit::advance(Cycle limit) {
  while (cycle_ < limit && !finished()) {
    if (cycle_ == wave_first_) [[unlikely]]
      waves().open_waves(wave_file_, cycle_);
    tick();
    if (cycle_ == wave_last_) [[unlikely]]
      waves().close_waves();
    ++cycle_;
    if (site_.watchdog.expired(cycle_) && !starved()) {
      throw Error(ExitCode::kNoProgress, "no step was finished for " + std::to_string(site_.watchdog.limit) +
                                             " cycles (machine.no_progress_cycles), since cycle " +
                                             std::to_string(site_.watchdog.last_progress) + ": " +
                                             who_waits());
    }
  }
}

void RtlUnit::drain_until(Cycle end) {
  if (cycle_ < end) ended_ = std::min(ended_, cycle_);
  for (; cycle_ < end; ++cycle_) tick();
}

bool RtlUnit::finished() const {
  return inside() == 0 && site_.dispatch.queue(site_.pipeline).empty() && site_.dispatch.all_sent();
}

bool RtlUnit::starved() const {
  return inside() == 0 && site_.dispatch.queue(site_.pipeline).empty() && site_.dispatch.starved();
}

void RtlUnit::record_waves(const std::string& file, Cycle first, Cycle last) {
  wave_file_ = file;
  wave_first_ = first;
  wave_last_ = last;
}

Error RtlUnit::wrong(const std::string& what) const {
  return {ExitCode::kMismatch, name_ + "[" + std::to_string(site_.pipeline) + "] " + what + " in cycle " +
                                   std::to_string(cycle_) + "."};
}

Error RtlUnit::no_such_ray(uint32_t number) const {
  return wrong("works on ray " + std::to_string(number) + " of " + std::to_string(site_.order.size()));
}

Error RtlUnit::goes_nowhere(uint32_t number) const {
  return {ExitCode::kNoProgress, name_ + "[" + std::to_string(site_.pipeline) + "] has given ray " +
                                     std::to_string(number) + " more than " + std::to_string(most_slots_) +
                                     " slots by cycle " + std::to_string(cycle_) +
                                     ", more than any walk over the map takes; it has not ended."};
}

void RtlUnit::retire(HitRecord record, Cycle sent) {
  const auto number = static_cast<uint32_t>(record.ray_id);
  const uint32_t trace = site_.order[number];
  site_.sink.take(number, cycle_);
  record.ray_id = job_.work.rays[trace].id;
  site_.hits[trace] = record;
  RayTiming& timing = site_.timing[trace];
  timing.completed = cycle_;
  timing.latency = static_cast<uint32_t>(cycle_ - sent);
  timing.fetches = {record.steps, record.steps};
  site_.watchdog.last_progress = cycle_;
  if (completions_ != nullptr) completions_->push_back(trace);
  if (site_.log != nullptr) site_.log->hits.push_back({cycle_, number, record});
  ++rays_completed_;
  --in_context_;
}

}  // namespace cuesta::rtl
