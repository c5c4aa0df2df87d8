#pragma once

#include <tlm_utils/peq_with_get.h>
#include <tlm_utils/simple_initiator_socket.h>
#include <deque>
#include <functional>
#include <memory>
#include <systemc>
#include <tlm>
#include <vector>

#include "models/common/error.h"
#include "models/units/memory/memory_port.h"
#include "sim/hosts/systemc/memory_tag.h"
#include "sim/hosts/systemc/shell_parameters.h"

namespace cuesta::systemc {

/// The machine's way to memory: each request leaves at its time, or as soon after it as the target has accepted the
/// one before. Reads carry line_bytes, writes burst_bytes, the data being the pyramid image and hit records.
class MemoryOut : public sc_core::sc_module, private tlm::tlm_mm_interface {
 public:
  SC_HAS_PROCESS(MemoryOut);
  tlm_utils::simple_initiator_socket<MemoryOut> socket{"socket"};

  /// Called with a request's tag and the time at which its response is there.
  using Answered = std::function<void(const MemoryTag& tag, const sc_core::sc_time& at)>;
  /// Called with a fault that ends the run.
  using Failed = std::function<void(const Error& error)>;

  MemoryOut(const sc_core::sc_module_name& name, const ShellParameters& parameters, Answered answered,
            Failed failed);
  ~MemoryOut() override;

  /// Takes a new image, and loads it where that was asked for. Throws usage_error when the memory does not take it.
  void load(std::vector<std::byte> image, int granule_bytes);
  /// `data`: of a write. Calls come in the order of time and of the requests.
  void send(uint64_t number, const MemoryRequest& request, const sc_core::sc_time& at, const uint8_t* data);

  size_t waiting() const { return queue_.size(); }
  size_t in_flight() const { return in_flight_; }
  bool request_phase() const { return in_request_ != nullptr; }
  uint64_t last_address() const { return last_address_; }

 private:
  using Payload = tlm::tlm_generic_payload;
  struct Queued {
    sc_core::sc_time at;
    Payload* payload;
  };
  struct Worker {
    sc_core::sc_event go;
    Payload* payload = nullptr;
  };

  void send_requests();
  void begin_request(Payload& payload);
  void end_request(const sc_core::sc_time& delay);
  tlm::tlm_sync_enum nb_transport_bw(Payload& payload, tlm::tlm_phase& phase, sc_core::sc_time& delay);
  void end_responses();
  void hand_to_worker(Payload& payload);
  void work(Worker& worker);
  void respond(Payload& payload, const sc_core::sc_time& at);
  bool wrong_bytes(const Payload& payload) const;
  void free(Payload* payload) override { free_.push_back(payload); }

  ShellParameters parameters_;
  Answered answered_;
  Failed failed_;
  std::vector<std::byte> image_;
  int granule_bytes_ = 0;
  std::deque<Queued> queue_;
  Payload* in_request_ = nullptr;  ///< between BEGIN_REQ and END_REQ
  sc_core::sc_time not_before_;    ///< when the last request was accepted
  size_t in_flight_ = 0;
  uint64_t last_address_ = 0;
  sc_core::sc_event send_;
  tlm_utils::peq_with_get<Payload> end_responses_{"responses_to_end"};
  std::vector<std::unique_ptr<Worker>> workers_;
  std::vector<Worker*> idle_;
  std::vector<std::unique_ptr<Payload>> payloads_;
  std::vector<std::unique_ptr<std::vector<uint8_t>>> buffers_;
  std::vector<Payload*> free_;
};

}  // namespace cuesta::systemc
