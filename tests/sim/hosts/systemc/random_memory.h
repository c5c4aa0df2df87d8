#pragma once

#include <tlm.h>
#include <tlm_utils/peq_with_get.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstring>
#include <deque>
#include <systemc>
#include <vector>

#include "models/common/random.h"

namespace cuesta::systemc {

/// A memory that takes every freedom of the base protocol at random: accepts at once, late, or not before it responds;
/// answers with the return of the call, or later, in any order; delays annotated or waited for.
class RandomMemory : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(RandomMemory);
  tlm_utils::simple_target_socket<RandomMemory> socket{"socket"};
  int most_delay_ns;
  int64_t corrupt_read = -1;  ///< this read, counted from 0, returns a wrong byte
  int64_t silent_from = -1;   ///< this transaction and all later ones are never answered
  int64_t refuse = -1;        ///< this transaction gets an error response
  int64_t taken = 0, reads = 0;

  RandomMemory(const sc_core::sc_module_name& name, uint64_t seed, int delay_ns)
      : sc_core::sc_module(name), most_delay_ns(delay_ns), random_(seed) {
    socket.register_nb_transport_fw(this, &RandomMemory::forward);
    socket.register_transport_dbg(this, &RandomMemory::debug);
    SC_METHOD(accept);
    sensitive << accepts_.get_event();
    dont_initialize();
    SC_METHOD(ready);
    sensitive << answers_.get_event();
    dont_initialize();
  }

 private:
  using Payload = tlm::tlm_generic_payload;

  sc_core::sc_time some_time() {
    return {static_cast<double>(random_.below(static_cast<uint64_t>(most_delay_ns) + 1)), sc_core::SC_NS};
  }

  unsigned debug(Payload& p) {
    const size_t address = p.get_address(), count = p.get_data_length();
    if (bytes_.size() < address + count) bytes_.resize(address + count);
    if (p.is_read()) std::memcpy(p.get_data_ptr(), &bytes_[address], count);
    if (p.is_write()) std::memcpy(&bytes_[address], p.get_data_ptr(), count);
    return p.get_data_length();
  }

  void serve(Payload& p) {
    debug(p);
    p.set_response_status(taken == refuse ? tlm::TLM_GENERIC_ERROR_RESPONSE : tlm::TLM_OK_RESPONSE);
    if (p.is_read() && reads++ == corrupt_read) p.get_data_ptr()[3] ^= 1;
  }

  tlm::tlm_sync_enum forward(Payload& p, tlm::tlm_phase& phase, sc_core::sc_time& delay) {
    if (phase == tlm::END_RESP) {
      in_response_ = false;
      send();
      return tlm::TLM_COMPLETED;
    }
    const bool silent = silent_from >= 0 && taken >= silent_from;
    if (silent) {
      p.acquire();
      phase = tlm::END_REQ;
      return tlm::TLM_UPDATED;
    }
    serve(p);
    ++taken;
    const uint64_t way = random_.below(5);
    if (way == 0) {  // all at once
      delay += some_time();
      return tlm::TLM_COMPLETED;
    }
    if (way == 1 && !in_response_) {  // the response with the return
      delay += some_time();
      phase = tlm::BEGIN_RESP;
      in_response_ = true;
      return tlm::TLM_UPDATED;
    }
    p.acquire();
    if (way == 2) {  // accepted with the return
      delay += some_time();
      phase = tlm::END_REQ;
      answers_.notify(p, delay + some_time());
      return tlm::TLM_UPDATED;
    }
    if (way == 3) {  // accepted later
      accepts_.notify(p, some_time());
    } else {  // accepted by the response
      answers_.notify(p, some_time());
    }
    return tlm::TLM_ACCEPTED;
  }

  void accept() {
    while (Payload* p = accepts_.get_next_transaction()) {
      tlm::tlm_phase phase = tlm::END_REQ;
      sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
      socket->nb_transport_bw(*p, phase, delay);
      answers_.notify(*p, some_time());
    }
  }

  void ready() {
    while (Payload* p = answers_.get_next_transaction()) ready_.push_back(p);
    send();
  }

  void send() {
    while (!in_response_ && !ready_.empty()) {
      Payload* p = ready_.front();
      ready_.pop_front();
      tlm::tlm_phase phase = tlm::BEGIN_RESP;
      sc_core::sc_time delay = random_.chance(0.3) ? some_time() : sc_core::SC_ZERO_TIME;
      in_response_ = true;
      if (socket->nb_transport_bw(*p, phase, delay) != tlm::TLM_ACCEPTED) in_response_ = false;
      p->release();
    }
  }

  Random random_;
  std::vector<unsigned char> bytes_;
  tlm_utils::peq_with_get<Payload> accepts_{"accepts"}, answers_{"answers"};
  std::deque<Payload*> ready_;
  bool in_response_ = false;
};

}  // namespace cuesta::systemc
