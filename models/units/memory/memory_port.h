#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "models/units/dram/dram.h"
#include "models/units/ports/port_stalls.h"

namespace cuesta {

/// What a request to dram costs its owner.
struct MemoryCost {
  uint32_t read_bytes = 0;
  uint32_t write_bytes = 0;
  uint32_t bus_clocks = 0;
  uint32_t row_activations = 0;
};

/// Who is told when a request's response lands.
class MemoryClient {
 public:
  /// `slot` as given with the request; `response` is the cycle in which dram's answer reaches the client.
  virtual void respond(int slot, Cycle response) = 0;
  /// The cycle in which an answer of `response` would land.
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

/// A memory in the place of dram. It gets the requests in the order in which dram would serve them, each with a
/// number that grows by one, and answers by MemoryPort::answer, in any order.
class OutsideMemory {
 public:
  virtual void request(uint64_t number, const MemoryRequest& request) = 0;

 protected:
  ~OutsideMemory() = default;
};

/// The way from height_l1 and result_writer to dram: puts requests into the order of arrival.
///
/// dram serves in the order (cycle, pipeline, read before write). With one pipeline and no held-back ports the
/// requests come in that order and are served at once; otherwise they are kept and `serve_until` serves them,
/// window by window; a window is never longer than the way to dram and back.
class MemoryPort {
 public:
  struct Counts {
    int64_t reads = 0, writes = 0, read_bytes = 0, write_bytes = 0;
  };

  MemoryPort(Dram& dram, int request_latency_cycles, bool at_once, std::vector<MemoryCost>& costs)
      : dram_(&dram), request_latency_(request_latency_cycles), at_once_(at_once), costs_(costs) {}
  MemoryPort(OutsideMemory& outside, std::vector<MemoryCost>& costs)
      : outside_(&outside), request_latency_(0), at_once_(false), costs_(costs) {}

  /// In the at-once form: the other client, which must not be overtaken by a read.
  void set_writer(MemoryClient* writer) { writer_ = writer; }

  void send(const MemoryRequest& request) {
    if (!at_once_) {
      waiting_.push_back(request);
      return;
    }
    if (!request.write && writer_ != nullptr) writer_->catch_up(request.leaves);
    serve(request);
  }

  /// Serves all requests that leave before `limit`.
  void serve_until(Cycle limit);

  /// An outside memory's answer to request `number`: reaches the client in cycle `response`. `bus_clocks` and
  /// `row_activations` as far as the memory counts them.
  void answer(uint64_t number, Cycle response, int bus_clocks, int row_activations);
  /// Hands over the answers that land before `limit`. As with dram, an earlier request's fill goes first where two
  /// want to land in one cycle, whatever order the answers came in.
  void deliver_until(Cycle limit);

  /// Requests that an outside memory has not yet answered, or whose answers were not yet handed over.
  size_t in_flight() const { return in_flight_.size(); }
  /// What an outside memory was asked for.
  const Counts& outside_counts() const { return counts_; }

 private:
  struct InFlight {
    uint64_t number;
    MemoryClient* client;
    int32_t slot;
    uint32_t owner;
    Cycle response;  ///< kNever: not answered
  };

  void serve(const MemoryRequest& request);
  void hand_over(const MemoryRequest& request);

  Dram* dram_ = nullptr;
  OutsideMemory* outside_ = nullptr;
  int request_latency_;
  bool at_once_;
  MemoryClient* writer_ = nullptr;
  std::vector<MemoryCost>& costs_;
  std::vector<MemoryRequest> waiting_;
  std::vector<InFlight> in_flight_;  ///< in order of their numbers
  uint64_t next_number_ = 0;
  Counts counts_;
};

}  // namespace cuesta
