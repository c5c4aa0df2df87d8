#pragma once

#include <tlm_utils/simple_target_socket.h>
#include <functional>
#include <span>
#include <systemc>
#include <tlm>

#include "models/rays/traced_ray.h"
#include "sim/hosts/systemc/shell_parameters.h"

namespace cuesta::systemc {

/// The target side of rays_in: takes ray records and the end of the trace, says when all is done. Misuse is answered
/// by TLM's error responses: address, command, burst (not whole records), byte enables.
class RaysIn : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<RaysIn> socket{"socket"};

  struct Calls {
    std::function<bool()> full;  ///< no more rays now: the initiator waits for `room`
    std::function<void(const TracedRay&)> ray;
    std::function<void()> end;
    std::function<bool()> open;  ///< rays may come: a machine is there and the trace has not ended
    std::function<bool()> done;
  };

  RaysIn(const sc_core::sc_module_name& name, Calls calls);

  sc_core::sc_event room;  ///< notified by the machine

 private:
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  tlm::tlm_response_status take(tlm::tlm_generic_payload& payload);

  Calls calls_;
};

}  // namespace cuesta::systemc
