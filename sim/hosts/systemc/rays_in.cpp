#include "sim/hosts/systemc/rays_in.h"

#include <cstring>

#include "traces/rays_format.h"

namespace cuesta::systemc {

RaysIn::RaysIn(const sc_core::sc_module_name& name, Calls calls)
    : sc_core::sc_module(name), calls_(std::move(calls)) {
  socket.register_b_transport(this, &RaysIn::b_transport);
}

void RaysIn::b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  wait(delay);  // a ray arrives at its time, not before
  delay = sc_core::SC_ZERO_TIME;
  payload.set_response_status(take(payload));
}

tlm::tlm_response_status RaysIn::take(tlm::tlm_generic_payload& payload) {
  const uint64_t address = payload.get_address();
  const unsigned bytes = payload.get_data_length();
  if (address != kRayRecords && address != kEndOfRays && address != kStatus) {
    return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  }
  if (payload.get_command() != (address == kStatus ? tlm::TLM_READ_COMMAND : tlm::TLM_WRITE_COMMAND)) {
    return tlm::TLM_COMMAND_ERROR_RESPONSE;
  }
  if (payload.get_byte_enable_ptr() != nullptr) return tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE;
  if (address == kRayRecords ? bytes == 0 || bytes % rays_format::kRecordBytes != 0 : bytes != 4) {
    return tlm::TLM_BURST_ERROR_RESPONSE;
  }
  if (address == kStatus) {
    const uint32_t done = calls_.done() ? 1 : 0;
    std::memcpy(payload.get_data_ptr(), &done, 4);
    return tlm::TLM_OK_RESPONSE;
  }
  if (!calls_.open()) return tlm::TLM_GENERIC_ERROR_RESPONSE;
  if (address == kEndOfRays) {
    calls_.end();
    return tlm::TLM_OK_RESPONSE;
  }
  while (calls_.full()) wait(room);
  for (size_t at = 0; at < bytes; at += rays_format::kRecordBytes) {
    calls_.ray(rays_format::decode_record(payload.get_data_ptr() + at));
  }
  return tlm::TLM_OK_RESPONSE;
}

}  // namespace cuesta::systemc
