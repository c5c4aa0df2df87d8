#include "sim/hosts/systemc/ray_feeder.h"

#include <algorithm>

#include "sim/hosts/systemc/shell_parameters.h"
#include "traces/rays_format.h"

namespace cuesta::systemc {

RayFeeder::RayFeeder(const sc_core::sc_module_name& name) : sc_core::sc_module(name) { SC_THREAD(run); }

void RayFeeder::feed(std::vector<TracedRay> rays) {
  rays_ = std::move(rays);
  waiting_ = true;
  start_.notify(sc_core::SC_ZERO_TIME);
}

void RayFeeder::run() {
  constexpr size_t kRaysPerWrite = 1024;
  std::vector<uint8_t> bytes;
  for (;;) {
    while (!waiting_) wait(start_);
    waiting_ = false;
    for (size_t first = 0; first < rays_.size(); first += kRaysPerWrite) {
      const size_t count = std::min(kRaysPerWrite, rays_.size() - first);
      bytes.resize(count * rays_format::kRecordBytes);
      for (size_t k = 0; k < count; ++k) {
        rays_format::encode_record(rays_[first + k], bytes.data() + k * rays_format::kRecordBytes);
      }
      write(kRayRecords, bytes);
    }
    bytes.assign(4, 0);
    write(kEndOfRays, bytes);
  }
}

void RayFeeder::write(uint64_t address, std::vector<uint8_t>& bytes) {
  tlm::tlm_generic_payload payload;
  payload.set_command(tlm::TLM_WRITE_COMMAND);
  payload.set_address(address);
  payload.set_data_ptr(bytes.data());
  payload.set_data_length(static_cast<unsigned>(bytes.size()));
  payload.set_streaming_width(static_cast<unsigned>(bytes.size()));
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  socket->b_transport(payload, delay);
  wait(delay);
  if (payload.is_response_error()) SC_REPORT_ERROR("cuesta/internal", payload.get_response_string().c_str());
}

}  // namespace cuesta::systemc
