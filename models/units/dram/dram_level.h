#pragma once

#include <vector>

#include "models/units/dram/dram.h"
#include "models/units/memory/memory_level.h"

namespace cuesta {

/// dram as a memory level: since it serves in the order of arrival, every answer is known with its request.
class DramLevel final : public MemoryLevel {
 public:
  /// `granule_bytes`: as Dram's. `costs`: by owner; they must outlive the level.
  DramLevel(const DramParameters& parameters, int granule_bytes, std::vector<MemoryCost>& costs)
      : dram_(parameters, granule_bytes),
        request_latency_(parameters.request_latency_cycles),
        costs_(costs) {}

  const DramCounts& counts() const { return dram_.counts(); }

  void request(const MemoryRequest& request) override {
    MemoryCost& cost = costs_[request.owner];
    (request.write ? cost.write_bytes : cost.read_bytes) += static_cast<uint32_t>(request.bytes);
    const Dram::Served served =
        dram_.serve(request.leaves + request_latency_, request.address, request.bytes, request.write);
    cost.bus_clocks += static_cast<uint32_t>(served.bus_clocks);
    cost.row_activations += served.row != Dram::Row::kHit;
    request.client->respond(request.slot, served.response);
  }

 private:
  Dram dram_;
  int request_latency_;
  std::vector<MemoryCost>& costs_;
};

}  // namespace cuesta
