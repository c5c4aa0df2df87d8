#include "sim/hosts/systemc/hits_out.h"

#include "models/rays/hit_bytes.h"

namespace cuesta::systemc {

HitsOut::HitsOut(const sc_core::sc_module_name& name) : sc_core::sc_module(name) { SC_THREAD(run); }

void HitsOut::send(const HitRecord& hit, const sc_core::sc_time& at) {
  queue_.push_back({hit, at});
  if (queue_.size() == 1) more_.notify(sc_core::SC_ZERO_TIME);
}

void HitsOut::run() {
  uint8_t bytes[kHitRecordBytes];
  tlm::tlm_generic_payload payload;
  payload.set_command(tlm::TLM_WRITE_COMMAND);
  payload.set_data_ptr(bytes);
  payload.set_data_length(kHitRecordBytes);
  payload.set_streaming_width(kHitRecordBytes);
  for (;;) {
    while (queue_.empty()) wait(more_);
    if (queue_.front().at > sc_core::sc_time_stamp()) wait(queue_.front().at - sc_core::sc_time_stamp());
    encode_hit(queue_.front().hit, bytes);
    payload.set_address(next_++ * kHitRecordBytes);
    payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket->b_transport(payload, delay);
    if (delay != sc_core::SC_ZERO_TIME) wait(delay);
    if (payload.is_response_error())
      SC_REPORT_ERROR("cuesta/mismatch", "The sink of hits_out refused a record.");
    queue_.pop_front();
  }
}

}  // namespace cuesta::systemc
