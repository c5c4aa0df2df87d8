#pragma once

#include <cstddef>
#include <cstdint>

#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// What requests to memory cost the ray that owns them.
struct MemoryCost {
  uint32_t read_bytes = 0;
  uint32_t write_bytes = 0;
  uint32_t bus_clocks = 0;
  uint32_t row_activations = 0;
};

/// A master of a memory level, as the level sees it: who is told when an answer lands.
class MemoryClient {
 public:
  /// Takes the answer to the request of `slot`, which reaches this client in cycle `response`.
  virtual void respond(int slot, Cycle response) = 0;
  /// Returns the cycle in which an answer of `response` would land.
  virtual Cycle earliest(Cycle response) const { return response; }
  /// Sends what leaves before `limit`, so that a later request of somebody else is not served first.
  virtual void catch_up(Cycle limit) { (void)limit; }

 protected:
  ~MemoryClient() = default;
};

struct MemoryRequest {
  Cycle leaves;
  int32_t pipeline;
  bool write;
  int32_t slot;    ///< read: the MSHR; write: the place among the outstanding bursts
  uint32_t owner;  ///< ray, position in the machine's order
  int32_t bytes;
  uint64_t address;
  MemoryClient* client;
};

/// The contract of everything that stands below a cache or a writer: it takes requests now and answers later, in any
/// order. dram, a memory outside of the machine, and a shared cache (itself a master of the level below it) are such.
///
/// A machine advances in windows. In each, all requests that leave in it are made, in the order in which they leave
/// (MemoryPort sees to that); then `settle` lets the level decide what they settle. No answer to a request may land in
/// the window in which the request leaves: a window is at most as long as the way to the level and back.
class MemoryLevel {
 public:
  MemoryLevel() = default;
  virtual ~MemoryLevel() = default;
  MemoryLevel(const MemoryLevel&) = delete;
  MemoryLevel& operator=(const MemoryLevel&) = delete;

  /// Takes a request. The answer goes to `request.client`: within this call where it is known at once, else later.
  virtual void request(const MemoryRequest& request) = 0;
  /// Learns that every request that leaves before `limit` was made, and answers what no later one can change.
  virtual void settle(Cycle limit) { (void)limit; }
  /// Hands over the answers that land before `limit`, as far as they were held back: called before the masters go on
  /// to `limit`.
  virtual void deliver_until(Cycle limit) { (void)limit; }
  /// Returns how many requests wait for their answer, or their answer for being handed over.
  virtual size_t in_flight() const { return 0; }
};

}  // namespace cuesta
