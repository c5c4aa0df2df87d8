#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <deque>
#include <systemc>
#include <tlm>

#include "models/rays/hit.h"

namespace cuesta::systemc {

/// The initiator side of hits_out: writes each hit record, 32 bytes, at its time or as soon after it as the sink has
/// taken the one before, by b_transport; record n at address 32 n. The socket may stay unbound.
class HitsOut : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(HitsOut);
  tlm_utils::simple_initiator_socket_optional<HitsOut> socket{"socket"};

  explicit HitsOut(const sc_core::sc_module_name& name);

  bool bound() const { return socket.size() != 0; }
  /// Starts to number from 0.
  void reset() { next_ = 0; }
  /// Calls come in the order of time.
  void send(const HitRecord& hit, const sc_core::sc_time& at);
  /// Records that the sink has not taken.
  size_t waiting() const { return queue_.size(); }
  uint64_t sent() const { return next_; }

 private:
  void run();

  struct Queued {
    HitRecord hit;
    sc_core::sc_time at;
  };
  std::deque<Queued> queue_;
  uint64_t next_ = 0;
  sc_core::sc_event more_;
};

}  // namespace cuesta::systemc
