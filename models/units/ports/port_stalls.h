#pragma once

#include <cstdint>
#include <iterator>
#include <string_view>

#include "models/common/random.h"

namespace cuesta {

using Cycle = int64_t;

/// Later than anything that happens.
inline constexpr Cycle kNever = INT64_MAX / 4;

/// The ports at which a test can hold a transfer back, in the order of the data's way.
enum class Port : uint8_t {
  kTrace,           ///< trace -> ray_dispatch
  kDispatch,        ///< ray_dispatch's queue -> ray_setup
  kSetup,           ///< ray_setup -> traverse
  kMemoryRequest,   ///< height_l1 -> dram
  kMemoryResponse,  ///< dram -> height_l1
  kHitStream,       ///< traverse -> hit_queue
  kResult,          ///< hit_queue -> result_writer
  kWrite,           ///< result_writer -> dram
};
/// How each is written for a person, in the same order: a new port is a line above and a word here.
inline constexpr std::string_view kPortNames[] = {"trace",           "dispatch",   "setup",  "memory request",
                                                  "memory response", "hit stream", "result", "write"};
inline constexpr int kPortCount = static_cast<int>(std::size(kPortNames));
static_assert(static_cast<int>(Port::kWrite) + 1 == kPortCount);

/// Seeded back-pressure: whether a transfer through a port is held back in a cycle is a pure function of seed,
/// port, pipeline and cycle, so that two models of the machine meet the same stalls whatever order they ask in.
struct PortStalls {
  uint64_t seed = 0;
  uint16_t per_mille[kPortCount] = {};  ///< chance of a stall in a cycle, 0 to 999

  bool blocked(Port port, int pipeline, Cycle cycle) const {
    const int chance = per_mille[static_cast<int>(port)];
    if (chance == 0) return false;
    const uint64_t key = seed ^ (static_cast<uint64_t>(cycle) * 0x9E3779B97F4A7C15ull) ^
                         (static_cast<uint64_t>(pipeline) << 56) ^ (static_cast<uint64_t>(port) << 48);
    return Random::mix(key) % 1000 < static_cast<uint64_t>(chance);
  }

  /// Returns the first cycle >= `cycle` in which the port is free; without stalls (nullptr) `cycle`.
  static Cycle free_from(const PortStalls* stalls, Port port, int pipeline, Cycle cycle) {
    if (stalls != nullptr) {
      while (stalls->blocked(port, pipeline, cycle)) ++cycle;
    }
    return cycle;
  }
};

}  // namespace cuesta
