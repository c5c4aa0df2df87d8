#pragma once

#include <tlm_utils/simple_target_socket.h>
#include <map>
#include <memory>
#include <systemc>
#include <tlm>
#include <utility>
#include <vector>

#include "models/units/architecture.h"
#include "models/units/dram/dram.h"
#include "sim/hosts/systemc/machine_clock.h"

namespace cuesta::systemc {

/// The machine's own dram (models/units/dram/dram.h) behind a target socket: with it the machine runs cycle for cycle
/// as in the direct host. Four phases: a request is accepted at once, its response begins when dram has the data; two
/// responses of one time begin in the order of their requests. b_transport and the debug transport work as well.
class DramTarget : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(DramTarget);
  tlm_utils::simple_target_socket<DramTarget> socket{"socket"};

  explicit DramTarget(const sc_core::sc_module_name& name);
  /// All banks closed, all bytes 0. `clock`: the machine's.
  void load(const Architecture& architecture, const MachineClock& clock);
  const Dram::Counts& counts() const { return dram_->counts(); }

 private:
  using Payload = tlm::tlm_generic_payload;

  tlm::tlm_sync_enum nb_transport_fw(Payload& payload, tlm::tlm_phase& phase, sc_core::sc_time& delay);
  void b_transport(Payload& payload, sc_core::sc_time& delay);
  unsigned transport_dbg(Payload& payload);
  void send_responses();
  /// The time of the response to a request that comes at `at`.
  sc_core::sc_time serve(Payload& payload, const sc_core::sc_time& at);
  void copy_bytes(Payload& payload);

  DramParameters parameters_;
  std::unique_ptr<Dram> dram_;
  std::unique_ptr<MachineClock> clock_;
  std::vector<unsigned char> bytes_;  ///< up to the highest address written
  /// By time, then by order of service.
  std::map<std::pair<sc_core::sc_time, uint64_t>, Payload*> responses_;
  uint64_t served_ = 0;
  bool in_response_ = false;  ///< between BEGIN_RESP and END_RESP
  sc_core::sc_event respond_;
};

}  // namespace cuesta::systemc
