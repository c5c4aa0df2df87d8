#include "sim/hosts/systemc/memory_out.h"

#include <algorithm>
#include <cstring>

#include "models/common/error.h"

namespace cuesta::systemc {

namespace {

std::string text_of(const MemoryTag& tag, uint64_t address) {
  return std::string(tag.write ? "the write" : "the read") + " at address " + std::to_string(address) + " (" +
         (tag.write ? "result_writer[" : "height_l1[") + std::to_string(tag.pipeline) + "], " +
         (tag.write ? "burst place " : "MSHR ") + std::to_string(tag.slot) + ")";
}

}  // namespace

MemoryOut::MemoryOut(const sc_core::sc_module_name& name, const ShellParameters& parameters,
                     Answered answered, Failed failed)
    : sc_core::sc_module(name),
      parameters_(parameters),
      answered_(std::move(answered)),
      failed_(std::move(failed)) {
  socket.register_nb_transport_bw(this, &MemoryOut::nb_transport_bw);
  SC_METHOD(send_requests);
  sensitive << send_;
  dont_initialize();
  SC_METHOD(end_responses);
  sensitive << end_responses_.get_event();
  dont_initialize();
}

MemoryOut::~MemoryOut() = default;

void MemoryOut::load(std::vector<std::byte> image, int granule_bytes) {
  const auto granule = static_cast<size_t>(granule_bytes);
  image.resize((image.size() + granule - 1) / granule * granule);  // the last line is read whole
  image_ = std::move(image);
  granule_bytes_ = granule_bytes;
  for (size_t k = 0; k < payloads_.size(); ++k) {
    buffers_[k]->resize(granule);
    payloads_[k]->set_data_ptr(buffers_[k]->data());
  }
  if (parameters_.memory_bytes != MemoryBytes::kLoadAndCheck) return;
  Payload payload;
  payload.set_command(tlm::TLM_WRITE_COMMAND);
  for (size_t done = 0; done < image_.size();) {
    const auto count = static_cast<unsigned>(std::min<size_t>(image_.size() - done, 1 << 20));
    payload.set_address(parameters_.memory_base + done);
    payload.set_data_ptr(reinterpret_cast<unsigned char*>(image_.data() + done));
    payload.set_data_length(count);
    payload.set_streaming_width(count);
    payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
    const unsigned taken = socket->transport_dbg(payload);
    if (taken != count) {
      throw usage_error("The memory at " + std::string(name()) + " took " + std::to_string(taken) + " of " +
                        std::to_string(count) + " bytes of the pyramid image at address " +
                        std::to_string(payload.get_address()) +
                        " by the debug transport; accepted are a memory that takes all, or "
                        "ShellParameters::memory_bytes = kCheck or kIgnore.");
    }
    done += count;
  }
}

void MemoryOut::send(uint64_t number, const MemoryRequest& request, const sc_core::sc_time& at,
                     const uint8_t* data) {
  if (free_.empty()) {
    free_.push_back(
        payloads_.emplace_back(std::make_unique<Payload>(static_cast<tlm::tlm_mm_interface*>(this))).get());
    free_.back()->set_extension(new MemoryTag);  // the payload owns it
    buffers_.push_back(std::make_unique<std::vector<uint8_t>>(static_cast<size_t>(granule_bytes_)));
    free_.back()->set_data_ptr(buffers_.back()->data());
  }
  Payload& payload = *free_.back();
  free_.pop_back();
  payload.acquire();
  MemoryTag& tag = *payload.get_extension<MemoryTag>();
  tag.pipeline = request.pipeline;
  tag.write = request.write;
  tag.slot = request.slot;
  tag.number = number;
  tag.bus_clocks = tag.row_activations = 0;
  const auto bytes = static_cast<unsigned>(request.bytes);
  payload.set_command(request.write ? tlm::TLM_WRITE_COMMAND : tlm::TLM_READ_COMMAND);
  payload.set_address(parameters_.memory_base + request.address);
  payload.set_data_length(bytes);
  payload.set_streaming_width(bytes);
  payload.set_byte_enable_ptr(nullptr);
  payload.set_dmi_allowed(false);
  payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  if (data != nullptr) {
    std::memcpy(payload.get_data_ptr(), data, bytes);
  } else {
    std::memset(payload.get_data_ptr(), 0xA5, bytes);  // what a memory leaves as it was is not the image
  }
  ++in_flight_;
  queue_.push_back({at, &payload});
  if (queue_.size() == 1 && in_request_ == nullptr) {
    const sc_core::sc_time first = std::max(at, not_before_);
    send_.notify(std::max(first, sc_core::sc_time_stamp()) - sc_core::sc_time_stamp());
  }
}

void MemoryOut::send_requests() {
  while (!queue_.empty() && in_request_ == nullptr) {
    const sc_core::sc_time at = std::max(queue_.front().at, not_before_);
    if (at > sc_core::sc_time_stamp()) {
      send_.notify(at - sc_core::sc_time_stamp());
      return;
    }
    Payload& payload = *queue_.front().payload;
    queue_.pop_front();
    last_address_ = payload.get_address();
    if (parameters_.memory_protocol == MemoryProtocol::kBlocking) {
      hand_to_worker(payload);
      send_.notify(sc_core::SC_ZERO_TIME);  // the next one a delta cycle later: calls begin in order
      return;
    }
    begin_request(payload);
  }
}

void MemoryOut::begin_request(Payload& payload) {
  tlm::tlm_phase phase = tlm::BEGIN_REQ;
  sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
  in_request_ = &payload;
  switch (socket->nb_transport_fw(payload, phase, delay)) {
    case tlm::TLM_ACCEPTED:
      return;
    case tlm::TLM_COMPLETED:
      end_request(delay);
      respond(payload, sc_core::sc_time_stamp() + delay);
      return payload.release();
    case tlm::TLM_UPDATED:
      end_request(delay);
      if (phase != tlm::BEGIN_RESP) return;
      respond(payload, sc_core::sc_time_stamp() + delay);
      end_responses_.notify(payload, delay);
  }
}

void MemoryOut::end_request(const sc_core::sc_time& delay) {
  in_request_ = nullptr;
  not_before_ = sc_core::sc_time_stamp() + delay;
}

tlm::tlm_sync_enum MemoryOut::nb_transport_bw(Payload& payload, tlm::tlm_phase& phase,
                                              sc_core::sc_time& delay) {
  if (phase == tlm::END_REQ) {
    if (in_request_ != &payload) return tlm::TLM_ACCEPTED;
    end_request(delay);
    send_.notify(delay);
    return tlm::TLM_ACCEPTED;
  }
  if (phase != tlm::BEGIN_RESP) return tlm::TLM_ACCEPTED;
  if (in_request_ == &payload) {  // BEGIN_RESP stands for END_REQ, too
    end_request(delay);
    send_.notify(delay);
  }
  respond(payload, sc_core::sc_time_stamp() + delay);
  phase = tlm::END_RESP;
  payload.release();
  return tlm::TLM_COMPLETED;
}

/// The END_RESP of responses that came with the return of BEGIN_REQ.
void MemoryOut::end_responses() {
  while (Payload* payload = end_responses_.get_next_transaction()) {
    tlm::tlm_phase phase = tlm::END_RESP;
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket->nb_transport_fw(*payload, phase, delay);
    payload->release();
  }
}

void MemoryOut::hand_to_worker(Payload& payload) {
  if (idle_.empty()) {
    Worker& worker = *workers_.emplace_back(std::make_unique<Worker>());
    idle_.push_back(&worker);
    sc_core::sc_spawn_options options;
    options.dont_initialize();
    options.set_sensitivity(&worker.go);
    sc_core::sc_spawn([this, &worker] { work(worker); }, sc_core::sc_gen_unique_name("request"), &options);
  }
  Worker& worker = *idle_.back();
  idle_.pop_back();
  worker.payload = &payload;
  worker.go.notify(sc_core::SC_ZERO_TIME);
}

void MemoryOut::work(Worker& worker) {
  for (;;) {
    while (worker.payload == nullptr) wait(worker.go);
    Payload& payload = *worker.payload;
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket->b_transport(payload, delay);
    respond(payload, sc_core::sc_time_stamp() + delay);
    payload.release();
    worker.payload = nullptr;
    idle_.push_back(&worker);
  }
}

void MemoryOut::respond(Payload& payload, const sc_core::sc_time& at) {
  --in_flight_;
  const MemoryTag& tag = *payload.get_extension<MemoryTag>();
  if (payload.is_response_error()) {
    return failed_(Error(ExitCode::kMismatch, "The memory at " + std::string(name()) + " answered " +
                                                  text_of(tag, payload.get_address()) + " with " +
                                                  payload.get_response_string() +
                                                  "; accepted is TLM_OK_RESPONSE."));
  }
  if (!tag.write && parameters_.memory_bytes != MemoryBytes::kIgnore && wrong_bytes(payload)) {
    return failed_(Error(ExitCode::kMismatch, "The memory at " + std::string(name()) + " answered " +
                                                  text_of(tag, payload.get_address()) + " with " +
                                                  std::to_string(payload.get_data_length()) +
                                                  " bytes that are not the pyramid's."));
  }
  answered_(tag, at);
}

bool MemoryOut::wrong_bytes(const Payload& payload) const {
  const uint64_t offset = payload.get_address() - parameters_.memory_base;
  return std::memcmp(image_.data() + offset, payload.get_data_ptr(), payload.get_data_length()) != 0;
}

}  // namespace cuesta::systemc
