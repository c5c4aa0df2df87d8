#include "sim/hosts/systemc/dram_target.h"

#include <algorithm>
#include <cstring>

#include "sim/hosts/systemc/memory_tag.h"

namespace cuesta::systemc {

DramTarget::DramTarget(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
  socket.register_nb_transport_fw(this, &DramTarget::nb_transport_fw);
  socket.register_b_transport(this, &DramTarget::b_transport);
  socket.register_transport_dbg(this, &DramTarget::transport_dbg);
  SC_METHOD(send_responses);
  sensitive << respond_;
  dont_initialize();
}

void DramTarget::load(const Architecture& architecture, const MachineClock& clock) {
  parameters_ = architecture.dram;
  dram_ = std::make_unique<Dram>(
      parameters_, std::max(architecture.height_l1.line_bytes, architecture.result_writer.burst_bytes));
  clock_ = std::make_unique<MachineClock>(clock);
  bytes_.clear();
}

tlm::tlm_sync_enum DramTarget::nb_transport_fw(Payload& payload, tlm::tlm_phase& phase,
                                               sc_core::sc_time& delay) {
  if (phase == tlm::END_RESP) {
    in_response_ = false;
    respond_.notify(delay);
    return tlm::TLM_COMPLETED;
  }
  payload.acquire();
  const sc_core::sc_time at = serve(payload, sc_core::sc_time_stamp() + delay);
  responses_[{at, served_++}] = &payload;
  if (!in_response_) respond_.notify(responses_.begin()->first.first - sc_core::sc_time_stamp());
  phase = tlm::END_REQ;
  return tlm::TLM_UPDATED;
}

void DramTarget::b_transport(Payload& payload, sc_core::sc_time& delay) {
  const sc_core::sc_time at = serve(payload, sc_core::sc_time_stamp() + delay);
  delay = at - sc_core::sc_time_stamp();
}

sc_core::sc_time DramTarget::serve(Payload& payload, const sc_core::sc_time& at) {
  // The socket's time counts the way back as well: dram has the request response_latency_cycles earlier.
  const Cycle arrival = clock_->cycle_from(at) - parameters_.response_latency_cycles;
  const Dram::Served served =
      dram_->serve(arrival, payload.get_address(), static_cast<int>(payload.get_data_length()),
                   payload.get_command() == tlm::TLM_WRITE_COMMAND);
  if (auto* tag = payload.get_extension<MemoryTag>()) {
    tag->bus_clocks = served.bus_clocks;
    tag->row_activations = served.row != Dram::Row::kHit;
  }
  copy_bytes(payload);
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
  return clock_->time_of(served.response);
}

void DramTarget::send_responses() {
  while (!in_response_ && !responses_.empty()) {
    const auto first = responses_.begin();
    if (first->first.first > sc_core::sc_time_stamp()) {
      respond_.notify(first->first.first - sc_core::sc_time_stamp());
      return;
    }
    Payload& payload = *first->second;
    responses_.erase(first);
    tlm::tlm_phase phase = tlm::BEGIN_RESP;
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    const tlm::tlm_sync_enum sync = socket->nb_transport_bw(payload, phase, delay);
    in_response_ = sync == tlm::TLM_ACCEPTED;
    payload.release();
  }
}

unsigned DramTarget::transport_dbg(Payload& payload) {
  copy_bytes(payload);
  return payload.get_data_length();
}

void DramTarget::copy_bytes(Payload& payload) {
  const size_t address = payload.get_address(), count = payload.get_data_length();
  if (payload.get_command() == tlm::TLM_WRITE_COMMAND) {
    if (bytes_.size() < address + count) bytes_.resize(address + count);
    std::memcpy(bytes_.data() + address, payload.get_data_ptr(), count);
    return;
  }
  const size_t known = address < bytes_.size() ? std::min(count, bytes_.size() - address) : 0;
  std::memcpy(payload.get_data_ptr(), bytes_.data() + address, known);
  std::memset(payload.get_data_ptr() + known, 0, count - known);
}

}  // namespace cuesta::systemc
