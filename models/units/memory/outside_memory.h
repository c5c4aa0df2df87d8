#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "models/units/dram/counters.h"
#include "models/units/memory/memory_level.h"

namespace cuesta {

/// A memory outside of the machine, in the place of dram. It gets the requests in the order in which dram would serve
/// them, each with a number that grows by one, and answers by OutsideLevel::answer, in any order.
class OutsideMemory {
 public:
  virtual void request(uint64_t number, const MemoryRequest& request) = 0;

 protected:
  ~OutsideMemory() = default;
};

/// The memory level whose timing somebody outside of the machine knows.
class OutsideLevel final : public MemoryLevel {
 public:
  using Counts = DramTraffic;

  /// `costs`: by owner; both must outlive the level.
  OutsideLevel(OutsideMemory& outside, std::vector<MemoryCost>& costs) : outside_(outside), costs_(costs) {}

  void request(const MemoryRequest& request) override;
  /// Takes the answer to request `number`: it reaches the client in cycle `response`. `bus_clocks` and
  /// `row_activations` as far as the memory counts them.
  void answer(uint64_t number, Cycle response, int bus_clocks, int row_activations);
  /// As with dram, an earlier request's fill goes first where two want to land in one cycle, whatever order the answers
  /// came in.
  void deliver_until(Cycle limit) override;
  size_t in_flight() const override { return in_flight_.size(); }

  /// Returns what the memory was asked for.
  const Counts& counts() const { return counts_; }

 private:
  struct InFlight {
    uint64_t number;
    MemoryClient* client;
    int32_t slot;
    uint32_t owner;
    Cycle response;  ///< kNever: not answered
  };

  OutsideMemory& outside_;
  std::vector<MemoryCost>& costs_;
  std::vector<InFlight> in_flight_;  ///< in order of their numbers
  uint64_t next_number_ = 0;
  Counts counts_;
};

}  // namespace cuesta
