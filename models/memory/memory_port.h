#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "models/common/port_stalls.h"
#include "models/memory/dram.h"

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
  /// Sends what leaves before `limit`, so that a later request of somebody else is not served first.
  virtual void catch_up(Cycle limit) { (void)limit; }

 protected:
  ~MemoryClient() = default;
};

/// The way from height_l1 and result_writer to dram: puts requests into the order of arrival.
///
/// dram serves in the order (cycle, pipeline, read before write). With one pipeline and no held-back ports the
/// requests come in that order and are served at once; otherwise they are kept and `serve_until` serves them,
/// window by window; a window is never longer than the way to dram and back.
class MemoryPort {
 public:
  struct Request {
    Cycle leaves;
    int32_t pipeline;
    bool write;
    int32_t slot;
    uint32_t owner;  ///< ray, position in the machine's order
    int32_t bytes;
    uint64_t address;
    MemoryClient* client;
  };

  MemoryPort(Dram& dram, int request_latency_cycles, bool at_once, std::vector<MemoryCost>& costs)
      : dram_(dram), request_latency_(request_latency_cycles), at_once_(at_once), costs_(costs) {}

  /// In the at-once form: the other client, which must not be overtaken by a read.
  void set_writer(MemoryClient* writer) { writer_ = writer; }

  void send(const Request& request) {
    if (!at_once_) {
      waiting_.push_back(request);
      return;
    }
    if (!request.write && writer_ != nullptr) writer_->catch_up(request.leaves);
    serve(request);
  }

  /// Serves all requests that leave before `limit`.
  void serve_until(Cycle limit);

  size_t waiting() const { return waiting_.size(); }

 private:
  void serve(const Request& request);

  Dram& dram_;
  int request_latency_;
  bool at_once_;
  MemoryClient* writer_ = nullptr;
  std::vector<MemoryCost>& costs_;
  std::vector<Request> waiting_;
};

}  // namespace cuesta
