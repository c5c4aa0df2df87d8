#include "models/units/memory/memory_port.h"

#include <algorithm>
#include <tuple>

namespace cuesta {

void MemoryPort::serve_until(Cycle limit) {
  if (waiting_.empty()) return;
  std::sort(waiting_.begin(), waiting_.end(), [](const MemoryRequest& a, const MemoryRequest& b) {
    return std::tie(a.leaves, a.pipeline, a.write) < std::tie(b.leaves, b.pipeline, b.write);
  });
  size_t served = 0;
  while (served < waiting_.size() && waiting_[served].leaves < limit) serve(waiting_[served++]);
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(served));
}

void MemoryPort::serve(const MemoryRequest& request) {
  MemoryCost& cost = costs_[request.owner];
  (request.write ? cost.write_bytes : cost.read_bytes) += static_cast<uint32_t>(request.bytes);
  if (outside_ != nullptr) return hand_over(request);
  const Dram::Served served =
      dram_->serve(request.leaves + request_latency_, request.address, request.bytes, request.write);
  cost.bus_clocks += static_cast<uint32_t>(served.bus_clocks);
  cost.row_activations += served.row != Dram::Row::kHit;
  request.client->respond(request.slot, served.response);
}

void MemoryPort::hand_over(const MemoryRequest& request) {
  (request.write ? counts_.writes : counts_.reads) += 1;
  (request.write ? counts_.write_bytes : counts_.read_bytes) += request.bytes;
  in_flight_.push_back({next_number_, request.client, request.slot, request.owner, kNever});
  outside_->request(next_number_++, request);
}

void MemoryPort::answer(uint64_t number, Cycle response, int bus_clocks, int row_activations) {
  const auto found = std::lower_bound(in_flight_.begin(), in_flight_.end(), number,
                                      [](const InFlight& a, uint64_t b) { return a.number < b; });
  found->response = response;
  costs_[found->owner].bus_clocks += static_cast<uint32_t>(bus_clocks);
  costs_[found->owner].row_activations += static_cast<uint32_t>(row_activations);
}

void MemoryPort::deliver_until(Cycle limit) {
  std::erase_if(in_flight_, [&](InFlight& request) {
    if (request.response >= limit) return false;
    if (request.client->earliest(request.response) >= limit) {
      request.response = limit;  // every cycle below is taken
      return false;
    }
    request.client->respond(request.slot, request.response);
    return true;
  });
}

}  // namespace cuesta
