#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "models/common/random.h"
#include "models/units/memory/outside_memory.h"

namespace cuesta {

/// A memory whose answers come after random times, in any order, and rays that come at random times: pure functions of
/// the seed and of the request's or ray's number.
struct MemoryTiming {
  uint64_t seed = 0;
  int least_cycles = 2, most_cycles = 400;  ///< from a request's leaving to its answer
  int most_gap_cycles = 0;                  ///< between two rays
  // One answer that comes later than it should: a fault, for tests of what compares two machines.
  int64_t late_request = -1;
  int late_cycles = 0;

  Cycle latency(uint64_t request) const {
    const uint64_t range = static_cast<uint64_t>(most_cycles - least_cycles) + 1;
    const auto late = static_cast<int64_t>(request) == late_request ? late_cycles : 0;
    return least_cycles + static_cast<Cycle>(Random::mix(seed + 2 * request) % range) + late;
  }
  Cycle gap_before(uint64_t ray) const {
    return static_cast<Cycle>(Random::mix(seed + 2 * ray + 1) % (static_cast<uint64_t>(most_gap_cycles) + 1));
  }
};

/// dram's place in a hosted CycleMachine, timed by a MemoryTiming.
class RandomMemory final : public OutsideMemory {
 public:
  struct Answer {
    uint64_t number;
    Cycle response;
  };

  /// `window`: of the machine; no answer comes sooner.
  RandomMemory(const MemoryTiming& timing, Cycle window) : timing_(timing), window_(window) {}

  void request(uint64_t number, const MemoryRequest& request) override {
    answers_.push_back({number, request.leaves + std::max(window_, timing_.latency(number))});
  }
  /// Those that the machine was not told yet.
  std::vector<Answer>& answers() { return answers_; }

 private:
  MemoryTiming timing_;
  Cycle window_;
  std::vector<Answer> answers_;
};

}  // namespace cuesta
