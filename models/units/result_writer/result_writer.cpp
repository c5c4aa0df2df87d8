#include "models/units/result_writer/result_writer.h"

#include <algorithm>

#include "models/rays/hit.h"

namespace cuesta {

ResultWriter::ResultWriter(const ResultWriterParameters& parameters, uint64_t base, int pipelines,
                           int pipeline, HitQueue& queue, MemoryPort& memory, const PortStalls* stalls)
    : records_per_burst_(parameters.burst_bytes / kHitRecordBytes),
      burst_bytes_(parameters.burst_bytes),
      base_(base),
      pipelines_(pipelines),
      pipeline_(pipeline),
      queue_(queue),
      memory_(memory),
      stalls_(stalls),
      acknowledged_(static_cast<size_t>(parameters.outstanding), -1) {}

ResultWriter::Step ResultWriter::step(Cycle limit) {
  if (filled_ == records_per_burst_) return send(limit, last_cycle_ + 1);
  if (queue_.empty()) {
    if (filled_ == 0 || finish_from_ == kNever) return Step::kNothing;
    return send(limit, std::max(last_cycle_ + 1, finish_from_));
  }
  const Cycle cycle = PortStalls::free_from(stalls_, Port::kResult, pipeline_,
                                            std::max(last_cycle_, queue_.front().pushed) + 1);
  if (cycle >= limit) return Step::kNothing;
  if (filled_ == 0) first_ray_ = queue_.front().ray;
  queue_.pop(cycle);
  ++filled_;
  ++counts_.records;
  last_cycle_ = cycle;
  return Step::kTook;
}

ResultWriter::Step ResultWriter::send(Cycle limit, Cycle earliest) {
  const auto place = std::min_element(acknowledged_.begin(), acknowledged_.end());
  if (*place == kNever) return Step::kNothing;
  const Cycle cycle = PortStalls::free_from(stalls_, Port::kWrite, pipeline_, std::max(earliest, *place + 1));
  if (cycle >= limit) return Step::kNothing;
  *place = kNever;
  const uint64_t number = static_cast<uint64_t>(counts_.bursts++) * static_cast<uint64_t>(pipelines_) +
                          static_cast<uint64_t>(pipeline_);
  counts_.bytes += burst_bytes_;
  filled_ = 0;
  last_cycle_ = cycle;
  memory_.send({cycle, pipeline_, true, static_cast<int>(place - acknowledged_.begin()), first_ray_,
                burst_bytes_, base_ + number * static_cast<uint64_t>(burst_bytes_), this});
  return Step::kSent;
}

void ResultWriter::respond(int slot, Cycle response) {
  acknowledged_[static_cast<size_t>(slot)] = response;
  counts_.last_acknowledged = std::max(counts_.last_acknowledged, response);
}

bool ResultWriter::idle() const {
  return queue_.empty() && filled_ == 0 &&
         std::find(acknowledged_.begin(), acknowledged_.end(), kNever) == acknowledged_.end();
}

int ResultWriter::unacknowledged() const {
  return static_cast<int>(std::count(acknowledged_.begin(), acknowledged_.end(), kNever));
}

}  // namespace cuesta
