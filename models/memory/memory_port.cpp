#include "models/memory/memory_port.h"

#include <algorithm>
#include <tuple>

namespace cuesta {

void MemoryPort::serve_until(Cycle limit) {
  if (waiting_.empty()) return;
  std::sort(waiting_.begin(), waiting_.end(), [](const Request& a, const Request& b) {
    return std::tie(a.leaves, a.pipeline, a.write) < std::tie(b.leaves, b.pipeline, b.write);
  });
  size_t served = 0;
  while (served < waiting_.size() && waiting_[served].leaves < limit) serve(waiting_[served++]);
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(served));
}

void MemoryPort::serve(const Request& request) {
  const Dram::Served served =
      dram_.serve(request.leaves + request_latency_, request.address, request.bytes, request.write);
  MemoryCost& cost = costs_[request.owner];
  (request.write ? cost.write_bytes : cost.read_bytes) += static_cast<uint32_t>(request.bytes);
  cost.bus_clocks += static_cast<uint32_t>(served.bus_clocks);
  cost.row_activations += served.row != Dram::Row::kHit;
  request.client->respond(request.slot, served.response);
}

}  // namespace cuesta
