#include "models/units/memory/outside_memory.h"

#include <algorithm>

namespace cuesta {

void OutsideLevel::request(const MemoryRequest& request) {
  MemoryCost& cost = costs_[request.owner];
  (request.write ? cost.write_bytes : cost.read_bytes) += static_cast<uint32_t>(request.bytes);
  (request.write ? counts_.writes : counts_.reads) += 1;
  (request.write ? counts_.write_bytes : counts_.read_bytes) += request.bytes;
  in_flight_.push_back({next_number_, request.client, request.slot, request.owner, kNever});
  outside_.request(next_number_++, request);
}

void OutsideLevel::answer(uint64_t number, Cycle response, int bus_clocks, int row_activations) {
  const auto found = std::lower_bound(in_flight_.begin(), in_flight_.end(), number,
                                      [](const InFlight& a, uint64_t b) { return a.number < b; });
  found->response = response;
  costs_[found->owner].bus_clocks += static_cast<uint32_t>(bus_clocks);
  costs_[found->owner].row_activations += static_cast<uint32_t>(row_activations);
}

void OutsideLevel::deliver_until(Cycle limit) {
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
